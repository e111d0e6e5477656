"""``./course check``: the visible tests of a chapter or an exercise, on the saved notebook."""

import re
from pathlib import Path
from typing import Annotated

import typer

from helpers import paths, start_page
from helpers.cli import Refusal


def check(
    what: Annotated[str, typer.Argument(metavar='3 | 3.2', help='A chapter or an exercise.')],
    notebooks_folder: Annotated[Path, typer.Option('--notebooks', help='The folder of notebooks.')] = paths.NOTEBOOKS,
):
    """Run the visible tests of a chapter or an exercise, on the notebook as it was last saved."""
    from rich.console import Console

    from helpers import display
    from helpers.exercises import manifest, notebooks
    from helpers.runner import session

    if not re.fullmatch(r'\d+(\.\d+)?', what):
        raise Refusal(f'{what!r} is no exercise: write a chapter, such as 3, or an exercise, such as 3.2')
    try:
        known = manifest.load()
        chosen = [exercise for exercise in known.values() if what in (exercise.id, str(exercise.chapter))]
        if not chosen:
            raise Refusal(f'there is no exercise {what}; there are: {", ".join(known)}')
        cells = notebooks.read(notebooks_folder / chosen[0].notebook)
    except (manifest.ManifestError, notebooks.InvalidSubmission) as error:
        raise Refusal(str(error)) from None
    report = session.run(cells, chosen, session.Options(processes=2))
    if notebooks_folder.resolve() == paths.NOTEBOOKS:
        start_page.keep(report.exercises)
    console = Console(highlight=False, soft_wrap=True)
    for style, text in display.lines(report.exercises):
        console.print(text, style=style or None, markup=False)
    if any(exercise.verdict == 'grader_error' for exercise in report.exercises):
        for line in report.log:
            typer.echo(line, err=True)
    raise typer.Exit(0 if all(exercise.passed for exercise in report.exercises) else 1)
