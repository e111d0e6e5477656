"""Tests of a launched system, as fixtures of pytest."""

from launch_pytest import actions, tools
from launch_pytest.fixture import fixture

__all__ = ['actions', 'fixture', 'tools']
