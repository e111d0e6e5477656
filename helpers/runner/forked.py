"""Processes that a server has forked (`helpers.runner.warm`): what they do first, and how a client ends them."""

import os
import select
import signal
import socket
import subprocess
import tempfile
from collections.abc import Iterable
from contextlib import suppress


def attend(pid: int, life: socket.socket) -> int:
    """Wait for the end of a child, which is killed if `life` closes before; returns its status, negative for a signal.

    `report` sends that to the client, when all that belongs to the child has ended, too.
    """
    ended = os.pidfd_open(pid)
    sources: list[socket.socket | int] = [ended, life]
    ready, _, _ = select.select(sources, [], [])
    if ended not in ready:
        os.kill(pid, signal.SIGKILL)
    _, status = os.waitpid(pid, 0)
    return os.waitstatus_to_exitcode(status)


def report(life: socket.socket, status: int) -> None:
    """Send a child's status to the client's `Forked`."""
    with suppress(OSError):  # nobody may be there any more
        life.send(str(status).encode())


def stand_alone(output: int, kept: list[int]) -> None:
    """In a forked child: begin a session of its own, with `output` as its standard streams and only `kept` open."""
    close_all_but([output, *kept])
    os.setsid()  # signals to its group, a learner's kill(0) too, reach only itself and what it has started
    with open(os.devnull) as null:
        os.dup2(null.fileno(), 0)
    os.dup2(output, 1)
    os.dup2(output, 2)
    os.close(output)


def move(folder: str, variables: dict[str, str]) -> None:
    """Go to a folder and have other environment variables, also for what asks the C library."""
    os.chdir(folder)
    os.environ.clear()
    os.environ.update(variables)
    tempfile.tempdir = None  # found anew, from the variables


def close_all_but(kept: Iterable[int]) -> None:
    """Close every file descriptor from 3 on except `kept`."""
    begin = 3
    for descriptor in sorted(kept):
        os.closerange(begin, descriptor)
        begin = max(begin, descriptor + 1)
    os.closerange(begin, os.sysconf('SC_OPEN_MAX'))


class Forked:
    """A process that a server has forked, with the methods of subprocess.Popen that a session uses."""

    def __init__(self, life: socket.socket):
        """`life`: the other end of the one that the server's process has (`attend`, `report`)."""
        self._life = life
        self.returncode: int | None = None

    def kill(self) -> None:
        """Kill it and what it has started."""
        with suppress(OSError):
            self._life.shutdown(socket.SHUT_WR)

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the end; returns the status, negative for a signal. Raises subprocess.TimeoutExpired."""
        if self.returncode is None:
            if not select.select([self._life], [], [], timeout)[0]:
                assert timeout is not None  # without one, select waits for the end
                raise subprocess.TimeoutExpired('a forked process', timeout)
            try:
                answer = self._life.recv(64)
            except OSError:
                answer = b''
            self.returncode = int(answer) if answer else -signal.SIGKILL
            self._life.close()
        return self.returncode
