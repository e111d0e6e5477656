"""What runs of a test that is drawn in some samples only."""

import json
import os
import subprocess
import sys

import pytest

from helpers import paths

FILE = 'helpers/tests/runner/test_mistakes.py'
TEST = f'{FILE}::test_a_wait_in_a_callback_is_named'


def collected(*arguments):
    command = [sys.executable, '-m', 'pytest', '-q', '--collect-only', *arguments]
    environ = {name: value for name, value in os.environ.items() if name != 'COURSE_ALL_TESTS'}
    process = subprocess.run(command, cwd=paths.ROOT, env=environ, capture_output=True, text=True, timeout=100)
    return [line for line in process.stdout.splitlines() if line.startswith(TEST)]


@pytest.mark.one_of(3)
@pytest.mark.timeout(400)
def test_a_test_that_is_named_runs(tmp_path):
    """So does one that failed in a sample, when it runs again alone."""
    every = collected(TEST)
    some = collected(FILE)
    assert len(some) < len(every)
    missing = next(name for name in every if name not in some)
    assert collected(missing) == [missing]
    failed = tmp_path / 'v' / 'cache' / 'lastfailed'
    failed.parent.mkdir(parents=True)
    failed.write_text(json.dumps({missing: True}))
    assert collected(FILE, '--last-failed', '-o', f'cache_dir={tmp_path}') == [missing]
