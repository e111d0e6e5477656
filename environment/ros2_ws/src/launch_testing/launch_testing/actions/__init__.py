"""Actions for tests."""

from launch_testing.actions.ready import ReadyToTest
from launch_testing.actions.test import GTest, PyTest, Test

__all__ = ['GTest', 'PyTest', 'ReadyToTest', 'Test']
