"""``./course shell``: a second terminal, or one command in it."""

import os
from pathlib import Path
from typing import Annotated

import typer

from helpers.cli import Refusal, own

ROOT = Path(__file__).resolve().parents[2]
SETTINGS = {'context_settings': {'ignore_unknown_options': True, 'allow_interspersed_args': False}}

# After the user's own start-up file, which may set PATH or source another ROS.
BASHRC = Path(__file__).with_name('shell.bashrc')


def shell(
    command: Annotated[list[str] | None, typer.Argument(metavar='[-- COMMAND ...]', help='Instead of a shell.')] = None,
    stock: Annotated[bool, typer.Option('--stock', help="ROS with its own defaults instead of the course's.")] = False,
) -> None:
    """Open a bash in which .venv/setup.bash is sourced, or run one command so; ends with its exit status."""
    setup = ROOT / '.venv' / 'setup.bash'
    environ = {name: value for name, value in os.environ.items() if name != '_ROS_WHEELS_BOOTSTRAP_COMPLETE'}
    if stock:
        own.leave(environ)
    else:
        own.enter(environ)
    environ['COURSE_SETUP'] = str(setup)
    if command:
        argv = ['bash', '-c', 'source "$0" && exec -- "$@"', str(setup), *command]
    else:  # whatever the login shell is: in zsh and fish the chapters' `source install/setup.bash` does not work
        argv = ['bash', '--rcfile', str(BASHRC), '-i']
    if not command:
        typer.echo('ROS 2 is set up in this shell; leave it with exit.', err=True)
    try:
        os.execvpe('bash', argv, environ)
    except FileNotFoundError:
        raise Refusal('bash is missing; run: sudo apt install bash') from None
