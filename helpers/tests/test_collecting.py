"""What pytest leaves out of the folder that it is given."""

import os
import shutil
import subprocess
import sys

import pytest

from helpers import paths

MADE = 'solutions/delivery_ws/src/speed/test/test_limit.py'


@pytest.fixture
def collected(tmp_path):
    """A function that says what pytest would run of a course with a workspace beside its notebooks, given this."""
    shutil.copy(paths.ROOT / 'conftest.py', tmp_path)
    for name in (MADE, 'solutions/test_beside.py'):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text('def test_it():\n    pass\n')
    environment = {**os.environ, 'PYTHONPATH': str(paths.ROOT)}

    def run(*arguments, cwd=tmp_path):
        command = [sys.executable, '-m', 'pytest', '--collect-only', '-q', '--rootdir', str(tmp_path), *arguments]
        done = subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, timeout=120)
        return [line for line in done.stdout.splitlines() if '::' in line]

    return run


def test_workspaces_beside_notebooks_are_left_out(collected):
    assert collected('solutions') == ['solutions/test_beside.py::test_it']


def test_a_workspace_that_is_named_is_not(collected, tmp_path):
    assert collected(MADE) == [f'{MADE}::test_it']
    assert collected(f'{MADE}::test_it') == [f'{MADE}::test_it']
    assert collected('src', cwd=tmp_path / 'solutions' / 'delivery_ws') == [f'{MADE}::test_it']
