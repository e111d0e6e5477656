"""The grader's own side of the sandbox: the two warm servers, started once for all submissions."""

import atexit
import json
import os
import select
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path

from grading.sandbox import control_groups, layout, unprivileged
from helpers.paths import ROOT
from helpers.runner import start_processes


class Station:
    """Both servers; `folders` hold the tests that may be asked for."""

    def __init__(self, folders: tuple[Path, ...]):
        self.owner = os.getpid()
        self._processes, self._sockets = [], {}
        self._leave_group = control_groups.begin(unprivileged.account().pw_uid if os.geteuid() == 0 else None)
        for kind in ('tests', 'programs'):
            ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            with theirs:
                command = [sys.executable, '-m', 'grading.sandbox.warm', kind, str(theirs.fileno())]
                trees = [ROOT, *layout.readable(), *folders]
                self._processes.append(
                    subprocess.Popen(
                        unprivileged.command(command, trees),
                        cwd='/',
                        env=environment(),
                        stdin=subprocess.DEVNULL,
                        pass_fds=[theirs.fileno()],
                        start_new_session=True,
                    )
                )
            self._sockets[kind] = ours

    def ask(self, kind: str, request: dict, *descriptors: int) -> None:
        """Send a request with its file descriptors. Raises OSError when the server has ended."""
        socket.send_fds(self._sockets[kind], [json.dumps(request).encode()], descriptors)

    def close(self) -> None:
        """End the servers and all that they have started."""
        for end in self._sockets.values():
            end.close()
        if os.getpid() == self.owner:
            for process in self._processes:
                process.wait()
            self._leave_group()


class Tests:
    """A running process of tests, with the methods of subprocess.Popen that a session uses."""

    def __init__(self, life: socket.socket):
        self._life = life
        self.returncode: int | None = None

    def kill(self) -> None:
        """Kill the tests and the programs that they test."""
        try:
            self._life.shutdown(socket.SHUT_WR)
        except OSError:
            pass

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the end; returns the status, negative for a signal. Raises subprocess.TimeoutExpired."""
        if self.returncode is None:
            deadline = None if timeout is None else time.monotonic() + timeout
            left = None if deadline is None else max(0.0, deadline - time.monotonic())
            if not select.select([self._life], [], [], left)[0]:
                assert timeout is not None  # without one, select waits for the end
                raise subprocess.TimeoutExpired('tests', timeout)
            try:
                answer = self._life.recv(64)
            except OSError:
                answer = b''
            self.returncode = int(answer) if answer else -9
            self._life.close()
        return self.returncode


def environment() -> dict[str, str]:
    """What the servers and all that they fork have: nothing of the caller's but what Python and ROS need."""
    kept = start_processes.environment(0, str(layout.HOME))
    return {
        **kept,
        'PATH': f'{Path(sys.prefix, "bin")}:/usr/bin:/bin',
        'LANG': 'C.UTF-8',
        'TMPDIR': '/tmp',
        'ROS_LOG_DIR': '/tmp/log',
    }


MOST = 2  # stations at a time; a grader has one, tests of the grader have more
_lock = threading.Lock()
_stations: dict[tuple[Path, ...], Station] = {}


def start_tests(job, events: int, printed, domain: int, folders) -> Tests:
    """Start the tests of one submission; `job` is a file, `events` and `printed` take what comes out."""
    folders = tuple(Path(folder).resolve() for folder in folders)
    ours, theirs = socket.socketpair()
    tests, programs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    with theirs, tests, programs:
        for last in (False, True):
            try:
                station = _station(folders, fresh=last)
                station.ask('programs', {'domain': domain}, programs.fileno(), printed.fileno())
                station.ask(
                    'tests',
                    {'folders': list(map(str, folders)), 'domain': domain},
                    job.fileno(),
                    events,
                    printed.fileno(),
                    tests.fileno(),
                    theirs.fileno(),
                )
                break
            except OSError:
                if last:
                    raise
    return Tests(ours)


def _station(folders: tuple[Path, ...], fresh: bool = False) -> Station:
    """The station for these folders, in this process; a `fresh` one if the other has ended."""
    with _lock:
        station = _stations.get(folders)
        if station is None or station.owner != os.getpid() or fresh:
            if station is not None and station.owner == os.getpid():
                station.close()
            _stations.pop(folders, None)
            while len(_stations) >= MOST:  # what they have started goes on to its end
                oldest = _stations.pop(next(iter(_stations)))
                if oldest.owner == os.getpid():
                    oldest.close()
            station = _stations[folders] = Station(folders)
        return station


@atexit.register
def close() -> None:
    """End all servers of this process."""
    with _lock:
        for station in _stations.values():
            if station.owner == os.getpid():
                station.close()
        _stations.clear()
