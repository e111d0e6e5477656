"""Waiting for processes."""

from launch_pytest.tools import process

__all__ = ['process']
