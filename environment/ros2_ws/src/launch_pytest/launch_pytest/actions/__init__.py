"""Actions for tests."""

from launch_testing.actions import ReadyToTest

__all__ = ['ReadyToTest']
