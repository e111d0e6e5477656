"""Descriptions that actions take, under upstream's second name for them."""

from launch_ros.parameter_descriptions import ParameterFile, ParameterValue

__all__ = ['ParameterFile', 'ParameterValue']
