"""Which cells this kernel has executed, in order; empty in a plain Python process.

``check`` reads the text of exercise cells from here (it works in an unsaved notebook too), and `helpers.nodes` learns
from it whether a node was made in an earlier cell. IPython's ``pre_run_cell`` event is used, because nbval executes
with ``store_history=False`` and then IPython's own history stays empty.
"""

import sys
from typing import NamedTuple


class Cell(NamedTuple):
    """One execution of a cell."""

    id: str | None  #: the notebook's cell id; None if the front end does not send it (nbval, nbclient)
    source: str


cells: list[Cell] = []
_shell = None


def in_kernel() -> bool:
    """Tell whether this process is an IPython session (a Jupyter kernel or a terminal)."""
    return _interactive_shell() is not None


def number() -> int:
    """Return how many cells have been executed, the running one included; 0 outside IPython."""
    return len(cells)


def latest(cell_id: str) -> Cell | None:
    """Return the latest execution of the cell with this id, or None."""
    return next((cell for cell in reversed(cells) if cell.id == cell_id), None)


def start() -> None:
    """Begin to note cells; idempotent. Cells executed earlier and the running cell are noted as far as IPython knows."""
    global _shell
    shell = _interactive_shell()
    if shell is None or shell is _shell:
        return
    _shell = shell
    running = _running_cell(shell)
    earlier = [source for source in shell.user_ns.get('In', [])[1:] if source]
    if running and earlier and earlier[-1] == running.source:
        earlier.pop()
    cells.extend(Cell(None, source) for source in earlier)
    if running:
        cells.append(running)
    shell.events.register('pre_run_cell', _note)


def _note(info) -> None:
    cells.append(Cell(getattr(info, 'cell_id', None), info.raw_cell))


def _interactive_shell():
    ipython = sys.modules.get('IPython')
    return ipython.get_ipython() if ipython else None


def _running_cell(shell) -> Cell | None:
    """The cell that imports this package: its pre_run_cell event came before anybody listened."""
    kernel = getattr(shell, 'kernel', None)
    message = kernel.get_parent('shell') if kernel else None
    if not message or message.get('msg_type', message.get('header', {}).get('msg_type')) != 'execute_request':
        return None
    return Cell(message.get('metadata', {}).get('cellId'), message['content']['code'])
