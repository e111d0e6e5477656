"""The grader's own side of the sandbox: the two warm servers, started once for all submissions."""

import atexit
import os
import subprocess
import sys
import threading
from pathlib import Path

from grading.sandbox import control_groups, mounts, unprivileged
from helpers.paths import ROOT
from helpers.runner import start_processes
from helpers.runner.forked import Forked
from helpers.runner.servers import Servers


class Station(Servers):
    """Both servers; `folders` hold the tests that may be asked for."""

    def __init__(self, folders: tuple[Path, ...]):
        self._leave_group = control_groups.begin(unprivileged.account().pw_uid if os.geteuid() == 0 else None)
        self._trees = [ROOT, *mounts.readable(), *folders]
        super().__init__(('grading.sandbox.tests_side', self._popen), ('grading.sandbox.learners_side', self._popen))

    def _popen(self, command: list[str], kept: int) -> subprocess.Popen:
        return subprocess.Popen(
            unprivileged.command(command, self._trees),
            cwd='/',
            env=environment(),
            stdin=subprocess.DEVNULL,
            pass_fds=[kept],
            start_new_session=True,
        )

    def close(self) -> None:
        """End the servers and all that they have started."""
        super().close()
        if os.getpid() == self.owner:
            self._leave_group()


def environment() -> dict[str, str]:
    """What the servers and all that they fork have: nothing of the caller's but what Python and ROS need."""
    kept = start_processes.environment(0, str(mounts.HOME))
    return {**kept, 'PATH': f'{Path(sys.prefix, "bin")}:/usr/bin:/bin', 'TMPDIR': '/tmp', 'ROS_LOG_DIR': '/tmp/log'}


MOST = 2  # stations at a time; a grader has one, tests of the grader have more
_lock = threading.Lock()
_stations: dict[tuple[Path, ...], Station] = {}


def start_tests(job, events: int, printed, domain: int, folders) -> Forked:
    """Start the tests of one submission; `job` is a file, `events` and `printed` take what comes out."""
    folders = tuple(Path(folder).resolve() for folder in folders)
    tests = {'folders': list(map(str, folders)), 'domain': domain}
    for last in (False, True):
        try:
            return _station(folders, fresh=last).fork(tests, {'domain': domain}, job, events, printed)
        except OSError:
            if last:
                raise
    raise AssertionError('not reached')


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
