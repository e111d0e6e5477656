"""Puts the commands together."""

import signal
import sys
from importlib import import_module
from importlib.util import find_spec

import typer

from environment.setup import interruption
from helpers.cli import Refusal

INTERRUPTED = 128 + signal.SIGINT  # typer ends with it, too

# In the order of --help. The instructor's commands exist only where the instructor's half is.
LEARNER = ('lab', 'test', 'setup', 'doctor', 'shell', 'check', 'submit', 'migrate')
INSTRUCTOR = ('release', 'grade', 'build', 'answers', 'bench')


def make_app() -> typer.Typer:
    """Return the application with every command whose module is there."""
    app = typer.Typer(
        help='The ROS 2 course: notebooks, checks and submissions.',
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
        context_settings={'help_option_names': ['-h', '--help']},
    )
    app.callback()(lambda: None)  # else typer would take a single command for the whole application
    for package, names in (('helpers.cli', LEARNER), ('grading.cli', INSTRUCTOR)):
        if find_spec(package.partition('.')[0]) is None:
            continue
        for name in names:
            if find_spec(f'{package}.{name}') is not None:
                module = import_module(f'{package}.{name}')
                app.command(name, **getattr(module, 'SETTINGS', {}))(getattr(module, name))
    return app


def main(arguments: list[str] | None = None) -> int:
    """Run the command line and return its exit status: 0 done, 1 something failed, 2 wrong usage or unusable input."""
    interruption.raises()
    try:
        status = make_app()(args=arguments, prog_name='./course', standalone_mode=True) or 0
    except Refusal as refusal:
        print(f'course: {refusal}', file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        status = INTERRUPTED
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else int(end.code is not None)
    if status == INTERRUPTED:
        print('course: interrupted', file=sys.stderr)
    return status
