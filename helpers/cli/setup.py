"""``./course setup``: nothing but the set-up that every command does first."""

import sys

import typer

from helpers import paths


def setup() -> None:
    """Prepare this folder, or bring it up to date, and do nothing else; quick if there is nothing to do."""
    # The script `course` has done it before this runs: the command line itself is a part of the environment.
    python = '.'.join(map(str, sys.version_info[:3]))
    typer.echo(f'Ready: ROS 2 Jazzy with Python {python} in {paths.ROOT / ".venv"}. To begin: ./course lab')
