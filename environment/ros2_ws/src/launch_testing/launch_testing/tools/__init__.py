"""Helpers of tests that start programs while the launch runs, and compare what these write."""

from launch_testing.tools.output import basic_output_filter, expected_output_from_file
from launch_testing.tools.process import ProcessProxy, launch_process
from launch_testing.tools.text import expect_output

__all__ = ['ProcessProxy', 'basic_output_filter', 'expect_output', 'expected_output_from_file', 'launch_process']
