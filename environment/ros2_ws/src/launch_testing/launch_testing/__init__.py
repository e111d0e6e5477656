"""Tests of a launched system: cases of unittest that run while it runs, and cases that run after its end."""

from launch_testing import actions, asserts, event_handlers, markers, tools, util
from launch_testing.io_handler import ActiveIoHandler, IoHandler
from launch_testing.parametrize import parametrize
from launch_testing.post_shutdown_test import post_shutdown_test
from launch_testing.proc_info_handler import ActiveProcInfoHandler, ProcInfoHandler
from launch_testing.ready_to_test_action_timeout import ready_to_test_action_timeout

__all__ = [
    'ActiveIoHandler',
    'ActiveProcInfoHandler',
    'IoHandler',
    'ProcInfoHandler',
    'actions',
    'asserts',
    'event_handlers',
    'markers',
    'parametrize',
    'post_shutdown_test',
    'ready_to_test_action_timeout',
    'tools',
    'util',
]
