"""Which cells this kernel has executed, in order; empty in a plain Python process.

``check`` reads the text of exercise cells from here (it works in an unsaved notebook too), and `kernel.nodes` learns
from it whether a node was made in an earlier cell. IPython's ``pre_run_cell`` event is used, because nbval executes
with ``store_history=False`` and then IPython's own history stays empty.
"""

import os
import re
import sys
import time
from pathlib import Path
from typing import NamedTuple


class ExecutedCell(NamedTuple):
    """One execution of a cell."""

    id: str | None  #: the notebook's cell id; None if the front end does not send it (nbval, nbclient)
    source: str
    moment: float = 0.0  #: when it began, in seconds since 1970; 0 if it ran before anybody listened


_ADDED = re.compile(r'[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}')

cells: list[ExecutedCell] = []
_noting = None  # the IPython shell whose cells are noted


def shell():
    """Return the IPython shell of this process, or None."""
    ipython = sys.modules.get('IPython')
    return ipython.get_ipython() if ipython else None


def in_kernel() -> bool:
    """Tell whether this process is an IPython session (a Jupyter kernel or a terminal)."""
    return shell() is not None


def notebook() -> Path | None:
    """The file of this kernel's notebook, under the name that it had at the kernel's start; None if nobody says it.

    JupyterLab says it in the environment, VS Code in a variable of the notebook.
    """
    ipython = shell()
    said = [os.environ.get('JPY_SESSION_NAME'), ipython and ipython.user_ns.get('__vsc_ipynb_file__')]
    return next((Path(name) for name in said if isinstance(name, str) and name.endswith('.ipynb')), None)


def number() -> int:
    """Return how many cells have been executed, the running one included; 0 outside IPython."""
    return len(cells)


def latest(cell_id: str) -> ExecutedCell | None:
    """Return the latest execution of the cell with this id, or None."""
    return next((cell for cell in reversed(cells) if cell.id == cell_id), None)


def in_own_cell() -> bool:
    """Tell whether the learner has added the running cell: JupyterLab gives such a cell a UUID, the course does not."""
    return bool(cells and _ADDED.fullmatch(cells[-1].id or ''))


def start() -> None:
    """Begin to note cells; idempotent. The running cell, and earlier ones that IPython remembers, are noted too."""
    global _noting
    ipython = shell()
    if ipython is None or ipython is _noting:
        return
    _noting = ipython
    running = _running_cell(ipython)
    earlier = [source for source in ipython.user_ns.get('In', [])[1:] if source]
    if running and earlier and earlier[-1] == running.source:
        earlier.pop()
    cells.extend(ExecutedCell(None, source) for source in earlier)
    if running:
        cells.append(running)
    ipython.events.register('pre_run_cell', _note)


def _note(info) -> None:
    cells.append(ExecutedCell(getattr(info, 'cell_id', None), info.raw_cell, time.time()))


def _running_cell(ipython) -> ExecutedCell | None:
    """The cell that imports this package: its pre_run_cell event came before anybody listened."""
    kernel = getattr(ipython, 'kernel', None)
    message = kernel.get_parent('shell') if kernel else None
    if not message or message.get('msg_type', message.get('header', {}).get('msg_type')) != 'execute_request':
        return None
    return ExecutedCell(message.get('metadata', {}).get('cellId'), message['content']['code'])
