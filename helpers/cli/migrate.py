"""``./course migrate``: take the work in older notebooks over into those of this version."""

from pathlib import Path
from typing import Annotated

import typer

from helpers import paths
from helpers.cli import Refusal


def migrate(
    old: Annotated[Path, typer.Argument(metavar='OLD', help='The folder of the old course, or of its notebooks.')],
    notebooks_folder: Annotated[
        Path, typer.Option('--notebooks', metavar='DIR', help='The new notebooks.')
    ] = paths.NOTEBOOKS,
    dry_run: Annotated[bool, typer.Option('--dry-run', help='Only say what would be done.')] = False,
):
    """Take your answers and your own cells over from the notebooks of an older version."""
    from rich.console import Console

    from helpers.exercises import manifest, migration
    from helpers.exercises.migration_report import MigrationError

    try:
        report = migration.migrate(old, notebooks_folder, dry_run=dry_run)
    except (MigrationError, manifest.ManifestError) as error:
        raise Refusal(str(error)) from None
    console = Console(highlight=False, soft_wrap=True)
    for one in report.exercises:
        console.print(f'{one.exercise:>5}  {one.said}', style='yellow' if one.lost else None, markup=False)
    for name, number in report.own.items():
        console.print(f'{name}: {number} {"cell" if number == 1 else "cells"} of your own', markup=False)
    for note in report.notes:
        console.print(note, style='yellow', markup=False)
    if dry_run:
        console.print('Nothing was written.')
    elif report.backup:
        console.print(
            f'{len(report.written)} notebooks changed; as they were before: {report.backup}. Close them in '
            'JupyterLab and open them again. Now test your answers, a chapter at a time: ./course check 3',
            markup=False,
        )
    elif not report.packages:
        console.print('Nothing had to be changed.')
    raise typer.Exit(int(any(one.lost for one in report.exercises)))
