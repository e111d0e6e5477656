"""`./course --help` before anything is set up."""

import subprocess
import sys
import time

import pytest

from environment.setup import usage
from environment.setup.main import ROOT
from helpers.cli import app


def test_it_names_the_commands_of_the_command_line():
    told = dict(usage.commands(ROOT))
    assert list(told) == [command.name for command in app.make_app().registered_commands]
    assert all(sentence.endswith(('.', '?')) for sentence in told.values())


@pytest.mark.parametrize(
    ('arguments', 'asked'),
    [
        ([], True),
        (['-h'], True),
        (['--help'], True),
        (['lab', '--help'], True),
        (['lab'], False),
        (['setup'], False),
        (['shell', '--', 'ros2', '--help'], False),
        (['check', '3', '--help'], False),
    ],
)
def test_what_asks_for_help(arguments, asked):
    assert usage.asked(arguments) is asked


def test_a_fresh_copy_answers_at_once_and_sets_nothing_up(tmp_path, clean_environ):
    for name in ('course', 'environment/setup', 'environment/requirements.lock', 'helpers/cli', 'grading/cli'):
        if (ROOT / name).exists():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            subprocess.run(['cp', '-r', ROOT / name, tmp_path / name], check=True)
    began = time.monotonic()
    done = subprocess.run(
        [tmp_path / 'course', '--help'],
        env={**clean_environ, 'PATH': '/usr/bin:/bin'},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert time.monotonic() - began < 10  # far below a set-up, also on a busy machine
    assert done.returncode == 0 and done.stderr == '', done.stderr
    assert './course setup does' in done.stdout and '\n  lab ' in done.stdout
    assert not (tmp_path / '.venv').exists()
    assert max(map(len, done.stdout.partition('Commands:')[0].splitlines())) <= 120


def test_it_says_whether_there_is_an_environment(tmp_path, monkeypatch):
    monkeypatch.setattr(usage, 'commands', lambda root: iter(()))
    assert 'Nothing is set up yet' in usage.text(tmp_path)
    (tmp_path / '.venv').mkdir()
    assert 'older than the course' in usage.text(tmp_path) and 'Nothing' not in usage.text(tmp_path)


def test_setup_says_what_is_ready():
    code = 'from helpers.cli.app import main; import sys; sys.exit(main(["setup"]))'
    done = subprocess.run([sys.executable, '-c', code], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0
    assert done.stdout.startswith('Ready: ROS 2 Jazzy with Python 3.')
