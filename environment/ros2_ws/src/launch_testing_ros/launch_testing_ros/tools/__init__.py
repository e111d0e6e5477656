"""Helpers of tests that compare what ROS programs write."""

from launch_testing_ros.tools.output import basic_output_filter

__all__ = ['basic_output_filter']
