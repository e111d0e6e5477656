"""``./course grade``: grade submissions, visible and hidden tests, into a folder of results."""

import os
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from grading import sandbox as sandboxes
from helpers.cli import Refusal

CORES = len(os.sched_getaffinity(0))

Submissions = Annotated[
    list[Path],
    typer.Argument(
        metavar='SUBMISSION …', help='A .zip made by submit, a folder of notebooks, an .ipynb, or a folder of these.'
    ),
]
Output = Annotated[Path, typer.Option('-o', '--output', metavar='DIR', help='Where results go; resumes there.')]
Jobs = Annotated[
    int, typer.Option('--jobs', metavar='N', min=1, help='Processes of tests at a time; the cores if not given.')
]
Sandbox = Annotated[
    str, typer.Option(metavar='NAME', help=f"Where learners' code runs: {' or '.join(sandboxes.LAUNCHERS)}.")
]
Cluster = Annotated[str, typer.Option(metavar='ADDRESS', help='Grade on the Dask cluster of this scheduler.')]
Chapters = Annotated[
    list[int] | None,
    typer.Option(
        metavar='N',
        help="Grade only this chapter's exercises, as an assignment; may be given several times. DIR keeps the choice.",
    ),
]
Seed = Annotated[str, typer.Option(metavar='TEXT', help="Of the inputs that tests draw; DIR's own if not given.")]
Only = Annotated[
    list[str] | None,
    typer.Option(
        metavar='LEARNER[/EXERCISE]',
        help='Grade only this, and leave the rest as it is; * for all. May be given several times.',
    ),
]
Regrade = Annotated[bool, typer.Option('--regrade', help='Grade also what has a result already.')]
Late = Annotated[Path | None, typer.Option(metavar='FILE', help='Late policy, YAML.')]
Adjustments = Annotated[Path | None, typer.Option(metavar='FILE', help='Marks set or changed by hand, CSV or YAML.')]
Anonymous = Annotated[bool, typer.Option('--anonymous', help='Pseudonyms instead of ids; the map is in DIR-private.')]


def grade(
    submissions: Submissions,
    output: Output,
    jobs: Jobs = CORES,
    sandbox: Sandbox = sandboxes.DEFAULT,
    cluster: Cluster = '',
    chapter: Chapters = None,
    seed: Seed = '',
    only: Only = None,
    regrade: Regrade = False,
    late: Late = None,
    adjustments: Adjustments = None,
    anonymous: Anonymous = False,
):
    """Grade submissions; run again on the same DIR to go on where it stopped."""
    from rich.console import Console

    from grading import adjustments as manual
    from grading import folder, grading_progress, plan
    from grading import grading_run as grader
    from grading import late as lateness
    from grading.submissions import find
    from helpers.runner import bytecode, stopping

    refused = _refused()
    console = Console(highlight=False, soft_wrap=True)
    skipped: list[Path] = []
    try:
        found = find(submissions, skipped)
        _refuse_unknown(sandbox)
        chapters = folder.Folder(output).chapters(chapter or ())
        course = replace(grader.Course.here(), sandbox=sandbox).part(chapters)
        if not cluster and (problem := sandboxes.problem(sandbox)):
            raise Refusal(f'{problem}. To grade without protection: --sandbox none')
        settings = grader.Settings(
            seed,
            tuple(only or ()),
            regrade,
            lateness.load(late) if late else None,
            tuple(manual.load(adjustments, plan.points(course.exercises))) if adjustments else (),
            anonymous,
            chapters,
            cluster,
        )
        _warn(skipped, course.sandbox, console)
        with console.status('Compiling Python modules'):
            bytecode.store()
            bytecode.store_installed()
        with grading_progress.ShownProgress(console) as shown:
            records = grader.grade(found, course, output, jobs, shown, settings)
    except refused as error:
        raise Refusal(str(error)) from None
    except OSError as error:
        raise Refusal(f'{error.filename or output} cannot be read or written: {error.strerror or error}') from None
    except KeyboardInterrupt:
        console.print('Stopped. What is graded is kept: run the same command to go on.')
        stopping.everything(patience=10.0)
        os._exit(130)  # without waiting for a submission that is being read
    console.print(f'{output / "gradebook.csv"}: {len(records)} learners', markup=False)
    raise typer.Exit(_summary(records, console))


def _refuse_unknown(sandbox: str) -> None:
    if sandbox not in sandboxes.LAUNCHERS:
        raise Refusal(f'there is no sandbox {sandbox!r}; there are: {", ".join(sandboxes.LAUNCHERS)}')


def _refused() -> tuple[type[Exception], ...]:
    """The exceptions that say what is wrong with the arguments or their files."""
    from grading import adjustments, anonymous, choice, folder, late, parallel, unit
    from grading.course import ChapterError
    from grading.submissions import Unusable
    from helpers.exercises import manifest

    return (
        Unusable,
        manifest.ManifestError,
        choice.ChoiceError,
        ChapterError,
        folder.FolderError,
        parallel.ClusterError,
        late.PolicyError,
        adjustments.AdjustmentError,
        anonymous.AnonymousError,
        unit.Mismatch,
    )


def _warn(skipped: list[Path], sandbox: str, console) -> None:
    """Say what is no submission, and that the learners' code runs without protection."""
    from grading.reports import safe

    for path in skipped:  # a learner's archive may have given it any name
        console.print(f'{safe.line(str(path), 1000)}: no submission, left out', style='yellow', markup=False)
    if sandbox == 'none':
        console.print(sandboxes.WARNING, style='bold yellow', markup=False)


def _summary(records, console) -> int:
    """Say what is open. The exit status: 1 if a mark is, because of a fault of the grader's."""
    ungraded = [record.learner for record in records if record.status == 'incomplete']
    if ungraded:
        console.print(
            f'Not all is graded yet for {", ".join(ungraded)}: run grade again without --only.',
            style='yellow',
            markup=False,
        )
    faults = {
        record.learner: [one.id for one in record.exercises if record.marks[one.id] is None]
        for record in records
        if record.status == 'grader_error'
    }
    if faults:
        named = ', '.join(f'{learner} ({", ".join(exercises)})' for learner, exercises in faults.items())
        console.print(
            f"A fault of the grader's own left marks open for {named}: see run.log and run grade again.",
            style='red',
            markup=False,
        )
    return 1 if faults else 0
