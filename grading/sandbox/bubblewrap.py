"""The launcher of the sandbox `bubblewrap`: `start` is called by the tests, `start_tests` by the grader."""

import json
import os
import socket
from dataclasses import asdict, dataclass

from grading.sandbox import layout
from helpers.runner.start_processes import LIMITS, Limits

control: socket.socket | None = None  # in a process of tests: to its submission's server of programs


@dataclass
class SandboxedForkServer:
    """The server of a submission's programs, as the tests see it."""

    control: socket.socket
    sandbox: str = 'bubblewrap'
    home_folder: str = str(layout.HOME)

    def close(self) -> None:
        """End the programs and their sandbox. Idempotent."""
        if self.control.fileno() >= 0:
            self.control.shutdown(socket.SHUT_WR)
            self.control.settimeout(10)
            try:
                while self.control.recv(65536):  # until it has ended
                    pass
            except OSError:
                pass
            self.control.close()


def start(domain_id: int, limits: Limits = LIMITS) -> SandboxedForkServer:
    """Get the server of programs that the grader has prepared ready for this process, and for its network."""
    if control is None:
        raise RuntimeError('this launcher works in a process that start_tests has started')
    descriptor = os.pidfd_open(os.getpid())
    socket.send_fds(control, [json.dumps(asdict(limits)).encode()], [descriptor])
    os.close(descriptor)
    return SandboxedForkServer(control)


def start_tests(job, events: int, printed, *, cwd: str, environment: dict[str, str], folders):
    """Start the tests of one submission in a sandbox; see `helpers.runner.start_processes.start_tests`."""
    from grading.sandbox import station

    return station.start_tests(job, events, printed, int(environment['ROS_DOMAIN_ID']), folders)
