"""A tests' process that says what it is told to say: `launcher` for sessions whose events are made up."""

import json
import subprocess
import sys
from collections.abc import Iterable

LAUNCHER = 'grading.tests.attacks.fake_tests:start'
_SAY = 'import os, sys; os.write(int(sys.argv[1]), sys.argv[2].encode()); sys.exit(int(sys.argv[3]))'
script: list[str] = []  # the lines of the next process
status = 0


def says(*events: dict | str, exit_status: int = 0) -> None:
    """Set what the next processes say: events, or lines that are none."""
    global status
    script[:] = [event if isinstance(event, str) else json.dumps(event) for event in events]
    status = exit_status


def start_tests(job, events: int, printed, *, cwd: str, environment: dict, folders: Iterable) -> subprocess.Popen:
    """As `helpers.runner.tests_process.start_tests`."""
    return subprocess.Popen(
        [sys.executable, '-I', '-S', '-c', _SAY, str(events), '\n'.join(script) + '\n', str(status)],
        pass_fds=[events],
        stdout=printed,
        stderr=printed,
    )
