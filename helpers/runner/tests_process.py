"""The process in which tests run: started for one job, or before it is known what there will be to judge.

Half of the time of a check goes by until the tests' side and the learner's side have imported ROS. A notebook knows
that before its learner asks: when the cell of an exercise has run, `stand_by` starts a process that prepares itself,
and the next check takes it. It ends with the kernel, after SPARE seconds without a job, or with `close`.
"""

import json
import os
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict
from importlib import import_module
from pathlib import Path

from helpers.kernel import domains
from helpers.runner import start_processes

PLAIN = 'helpers.runner.start_processes:start'  # the launcher without a sandbox
SPARE = 300.0  # seconds


class TestsProcess:
    """A running process of tests: where its events come from, and what it has printed."""

    __test__ = False

    def __init__(
        self, launcher: str, limits: start_processes.Limits, job: dict | None = None, folders: Sequence[Path] = ()
    ):
        """Start it for `job` (see `helpers.runner.tester`); without one it prepares itself and waits for `give`.

        `folders` hold the tests; a sandbox shows them to this process only.
        """
        self.launcher, self.limits = launcher, limits
        with ExitStack() as stack:
            domain = stack.enter_context(domains.claim())
            self.cwd = stack.enter_context(tempfile.TemporaryDirectory(prefix='course-tests-'))
            self._printed = stack.enter_context(open(Path(self.cwd, 'printed'), 'w+b'))
            self.events, events = os.pipe()
            stack.callback(os.close, self.events)
            try:
                surroundings = {'launcher': launcher, 'domain': domain, 'limits': asdict(limits)}
                if job is None:
                    self._give = self._start_waiting(surroundings, events, domain)
                else:
                    self._start_with(surroundings | job, events, domain, folders)
            finally:
                os.close(events)
            self._stack = stack.pop_all()

    def _start_with(self, job: dict, events: int, domain: int, folders: Sequence[Path]) -> None:
        with open(Path(self.cwd, 'job.json'), 'w+') as file:
            json.dump(job, file)
            file.seek(0)
            starter = import_module(self.launcher.partition(':')[0])
            self.process = getattr(starter, 'start_tests', start_processes.start_tests)(
                file, events, self._printed, cwd=self.cwd, environment=self._environment(domain), folders=folders
            )

    def _start_waiting(self, surroundings: dict, events: int, domain: int):
        self.process = subprocess.Popen(
            [sys.executable, '-m', 'helpers.runner.tester', str(events)],
            cwd=self.cwd,
            env=self._environment(domain),
            stdin=subprocess.PIPE,
            stdout=self._printed,
            stderr=self._printed,
            pass_fds=[events],
            start_new_session=True,
            text=True,
        )
        assert self.process.stdin is not None  # it is a pipe
        self.process.stdin.write(json.dumps(surroundings) + '\n')
        self.process.stdin.flush()
        return self.process.stdin

    def _environment(self, domain: int) -> dict[str, str]:
        path = os.pathsep.join(filter(None, [str(start_processes.ROOT), os.environ.get('PYTHONPATH')]))
        return {
            **{k: v for k, v in os.environ.items() if not k.startswith(('PYTEST_', 'COV_'))},
            **start_processes.ros_environment(domain),
            'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1',
            'ROS_LOG_DIR': self.cwd,
            'PYTHONPATH': path,
        }

    def give(self, job: dict) -> None:
        """Let a process that stands by do this job. Raises OSError if it has ended."""
        with self._give:
            self._give.write(json.dumps(job))

    def end(self) -> tuple[int, str]:
        """End it; returns its status, and the last of what it has printed."""
        self.process.kill()
        status = self.process.wait()
        self._printed.seek(0)
        text = self._printed.read(100_000).decode(errors='replace')[-4000:]
        self._stack.close()
        return status, text


_ready: TestsProcess | None = None
_lock = threading.Lock()
_timer: threading.Timer | None = None


def stand_by() -> None:
    """Let a process prepare itself for the next check, unless one does already. Never raises."""
    global _ready, _timer
    with _lock:
        if _ready is not None and _ready.process.poll() is None:
            return
        _end_ready()
        try:
            _ready = TestsProcess(PLAIN, start_processes.LIMITS)
        except (OSError, RuntimeError):  # no domain is free, no process can be had: the check itself will tell
            return
        _timer = threading.Timer(SPARE, close)
        _timer.daemon = True
        _timer.start()


def close() -> None:
    """End the process that stands by, if there is one."""
    with _lock:
        _end_ready()


def _end_ready() -> None:
    global _ready, _timer
    ready, _ready, timer, _timer = _ready, None, _timer, None
    if timer is not None:
        timer.cancel()
    if ready is not None:
        ready.end()


def _take(launcher: str, limits: start_processes.Limits) -> TestsProcess | None:
    """The process that stands by, if it fits; from now on it is the caller's."""
    global _ready, _timer
    with _lock:
        if _ready is None or launcher != PLAIN or limits != _ready.limits or _ready.process.poll() is not None:
            return None
        ready, _ready = _ready, None
        if _timer is not None:
            _timer.cancel()
        return ready


@contextmanager
def running(
    job: dict, launcher: str, limits: start_processes.Limits, folders: Sequence[Path]
) -> Iterator[TestsProcess]:
    """A process that does `job`: the one that stands by, or a new one. The caller calls `end`, or leaves it to this."""
    tests = _take(launcher, limits)
    if tests is not None:
        try:
            tests.give(job)
        except OSError:
            tests.end()
            tests = None
    tests = tests or TestsProcess(launcher, limits, job, folders)
    try:
        yield tests
    finally:
        if tests.process.returncode is None:
            tests.end()
