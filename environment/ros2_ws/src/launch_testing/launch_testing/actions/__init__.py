"""Actions for tests."""

from launch_testing.actions.ready import ReadyToTest

__all__ = ['ReadyToTest']
