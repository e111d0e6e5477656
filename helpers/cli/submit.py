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

    from helpers.cli.progress import counted
    from helpers.exercises import manifest, result_display
    from helpers.exercises.handing_in import SubmissionError, pack, tested

    console = Console(highlight=False, soft_wrap=True)
    try:
        packed = pack(learner, output, notebooks_folder=notebooks_folder)
    except (SubmissionError, manifest.ManifestError) as error:
        raise Refusal(str(error)) from None
    console.print(
        f'Packed for {packed.learner}: {packed.path}. Now its visible tests run, for a minute or two. '
        'Ctrl+C ends them; the file stays.',
        markup=False,
    )
    with counted(console, 'visible tests') as say:
        for results in tested(packed, say):
            for style, text in result_display.lines(results):
                console.print(text, style=style or None, markup=False)
    for line in packed.lists():
        console.print(line, style='yellow' if line in packed.warnings else None, markup=False)
    passed = sum(exercise.passed for exercise in packed.exercises)
    console.print(
        f'\n{passed} of {len(packed.exercises)} exercises pass their visible tests; hidden tests '
        f'run after you hand in. The file to hand in: {packed.path}',
        markup=False,
    )
