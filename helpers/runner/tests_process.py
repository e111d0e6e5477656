"""The process in which tests run, and the servers that this process has for it.

Half of the time of a check would go by until tests' side and learner's side have imported ROS. So two servers
(`helpers.runner.warm`) import that once, and fork. A notebook knows before its learner asks that a check will come:
when the cell of an exercise has run, `stand_by` starts them. They end with the kernel, after SPARE seconds without a
job, or with `close`.
"""

import atexit
import json
import os
import re
import subprocess
import tempfile
import threading
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import asdict
from importlib import import_module
from pathlib import Path

from environment.setup.startup import HOME
from helpers.kernel import domains
from helpers.runner import preloading, scratch, servers, start_processes
from helpers.runner.forked import Forked

PLAIN = 'helpers.runner.start_processes:start'  # the launcher without a sandbox
SPARE = 300.0  # seconds
# How the names of the caller's variables begin that tests do not get.
_LEFT_OUT = ('PYTEST_', 'COV_', 'PYTHON', 'ROS_', 'RCUTILS_', 'RMW_', 'FASTDDS_', 'FASTRTPS_')


def _popen(environment: dict[str, str]) -> servers.Start:
    """How a server is started that has these environment variables."""
    return lambda command, kept: subprocess.Popen(
        command,
        cwd='/',
        env=environment,
        stdin=subprocess.DEVNULL,
        pass_fds=[kept],
        start_new_session=True,  # Ctrl-C is for the caller, which ends it
    )


_servers: servers.Servers | None = None
_lock = threading.Lock()
_timer: threading.Timer | None = None


def stand_by() -> None:
    """Let the servers prepare themselves for the next check, unless they have done so. Never raises."""
    with suppress(OSError), _lock:  # no process can be had: the check itself will tell
        _running_servers()


def close() -> None:
    """End the servers, if there are any. Idempotent."""
    with _lock:
        _end_servers()


atexit.register(close)


def _end_servers() -> None:
    global _servers, _timer
    ending, _servers, timer, _timer = _servers, None, _timer, None
    if timer is not None:
        timer.cancel()
    if ending is not None:
        ending.close()


def _running_servers() -> servers.Servers:
    """The servers of this process, started if need be. The caller has the lock."""
    global _servers, _timer
    if _servers is not None and not _servers.running:
        _end_servers()
    if _servers is None:
        programs = start_processes.environment(0, tempfile.gettempdir())
        _servers = servers.Servers(
            ('helpers.runner.plain_tests', _popen(_environment(0))), ('helpers.runner.plain_programs', _popen(programs))
        )
    if _timer is not None:
        _timer.cancel()
    _timer = threading.Timer(SPARE, close)
    _timer.daemon = True
    _timer.start()
    return _servers


def _environment(domain: int) -> dict[str, str]:
    """The environment of tests' processes: the caller's, and what makes both sides find each other.

    Of the caller's settings of ROS and Python it has only those that a learner's program gets, too: with another
    discovery server, for example, the two would not meet.
    """
    path = os.pathsep.join(filter(None, [str(start_processes.ROOT), os.environ.get('PYTHONPATH')]))
    return {
        **{
            name: value
            for name, value in os.environ.items()
            if name in start_processes.KEPT or not name.startswith(_LEFT_OUT)
        },
        **start_processes.ros_environment(domain),
        'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1',
        'PYTHONPATH': path,
    }


def folder_for_programs() -> str:
    """In which folder temporary ones are made that hold programs: the usual one, unless it is not fit for them.

    It may be mounted `noexec`, or its path may have a space or such: the tools of ROS cannot work there (see
    `environment.setup.preflight.check_path`), and a learner's shell script need not know it.
    """
    usual = tempfile.gettempdir()
    if re.fullmatch(r'[\w./+-]+', usual, re.ASCII) and not os.statvfs(usual).f_flag & os.ST_NOEXEC:
        return usual
    own = start_processes.ROOT / HOME / 'tmp'
    own.mkdir(parents=True, exist_ok=True)
    return str(own)


def start_tests(job, events: int, printed, *, cwd: str, environment: dict[str, str], folders: Sequence[Path]) -> Forked:
    """Start a tests' process (`helpers.runner.tester`): `job` is its input, `events` and `printed` its outputs.

    `folders` hold the tests; a sandbox shows them to this process only.
    """
    given = json.load(job)
    cells = [cell for program in given['programs'].values() for cell in program['cells']]
    programs = {'domain': given['domain'], 'home': given['home'], 'modules': preloading.on_demand(cells)}
    tests = {'cwd': cwd, 'environment': environment}
    with _lock:
        for last in (False, True):
            try:
                return _running_servers().fork(tests, programs, job, events, printed)
            except OSError:  # one has ended just now
                if last:
                    raise
                _end_servers()
    raise AssertionError('not reached')


class TestsProcess:
    """A running process of tests: where its events come from, and what it has printed."""

    __test__ = False

    def __init__(self, launcher: str, limits: start_processes.Limits, job: dict, folders: Sequence[Path] = ()):
        """Start it for `job` (see `helpers.runner.tester`). A module of a launcher may have a `start_tests`, too."""
        with ExitStack() as stack:
            domain = stack.enter_context(domains.claim())
            self.cwd = stack.enter_context(scratch.folder('course-tests-'))
            # Where the learner's side may write.
            home = stack.enter_context(scratch.folder('course-', folder_for_programs()))
            self._printed = stack.enter_context(open(Path(self.cwd, 'printed'), 'w+b'))
            self.events, events = os.pipe()
            stack.callback(os.close, self.events)
            job = {'launcher': launcher, 'domain': domain, 'home': home, 'limits': asdict(limits), **job}
            try:
                self._start(job, events, _environment(domain) | {'ROS_LOG_DIR': self.cwd}, folders)
            finally:
                os.close(events)
            self._stack = stack.pop_all()

    def _start(self, job: dict, events: int, environment: dict[str, str], folders: Sequence[Path]) -> None:
        starter = import_module(job['launcher'].partition(':')[0])
        with open(Path(self.cwd, 'job.json'), 'w+') as file:
            json.dump(job, file)
            file.seek(0)
            start = getattr(starter, 'start_tests', start_tests)
            self.process = start(file, events, self._printed, cwd=self.cwd, environment=environment, folders=folders)

    def end(self) -> tuple[int, str]:
        """End it; returns its status, and the last of what it has printed."""
        self.process.kill()
        status = self.process.wait()
        self._printed.seek(0)
        text = self._printed.read(100_000).decode(errors='replace')[-4000:]
        self._stack.close()
        return status, text


@contextmanager
def running(
    job: dict, launcher: str, limits: start_processes.Limits, folders: Sequence[Path]
) -> Iterator[TestsProcess]:
    """A process that does `job`. The caller calls `end`, or leaves it to this."""
    tests = TestsProcess(launcher, limits, job, folders)
    try:
        yield tests
    finally:
        if tests.process.returncode is None:
            tests.end()
