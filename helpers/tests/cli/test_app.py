"""Which commands there are, and the exit statuses of the command line."""

import os
import signal
import subprocess
import sys
from importlib.util import find_spec

import pytest
import typer

from helpers import paths
from helpers.cli import Refusal, app


def run(*arguments, code='from helpers.cli.app import main; import sys; sys.exit(main())'):
    """Run the command line in a process of its own."""
    command = [sys.executable, '-c', code, *arguments]
    return subprocess.run(command, cwd=paths.ROOT, capture_output=True, text=True, timeout=60)


def command_names():
    return [command.name for command in app.make_app().registered_commands]


def test_help_names_every_command():
    done = run('--help')
    assert done.returncode == 0
    shown = [line.split()[0] for line in done.stdout.partition('Commands:')[2].splitlines() if line.strip()]
    assert shown == command_names()
    assert set(app.LEARNER) <= set(shown)


def test_what_lies_where_the_command_is_given_is_not_imported(tmp_path):
    (tmp_path / 'helpers').mkdir()  # another checkout
    (tmp_path / 'json.py').write_text('raise SystemExit("a file of the learner\'s")')
    done = subprocess.run([paths.ROOT / 'course', '--help'], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and 'Commands:' in done.stdout, done.stderr


def test_the_instructors_commands_need_the_instructors_half(monkeypatch):
    assert bool(set(app.INSTRUCTOR) & set(command_names())) is (find_spec('grading') is not None)
    real = app.find_spec
    monkeypatch.setattr(app, 'find_spec', lambda name: None if name.startswith('grading') else real(name))
    assert set(command_names()) == set(app.LEARNER)


def test_nothing_slow_is_imported_to_start():
    code = (
        'import sys; from helpers.cli.app import make_app; make_app(); '
        'print(*{"rclpy", "nbformat", "pytest", "jupytext", "numpy", "jinja2"} & set(sys.modules))'
    )
    assert run(code=code).stdout.strip() == ''


@pytest.mark.parametrize('arguments', [['nix'], ['lab', '--nix'], ['lab', '--port', 'x'], ['lab', '--port', '0']])
def test_wrong_usage_ends_with_two(arguments):
    done = run(*arguments)
    assert done.returncode == 2
    assert done.stdout == '' and './course' in done.stderr


@pytest.mark.parametrize(
    ('outcome', 'status'),
    [(None, 0), (typer.Exit(0), 0), (typer.Exit(1), 1), (Refusal('no port is free'), 2), (KeyboardInterrupt(), 130)],
)
def test_exit_status(monkeypatch, capsys, outcome, status):
    def command():
        if outcome is not None:
            raise outcome

    application = typer.Typer()
    application.command()(command)
    monkeypatch.setattr(app, 'make_app', lambda: application)
    assert app.main([]) == status
    if isinstance(outcome, Refusal):
        assert capsys.readouterr().err == 'course: no port is free\n'


@pytest.fixture(params=[signal.SIGTERM, signal.SIGHUP])
def number(request):
    """A signal; what it does in this process is afterwards as it was before."""
    before = signal.getsignal(request.param)
    yield request.param
    signal.signal(request.param, before)


@pytest.mark.parametrize(('before', 'status'), [(signal.SIG_DFL, 130), (signal.SIG_IGN, 0)])
def test_the_end_of_a_terminal_is_as_ctrl_c(monkeypatch, number, before, status):
    """What is tidied up after Ctrl+C is then, too. `nohup` has SIGHUP ignored."""
    application = typer.Typer()
    application.command()(lambda: os.kill(os.getpid(), number))
    monkeypatch.setattr(app, 'make_app', lambda: application)
    signal.signal(number, before)
    assert app.main([]) == status
