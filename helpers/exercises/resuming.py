"""`resume()`: what the cells above define, brought back after a restart of the kernel, without their demonstrations.

From each cell above the running one come its imports, functions, classes and constants. A cell with the tag `resume`
runs whole: it makes something that the cells below need, such as a workspace. The cells are read from the notebook's
file, as it was last saved.
"""

import os
import time
from collections.abc import Iterator, Set
from pathlib import Path

from helpers.exercises import definitions, notebooks
from helpers.exercises.notebooks import NotebookCell
from helpers.kernel import journal

WHOLE = 'resume'  # the tag of a cell that runs whole
_SHOWN = 12  # names in the message


def resume() -> None:
    """Bring back what the cells above this one define. Demonstrations, checks and exercises do not run.

    Nothing is raised: what cannot be brought back is named.
    """
    if 'COURSE_RUNNER' in os.environ:
        return  # the cell is itself being tested
    shell = journal.shell()
    if shell is None:
        print('resume() works in a notebook.')
        return
    above = cells_above()
    if above is None:
        print(
            'This cell is not in a saved notebook of this folder yet: save the notebook (Ctrl+S), '
            'then run the cell again.'
        )
        return
    before, problems = set(shell.user_ns), []
    running = journal.cells.pop() if journal.cells else None
    for cell in above:
        problems += _run_whole(shell, cell) if WHOLE in cell.tags else _run_definitions(shell, cell)
        journal.cells.append(journal.ExecutedCell(cell.id, cell.source, time.time()))  # for checks
    if running:
        journal.cells.append(running)
    print(_summary(len(above), sorted(set(shell.user_ns) - before)))
    for cell, error in problems:
        if isinstance(error, NameError) and _demonstrated(error.name, above):
            continue  # made of what a demonstration has made, and so a part of it
        print(f'Not brought back: a part of {cell.label} ({type(error).__name__}: {error}).')


def cells_above() -> list[NotebookCell] | None:
    """The code cells above the running one, in its notebook as it was last saved; None if it is in none."""
    if not journal.cells:
        return None
    running = journal.cells[-1]
    for path in _notebooks():
        try:
            cells = notebooks.read(path)
        except notebooks.InvalidSubmission:
            continue
        # Some front ends send no id; there the text must do.
        found = [cell for cell in cells if running.id and cell.id == running.id] or [
            cell for cell in cells if not running.id and cell.source.strip() == running.source.strip()
        ]
        if found:
            return cells[: cells.index(found[-1])]
    return None


def brought_back(cell: NotebookCell) -> Set[str]:
    """The names that `resume` takes from a cell."""
    if WHOLE in cell.tags:
        return definitions.names_in(cell.source)
    return {name for _, text in definitions.of_cell(cell) for name in definitions.names_in(text)}


def _demonstrated(name: str | None, cells: list[NotebookCell]) -> bool:
    """Whether these cells define a name, and only in demonstrations."""
    return any(name in definitions.names_in(cell.source) for cell in cells) and not any(
        name in brought_back(cell) for cell in cells
    )


def _notebooks() -> Iterator[Path]:
    """The notebook of this kernel, if its front end says which that is; then all of this folder."""
    if own := journal.notebook():
        yield own
    yield from sorted(Path.cwd().glob('*.ipynb'))


def _run_definitions(shell, cell: NotebookCell) -> list[tuple[NotebookCell, Exception]]:
    problems = []
    for line, text in definitions.of_cell(cell):
        try:
            # Empty lines before it, so that a traceback names the line of the cell.
            exec(compile('\n' * (line - 1) + text, f'<{cell.label}>', 'exec'), shell.user_ns)
        except Exception as error:  # noqa: BLE001 - the others are brought back all the same
            problems.append((cell, error))
    return problems


def _run_whole(shell, cell: NotebookCell) -> list[tuple[NotebookCell, Exception]]:
    from IPython.utils.capture import capture_output

    with capture_output():
        result = shell.run_cell(cell.source, store_history=False, silent=True)
    error = result.error_before_exec or result.error_in_exec
    return [(cell, error)] if isinstance(error, Exception) else []


def _summary(count: int, names: list[str]) -> str:
    told = [name for name in names if not name.startswith('_')]
    if not told:
        return f'Nothing was missing: all that the {count} cells above define is there.'
    more = f' and {len(told) - _SHOWN} more names' if len(told) > _SHOWN else ''
    return f'Back from the {count} cells above: {", ".join(told[:_SHOWN])}{more}.'
