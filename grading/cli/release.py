"""``./course release``: the learner's edition."""

from pathlib import Path
from typing import Annotated

import typer

from helpers.cli import Refusal


def release(
    output: Annotated[Path, typer.Option('-o', '--output', metavar='DIR', help='A new or empty folder.')],
):
    """Make the learner's edition: no solutions/, no grading/."""
    from grading import release as edition

    try:
        files = edition.release(output)
    except edition.ReleaseError as error:
        raise Refusal(str(error)) from None
    except edition.Leak as leak:
        typer.echo(f'not released: {leak}', err=True)
        raise typer.Exit(1) from None
    typer.echo(f'{output}: {len(files)} files')
