"""``./course submit``: pack the saved notebooks into one file to hand in."""

from pathlib import Path
from typing import Annotated

import typer

from helpers import paths
from helpers.cli import Refusal


def submit(
    learner: Annotated[str | None, typer.Option('--id', help='Your id; the login name if not given.')] = None,
    output: Annotated[Path | None, typer.Option('-o', '--output', metavar='FILE.zip', help='Where to write.')] = None,
    notebooks_folder: Annotated[Path, typer.Option('--notebooks', help='The folder of notebooks.')] = paths.NOTEBOOKS,
):
    """Pack the saved notebooks into one file to hand in, and print what passes."""
    from rich.console import Console

    from helpers.exercises import manifest, result_display
    from helpers.exercises.submit import SubmissionError, pack

    try:
        packed = pack(learner, output, notebooks_folder=notebooks_folder)
    except (SubmissionError, manifest.ManifestError) as error:
        raise Refusal(str(error)) from None
    console = Console(highlight=False, soft_wrap=True)
    for style, text in result_display.lines(packed.exercises):
        console.print(text, style=style or None, markup=False)
    for line in packed.lists():
        console.print(line, style='yellow' if line in packed.warnings else None, markup=False)
    passed = sum(exercise.passed for exercise in packed.exercises)
    console.print(
        f'\n{passed} of {len(packed.exercises)} exercises pass their visible tests; hidden tests '
        f'run after you hand in. Packed for {packed.learner}: {packed.path}',
        markup=False,
    )
