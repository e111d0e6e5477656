"""Explains what the errors of a cell do not say. After a NameError: which cell above would have defined the name, and
how to get it back, or why it did not, or how the name is imported. After an InvalidHandle: what has become of the node.
After an import that the stop button has cut: why it fails from now on. After other errors: what the check of an
exercise would say.

The kernel `course` loads this as an IPython extension when it starts, as a person who goes on in the middle of a
notebook after a restart has not imported `helpers` yet.
"""

import linecache
import re
import traceback
from collections.abc import Iterable

from helpers.exercises import definitions, resuming
from helpers.exercises.notebooks import NotebookCell
from helpers.kernel import callback_errors, journal

ADVICE = """To bring back what the cells above define, without their demonstrations, run in a cell here:
    from helpers import resume; resume()"""
DESTROYED = """This cell uses a node, or a part of one, that has been destroyed: by a cell that ran since, or by
the end of its spinning. Run the cell that makes it again, then this one."""
AGAIN = 'It is part of a demonstration: run that cell again.'
HALF_IMPORTED = """A package was stopped in the middle of its import, and Python cannot import it again in this kernel.
Restart the kernel (in the menu: Kernel, Restart Kernel). Then run the cells from the top, or in a cell here:
    from helpers import resume; resume()"""
# What is said of a compiled module that was imported by half; the text below has other causes, too.
_CUT = (
    'cannot load module more than once per process',
    'is already registered!',  # pybind11
    'initialization failed',
    'CPU dispatcher tracer already',  # numpy for Python 3.10
)
_CUT_IF_STOPPED = 'partially initialized module'
_stopped = False  # whether a cell has been stopped in this kernel
# The texts of the cells that have run, and the names that the latest run did not reach; None if it came to its end.
_not_reached: dict[str, frozenset[str] | None] = {}


def load_ipython_extension(shell) -> None:
    """Explain the errors of cells, and of callbacks, from now on; idempotent."""
    unload_ipython_extension(shell)
    shell.events.register('post_run_cell', explain)
    callback_errors.further_hints.append(sentence)


def unload_ipython_extension(shell) -> None:
    """Explain no more."""
    if explain in shell.events.callbacks['post_run_cell']:
        shell.events.unregister('post_run_cell', explain)
    if sentence in callback_errors.further_hints:
        callback_errors.further_hints.remove(sentence)


def explain(result) -> None:
    """Print what the error of a cell means, if there is more to say than Python does.

    :param result: IPython's of the cell; None if it was interrupted before it began
    """
    global _stopped
    error = result.error_in_exec if result else None
    _stopped |= isinstance(error, KeyboardInterrupt)
    if result:
        text = result.info.raw_cell
        _not_reached[text] = None if result.success else definitions.names_not_reached(text, _line(text, error))
    if said := sentence(error, result.info.raw_cell) if error else '':
        print(said)


def _line(text: str, error: BaseException | None) -> int:
    """The number of the line of a cell in which an error was raised; one behind its end if it cannot be told."""
    for frame, line in traceback.walk_tb(error.__traceback__ if error else None):
        if ''.join(linecache.getlines(frame.f_code.co_filename)).strip() == text.strip():
            return line
    return len(text.splitlines()) + 1


def sentence(error: BaseException, cell: str = '') -> str:
    """What an error means, in a sentence or two; '' if there is no more to say than Python does.

    :param cell: the text of the cell that has raised it; '' if a callback has
    """
    if type(error).__name__ == 'InvalidHandle':  # rclpy's; cells run out of order, or one is run again alone
        return f'{DESTROYED}\n{_on_a_cell_left_out(definitions.names_used(cell))}'.strip()
    if _is_half_imported(error):
        return HALF_IMPORTED
    if isinstance(error, NameError) and error.name:
        return _on_name(error.name, error)
    if not isinstance(error, Exception):
        return ''
    if isinstance(error, AttributeError) and error.name:
        used = re.findall(rf'\b([^\W\d]\w*)\.{re.escape(error.name)}\b', cell)
        return _on_a_cell_left_out(used) or _as_a_check(error, cell)
    return _as_a_check(error, cell) or _on_a_cell_left_out(definitions.names_used(cell))


def _on_a_cell_left_out(names: Iterable[str]) -> str:
    """Which cell above makes one of these names anew and did not come so far; '' if none.

    Then the name is still what an earlier cell has made.
    """
    above = resuming.cells_above() or []
    for name in sorted(names):
        makers = [one for one in above if name in definitions.names_given(one.source)]
        if not makers:
            continue
        if not _has_run(makers[-1]):
            why = 'has not run since the kernel started'
        elif name in (_not_reached.get(makers[-1].source) or ()):
            why = 'ended with an error'
        else:
            continue
        return (
            f'`{name}` is here what an earlier cell has made. The cell above that makes it anew {why}: '
            f'{_first_line(makers[-1])}'
        )
    return ''


def _has_run(cell: NotebookCell | journal.ExecutedCell) -> bool:
    """Whether a cell of the file has run; perhaps with another text, if it was changed and not saved."""
    return any(cell.source == one.source or (cell.id and cell.id == one.id) for one in journal.cells)


def _first_line(cell: NotebookCell | journal.ExecutedCell) -> str:
    return cell.source.strip().partition('\n')[0]


def _on_name(name: str, error: NameError) -> str:
    """Where a missing name is defined, if that is in a cell above which has not run, or from where it is imported, or
    what is meant: another name, or an attribute of the class.
    """
    from helpers.runner import imports, similar

    ran = {cell.source for cell in journal.cells}
    for cell in reversed(resuming.cells_above() or []):
        if name in definitions.names_in(cell.source) and cell.source not in ran:
            if _has_run(cell):
                changed = f'`{name}` comes from a cell above that was changed since it ran: {_first_line(cell)}'
                return f'{changed}\nRun it again.'
            said = f'`{name}` comes from a cell above that has not run since the kernel started: {_first_line(cell)}'
            return f'{said}\n{ADVICE if name in resuming.brought_back(cell) else AGAIN}'
    if said := _in_a_cell_that_ran(name):
        return said
    import helpers

    here = [one for cell in journal.cells for one in definitions.names_in(cell.source)]
    if said := _slip(name, error):
        return said
    if advice := imports.advice(name):
        return advice
    if name in dir(helpers):
        return f'`{name}` belongs to the course. Write: from helpers import {name}'
    near = similar.nearest(name, here, 0.8) or imports.nearest(name)
    return f'Nothing is called `{name}` here. Is `{near}` meant?' if near else ''


def _slip(name: str, error: NameError) -> str:
    """What the text around the line that lacks a name shows: a missing `self.`, a class in small letters; else ''."""
    try:
        from helpers.runner import slips
    except ImportError:  # no ROS can be loaded here
        return ''
    frames = [
        (linecache.getlines(frame.f_code.co_filename), line) for frame, line in traceback.walk_tb(error.__traceback__)
    ]
    lines, number = frames[-1] if frames else ([], 0)
    text = ''.join(lines)
    return slips.class_meant(name, text) or slips.missing_self(name, text, ''.join(lines[number - 1 : number]))


def _in_a_cell_that_ran(name: str) -> str:
    """Why a name is missing that a cell makes which did run; '' if none does."""
    makers = [cell for cell in journal.cells if name in definitions.names_in(cell.source)]
    if not makers:
        return ''
    running = journal.cells[-1]
    others = [one for one in makers if one.source != running.source and (not one.id or one.id != running.id)]
    maker = (others or makers)[-1]
    if not others:
        if re.search(rf'^\s*{name}\s*[-+*/|]=', maker.source, re.MULTILINE):
            return (
                f'`{name}` has no value yet. Give it a first one, such as {name} = 0, before the line that changes it.'
            )
        return f'`{name}` has no value yet: the line of this cell that gives it one has not run.'
    if maker.source not in _not_reached:  # `resume` has noted it
        return f'`{name}` comes from a cell above that has run in part, for `resume`: {_first_line(maker)}\n{AGAIN}'
    if _not_reached[maker.source] is not None:
        return (
            f'`{name}` comes from a cell that ended with an error, before the line that makes `{name}`: '
            f'{_first_line(maker)}\nMend that cell and run it again, then this one.'
        )
    return f'`{name}` has been deleted since. This cell makes it; run it again: {_first_line(maker)}'


def _as_a_check(error: Exception, cell: str) -> str:
    """What the check of an exercise would say of this error."""
    # Of a missing module it says what counts when the exercise is judged; an error without a text is in chapter 4.
    if isinstance(error, ModuleNotFoundError) or not str(error):
        return ''
    try:
        from helpers.runner import explanations
    except ImportError:  # no ROS can be loaded here
        return ''
    owner = re.match(r"'(\w+)' object has no attribute", str(error))
    texts = [cell, *(one.source for one in reversed(journal.cells))]
    defining = (one for one in texts if owner and re.search(rf'^class {owner[1]}\b', one, re.MULTILINE))
    frames = traceback.extract_tb(error.__traceback__)
    lines = [frame.line for frame in frames if frame.line and any(frame.line in one for one in texts)]
    answer = next(defining, cell)
    return explanations.explain(type(error).__name__, str(error), answer=answer, lines=lines, cells=texts)


def _is_half_imported(error: BaseException | None) -> bool:
    """Whether an import fails because an earlier one was stopped in its middle."""
    texts = (*_CUT, _CUT_IF_STOPPED) if _stopped else _CUT
    return isinstance(error, ImportError | AttributeError | RuntimeError) and any(text in str(error) for text in texts)
