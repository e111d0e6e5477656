"""Helpers of tests: which process is meant, and a process that keeps the launch going."""

import sys

from launch.actions import ExecuteProcess

from launch_testing.util.proc_lookup import NO_CMD_ARGS, NoMatchingProcessException, resolveProcesses

__all__ = ['KeepAliveProc', 'NO_CMD_ARGS', 'NoMatchingProcessException', 'resolveProcesses']


class KeepAliveProc(ExecuteProcess):
    """A process that does nothing, so that the launch does not end before the tests do."""

    def __init__(self):
        super().__init__(cmd=[sys.executable, '-c', _WAIT])


_WAIT = 'import signal, sys; signal.signal(signal.SIGINT, lambda *_: sys.exit()); signal.pause()'
