"""`check("3.1")`: the visible tests of an exercise, run against the cells of this kernel."""

import os
import unicodedata
from functools import lru_cache
from pathlib import Path

from helpers import paths
from helpers.exercises import progress_file, remarks, start_page
from helpers.kernel import journal


def check(exercise_id: str) -> None:
    """Run the visible tests of an exercise against the latest run of its cell, and show what passed and what did not.

    The tests run in processes of their own: they see the text of your cells, not the state of this kernel.
    Nothing is raised; in a stopped check (the stop button) nothing is shown.
    """
    if 'COURSE_RUNNER' in os.environ:
        return  # the cell is itself being tested
    try:
        report = run_tests(_identity(exercise_id))
    except KeyboardInterrupt:
        print('The check was stopped.')
    except Exception as error:  # noqa: BLE001 - a check never breaks the notebook
        print(f'The check could not run: {error}')
    else:
        _show(report.exercises)
        said = [*remarks.after(report.exercises, _all_executed()), *_unlike_saved(report.exercises)]
        for line in [*said, *_elsewhere(report.exercises)]:
            print(line)
        # Not for copies, nor when an instructor's solutions are built.
        if Path.cwd() == paths.NOTEBOOKS and os.environ.get('COURSE_PROGRESS') != 'off':
            start_page.keep(report)


def _identity(given) -> str:
    """The number of an exercise as its text, also if it was given as a number.

    :raises LookupError: it may be that of two: as numbers, 8.1 and 8.10 are one.
    """
    from helpers.exercises import manifest

    if isinstance(given, float) and f'{given}0' in manifest.load():
        raise LookupError(
            f'{given} and {given}0 are the same number. Write quotes: check("{given}") or check("{given}0").'
        )
    # As it was meant: an input method for Chinese may type wide digits and a wide point.
    return unicodedata.normalize('NFKC', str(given)).strip().rstrip('.')


def run_tests(exercise_id: str):
    """Run the visible tests of one exercise on this kernel's cells.

    :raises LookupError: there is no such exercise.
    :raises helpers.exercises.manifest.ManifestError: the list of exercises is damaged.
    """
    from helpers.exercises import manifest
    from helpers.runner import results, session

    exercises = manifest.load()
    if exercise_id not in exercises:
        raise LookupError(
            f'there is no exercise {exercise_id!r}; there are {manifest.near(exercise_id, exercises)}. '
            '(Sections have numbers of their own: the number of an exercise stands in the heading of its card.)'
        )
    exercise = exercises[exercise_id]
    if exercise.folder:  # its answer is a folder beside the notebook
        seeds = progress_file.seeds([exercise.id])
        return session.run([], [exercise], session.Options(seeds=seeds, folder=Path.cwd()))
    cells = executed(exercise)
    if cells is None:
        return session.SessionReport([results.without_tests(exercise, 'invalid_submission', _not_run(exercise))])
    # Until it passes, a check shows the same values.
    return session.run(
        cells,
        [exercise],
        session.Options(
            seeds=progress_file.seeds([exercise.id]), notebook=_saved(exercise), side_by_side=session.SIDE_BY_SIDE
        ),
    )


def _not_run(exercise) -> str:
    """What to do where no cell of the exercise has been run, or where it has lost its first line."""
    from helpers.exercises import definitions

    heading = f'# Exercise {exercise.id}: {exercise.title}'
    for noted in reversed(journal.cells):
        if set(exercise.names) <= definitions.names_in(noted.source):
            return (
                f'A cell that you ran defines `{exercise.names[0]}`, but its first line is not `{heading}`. The '
                'check knows the cell by this line: write it back, run the cell, and check again.'
            )
    return f'Run the cell that begins with `# Exercise {exercise.id}` first, then check again.'


def _saved(exercise) -> list:
    """The cells of the exercise's notebook as it was last saved; none if it cannot be read."""
    path = paths.NOTEBOOKS / exercise.notebook
    return _read(path, _saved_at(path))


def _saved_at(path: Path) -> float:
    """When a file was last changed, in seconds since 1970; 0 if it is not there."""
    try:
        return path.stat().st_mtime
    except OSError:
        return 0.0


@lru_cache(maxsize=8)
def _read(path: Path, moment: float) -> list:  # by its time, as a check needs it twice and validation takes a while
    from helpers.exercises import notebooks

    try:
        return notebooks.read(path)
    except notebooks.InvalidSubmission:
        return []


def _unlike_saved(results: list) -> list[str]:
    """What is said of an answer, and of cells that a right one needs, if the saved notebook has other ones."""
    from helpers.exercises import manifest

    said: list[str] = []
    for result in results:
        exercise = manifest.load().get(result.id)
        ran = executed(exercise) if exercise is not None and not exercise.folder else None
        if exercise is None or not ran:
            continue
        saved = _saved(exercise)
        edited = _edited_since(exercise, saved)
        if ran[-1].id in edited:
            said.append('The cell of this exercise was changed and saved after you ran it. Run it, and check again.')
        elif result.passed:
            said += [*remarks.lost(ran, saved), *remarks.changed(ran, saved, edited)]
    return said


def _elsewhere(results: list) -> list[str]:
    """What is said of a right answer in a notebook that is not handed in, such as a copy under another name."""
    from helpers.exercises import manifest

    here = journal.notebook()
    if here is None or not here.is_file():
        return []
    here, folder = here.resolve(), paths.NOTEBOOKS.resolve()
    if here.parent == (paths.ROOT / 'solutions').resolve():  # an instructor's
        return []
    exercises = manifest.load()
    return [
        f'This notebook is {os.path.relpath(here, folder)}, and only {exercises[result.id].notebook} is '
        'handed in: copy this cell into it, run it there, and save.'
        for result in results
        if result.passed
        and result.id in exercises
        and not exercises[result.id].folder
        and here != folder / exercises[result.id].notebook
    ]


def _edited_since(exercise, saved: list) -> set[str]:
    """The ids of cells whose text was changed, and saved, after they were last run."""
    moment = _saved_at(paths.NOTEBOOKS / exercise.notebook)
    latest = {noted.id: noted for noted in journal.cells if noted.id}
    return {
        cell.id
        for cell in saved
        if (noted := latest.get(cell.id)) and 0 < noted.moment < moment and noted.source.strip() != cell.source.strip()
    }


def _stand_by(result) -> None:
    """After the cell of an exercise, prepare for its check."""
    from helpers.exercises import program

    if result is None:  # IPython has none where a cell is interrupted before it begins
        return
    first = (result.info.raw_cell or '').lstrip().partition('\n')[0]
    if program.HEADING.match(first):
        from helpers.runner import tests_process

        tests_process.stand_by()


if journal.in_kernel() and 'COURSE_RUNNER' not in os.environ:
    journal.shell().events.register('post_run_cell', _stand_by)


def _all_executed() -> list:
    """The cells of this kernel, in the order of their runs, the newest first."""
    from helpers.exercises import notebooks

    return [notebooks.NotebookCell(noted.source, 0, noted.id) for noted in reversed(journal.cells)]


def executed(exercise) -> list | None:
    """The cells of this kernel, each in its latest version, the exercise's last; None if that has not been run.

    In a notebook one may run cells in any order, so every cell counts as one before the exercise.
    """
    from helpers.exercises import notebooks, program

    latest: dict = {}
    for noted in journal.cells:
        cell = notebooks.NotebookCell(noted.source, 0, noted.id)
        # JupyterLab sends the cell's id. Without it, the version before is known by the heading, or by its text.
        key = noted.id or program.exercise_id(cell) or noted.source
        latest.pop(key, None)  # the newest version comes last
        latest[key] = cell
    ran = list(latest.values())
    claiming = program.of_exercise(ran, exercise)
    if not claiming:
        return None
    # A cell with the heading may also be one that tries the answer, or a copy of the answer from before.
    answers = [cell for cell in claiming if program.defines_all(cell, exercise)]
    claimed = answers or claiming
    # A cell that carries the exercise's id under another heading would count as a second one.
    others = [cell for cell in ran if cell not in claimed and (cell.id is None or cell.id != exercise.cell_id)]
    return [*others, claimed[-1]]


def _show(exercises: list) -> None:
    from helpers.exercises import result_display

    text = result_display.plain(exercises)
    if journal.in_kernel():
        from IPython.display import display as show

        show({'text/html': result_display.html(exercises), 'text/plain': text}, raw=True)
    else:
        print(text)
