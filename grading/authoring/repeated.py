"""The notebooks that CI gives to nbval, each with a check at its end that nothing is left over.

Checked statements run after their cells.

A solved notebook can run twice in one kernel. The learner's has the same cells with stubs in them, so that its second
run would prove what that of the solved one proves: it runs once.
"""

import random
from collections.abc import Callable
from pathlib import Path

import nbformat
from nbformat import NotebookNode

from grading.authoring import checked

NEVER, ONCE, TWICE = (), ('first',), ('first', 'second')
SKIP = 'nbval-skip'
IGNORE = {'tags': ['nbval-ignore-output']}
# In which order the chapters begin. They take, beside three others, about 117, 78, 78, 53, 50, 62, 56 and 41 s: with
# these numbers four workers end sooner in no other order.
ORDER = ('07', '05', '08', '03', '06', '04', '02', '01')


def repeated(notebook: NotebookNode, folder: Path, runs: tuple[str, ...]) -> NotebookNode:
    """Return ``notebook`` with all of its cells once for each of ``runs``; they run in ``folder``, wherever it is kept.

    Outputs are kept, so all runs are compared with them; a cell that was never executed is not compared. What is tagged
    nbval-skip takes long: only a solved notebook that runs twice runs it, and compares it, the first time.
    """
    cells = [
        _cell(
            'note',
            f"""\
import os
from grading.authoring import leftovers
os.chdir({str(folder)!r})
leftovers.note()""",
        )
    ]
    if any(checked.KEY in cell.metadata for cell in notebook.cells):
        cells.append(_cell('record', checked.RECORD))
    for run in runs:
        for cell in notebook.cells:
            if cell.cell_type == 'code':
                copy = nbformat.from_dict({**cell, 'id': f'{cell.id}-{run}'})
                if len(runs) > 1 and run == runs[0] and (cell.outputs or cell.execution_count):
                    copy.metadata['tags'] = [tag for tag in cell.metadata.get('tags', []) if tag != SKIP]
                cells.append(copy)
                if checked.KEY in cell.metadata and SKIP not in copy.metadata.get('tags', []):
                    cells.append(_cell(f'{copy.id}-checked', checked.code(cell.metadata[checked.KEY])))
    cells.append(_cell('leftovers', 'from grading.authoring import leftovers\nleftovers.check()'))
    return nbformat.from_dict({**notebook, 'cells': cells})


def all_twice(path: Path) -> tuple[str, ...]:
    """The runs of a notebook if time does not matter."""
    return ONCE if path.parent.name == 'notebooks' else TWICE


def sample(notebooks: list[Path], seed: str) -> Callable[[Path], tuple[str, ...]]:
    """The runs of a notebook in a sample: each solved one runs.

    ``seed`` draws whether another one runs, which costs much: a chapter's solved notebook a second time, or its
    learner's.
    """
    names, draw = sorted({path.name for path in notebooks}), random.Random(f'{seed} notebooks')
    drawn = draw.choice(names) if names and draw.random() < 0.5 else None
    of_learner = draw.random() < 0.5

    def runs(path: Path) -> tuple[str, ...]:
        chosen = path.name == drawn
        if path.parent.name == 'notebooks':
            return ONCE if chosen and of_learner else NEVER
        return TWICE if chosen and not of_learner else ONCE

    return runs


def write(notebooks: list[Path], target: Path, runs: Callable[[Path], tuple[str, ...]] = all_twice) -> list[Path]:
    """Write the repeated form of each notebook below ``target``, in a folder named as its own; return the paths.

    :param runs: the names of a notebook's runs; without one it is left out.

    :raises ValueError: a notebook cannot be read; the message names it.
    """
    written = []
    for path in notebooks:
        if not runs(path):
            continue
        try:
            notebook = nbformat.read(path, as_version=4)
        except (ValueError, nbformat.ValidationError) as error:
            raise ValueError(f'{path.name} is no notebook: {error}') from None
        copy = target / path.parent.name / path.name
        copy.parent.mkdir(parents=True, exist_ok=True)
        nbformat.write(repeated(notebook, path.parent, runs(path)), copy)
        written.append(copy)
    return written


def nbval_arguments(kernel: str, cell_timeout: float = 180.0) -> list[str]:
    """Return pytest's arguments for the repeated notebooks; conftest.py adds the plugin ``nbval_plugin``.

    ``--nbval`` serves both kinds: the cells of a learner's notebook were never executed, so nothing is compared there.

    :param cell_timeout: longest time of one cell, in seconds.
    """
    return [
        '--nbval',
        f'--nbval-kernel-name={kernel}',
        f'--nbval-cell-timeout={cell_timeout:g}',
        f'--timeout={cell_timeout + 30:g}',
        '--dist=loadfile',
        '-p',
        'no:cacheprovider',
    ]


def _cell(identifier, source):
    return nbformat.from_dict(
        {
            'cell_type': 'code',
            'id': identifier,
            'metadata': IGNORE,
            'source': source,
            'execution_count': None,
            'outputs': [],
        }
    )
