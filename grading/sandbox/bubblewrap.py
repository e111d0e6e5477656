"""The launcher of the sandbox `bubblewrap`: `start` is called by the tests, `start_tests` by the grader."""

import json
import os
import socket
from dataclasses import asdict

from grading.sandbox import mounts
from helpers.runner.start_processes import LIMITS, Limits, StartedForkServer

control: socket.socket | None = None  # in a process of tests: to its submission's server of programs


def start(domain_id: int, limits: Limits = LIMITS) -> StartedForkServer:
    """Get the server of programs that the grader has prepared ready for this process, and for its network."""
    if control is None:
        raise RuntimeError('this launcher works in a process that start_tests has started')
    descriptor = os.pidfd_open(os.getpid())
    socket.send_fds(control, [json.dumps(asdict(limits)).encode()], [descriptor])
    os.close(descriptor)
    return StartedForkServer(control, 'bubblewrap', str(mounts.HOME))


def start_tests(job, events: int, printed, *, cwd: str, environment: dict[str, str], folders):
    """Start the tests of one submission in a sandbox; see `helpers.runner.tests_process.start_tests`."""
    from grading.sandbox import station

    return station.start_tests(job, events, printed, int(environment['ROS_DOMAIN_ID']), folders)
