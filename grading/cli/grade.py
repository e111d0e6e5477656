"""``./course grade``: grade submissions, visible and hidden tests, into a folder of results."""

import os
from pathlib import Path
from typing import Annotated

import typer

from helpers.cli import Refusal


def grade(
    submissions: Annotated[list[Path], typer.Argument(
        metavar='SUBMISSION …', help='A .zip made by submit, a folder of notebooks, an .ipynb, or a folder of these.')],
    output: Annotated[Path, typer.Option('-o', '--output', metavar='DIR', help='Where results go; resumes there.')],
    jobs: Annotated[int, typer.Option('--jobs', min=1, help='Processes of tests at a time; the cores if not given.')]
    = len(os.sched_getaffinity(0)),
):
    """Grade submissions; run again on the same DIR to go on where it stopped."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    from grading import grade as grader
    from grading.submissions import Unusable, find
    from helpers.exercises import manifest

    try:
        found = find(submissions)
        course = grader.Course.here()
        output.mkdir(parents=True, exist_ok=True)
    except (Unusable, manifest.ManifestError) as error:
        raise Refusal(str(error)) from None
    except OSError as error:
        raise Refusal(f'{output} cannot be written: {error.strerror}') from None
    console = Console(highlight=False, soft_wrap=True)
    if course.sandbox == 'none':
        console.print('Sandbox: none. Submissions run as plain processes with limits; grade only what you trust.',
                      style='yellow', markup=False)
    columns = (TextColumn('{task.description}'), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console) as progress:
        task = progress.add_task('grading', total=len(found))

        def say(record, fresh):
            score = 'unknown' if record.score is None else f'{record.score:g}'
            note = '' if fresh else ' (unchanged)'
            console.print(f'{record.learner}: {score} of {record.points:g}, {record.status}{note}', markup=False)
            progress.advance(task)

        records = grader.grade(found, course, output, jobs, say)
    console.print(f'{output / "gradebook.csv"}: {len(records)} learners', markup=False)
    faults = [record.learner for record in records if record.status == 'grader_error']
    if faults:
        console.print(f'A fault of the grader\'s own left marks open for {", ".join(faults)}: see run.log and run '
                      'grade again.', style='red', markup=False)
    raise typer.Exit(1 if faults else 0)
