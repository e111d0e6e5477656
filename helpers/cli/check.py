"""``./course check``: the visible tests of a chapter or an exercise, on the saved notebook."""

import re
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from helpers import paths
from helpers.cli import Refusal
from helpers.exercises import progress_file, remarks, start_page


def check(
    what: Annotated[str, typer.Argument(metavar='3 | 3.2', help='A chapter or an exercise.')],
    notebooks_folder: Annotated[Path, typer.Option('--notebooks', help='The folder of notebooks.')] = paths.NOTEBOOKS,
):
    """Run the visible tests of a chapter or an exercise, on the notebook as it was last saved."""
    from rich.console import Console

    from helpers.cli.progress import counted
    from helpers.exercises import manifest, notebooks, result_display
    from helpers.runner import session

    if not re.fullmatch(r'\d+(\.\d+)?', what):
        raise Refusal(f'{what!r} is no exercise: write a chapter, such as 3, or an exercise, such as 3.2')
    try:
        known = manifest.load()
        chosen = [exercise for exercise in known.values() if what in (exercise.id, str(exercise.chapter))]
        if not chosen:
            raise Refusal(f'there is no exercise {what}; there are {manifest.near(what, known)}')
        cells = notebooks.read(notebooks_folder / chosen[0].notebook)
    except (manifest.ManifestError, notebooks.InvalidSubmission) as error:
        raise Refusal(str(error)) from None
    own = notebooks_folder.resolve() == paths.NOTEBOOKS
    seeds = progress_file.seeds(exercise.id for exercise in chosen) if own else {}
    launcher = session.Options.launcher if own else _launcher(notebooks_folder)
    options = session.Options(
        processes=2, side_by_side=session.SIDE_BY_SIDE, seeds=seeds, launcher=launcher, folder=notebooks_folder
    )
    console = Console(highlight=False, soft_wrap=True)
    with counted(console, 'visible tests') as say:
        report = session.run(cells, chosen, options, say)
    if own:
        start_page.keep(report)
    for style, text in result_display.lines(report.exercises):
        console.print(text, style=style or None, markup=False)
    for line in remarks.after(report.exercises, cells) if own else ():
        console.print(f'  {line}', markup=False)
    if any(exercise.verdict == 'grader_error' for exercise in report.exercises):
        for line in report.log:
            typer.echo(line, err=True)
    raise typer.Exit(0 if all(exercise.passed for exercise in report.exercises) else 1)


def _launcher(folder: Path) -> str:
    """How the programs of somebody else's notebooks are started: in the sandbox, if the course has one that works here.

    Says whose programs they are, and what they can do.
    """
    from helpers.runner import session

    found = session.Options.launcher
    where = 'with your rights: they can read and change whatever you can. Go on only with work that you trust.'
    if find_spec('grading'):  # the learner's edition has no sandbox
        from grading import sandbox

        if problem := sandbox.problem():
            where += f' There is no sandbox: {problem}.'
        else:
            found, where = sandbox.launcher(), 'in the sandbox that grading uses.'
    typer.echo(f'The programs in the notebooks of {folder} run {where}', err=True)
    return found
