"""The two warm servers of a checker or grader: one forks tests' processes, the other one servers of programs."""

import json
import os
import socket
import subprocess
import sys
from collections.abc import Callable

from helpers.runner.forked import Forked

Start = Callable[[list[str], int], subprocess.Popen]  # starts a command that keeps a file descriptor


class Servers:
    """Both servers (`helpers.runner.warm`), started once for all that is judged."""

    def __init__(self, tests: tuple[str, Start], programs: tuple[str, Start]):
        """For each side its module, and how its server is started."""
        self.owner = os.getpid()
        self._processes: list[subprocess.Popen] = []
        self._tests, self._programs = self._start(*tests), self._start(*programs)

    def _start(self, side: str, start: Start) -> socket.socket:
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)  # keeps message boundaries
        with theirs:
            self._processes.append(
                start([sys.executable, '-m', 'helpers.runner.warm', side, str(theirs.fileno())], theirs.fileno())
            )
        return ours

    def fork(self, tests: dict, programs: dict, job, events: int, printed) -> Forked:
        """Start the tests of one session, and the server of their programs; returns the tests' process.

        `tests` and `programs` are the requests to the sides. `job` is a file, `events` and `printed` take what comes
        out. Raises OSError if a server has ended.
        """
        ours, theirs = socket.socketpair()
        control, other = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs, control, other:
            _ask(self._programs, programs, other.fileno(), printed.fileno())
            _ask(self._tests, tests, job.fileno(), events, printed.fileno(), control.fileno(), theirs.fileno())
        return Forked(ours)

    @property
    def running(self) -> bool:
        """Whether both run, and are this process's."""
        return self.owner == os.getpid() and all(process.poll() is None for process in self._processes)

    def close(self) -> None:
        """End the servers. What they have started goes on to its end."""
        for end in (self._tests, self._programs):
            end.close()
        if self.owner == os.getpid():
            for process in self._processes:
                process.wait()


def _ask(server: socket.socket, request: dict, *descriptors: int) -> None:
    socket.send_fds(server, [json.dumps(request).encode()], descriptors)
