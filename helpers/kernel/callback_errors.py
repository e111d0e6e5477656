"""An exception in a callback: how it is shown, and the CallbackError that the next wait raises."""

import sys
import traceback
from collections.abc import Callable
from pathlib import Path

from helpers.kernel import journal

_RULE = '─' * 68  # with its corner, it fits into a pane of 700 pixels
_HELPERS = Path(__file__).parents[1]
_ROOMS = tuple(_HELPERS / room for room in ('kernel', 'show', 'programs', 'exercises'))  # whose frames are not shown
# What rclpy says about a mistake -> what the mistake is. rclpy 7.1.9 words some of them differently from 7.1.6.
_HINTS = (
    ('generator already executing', 'One executor is spun twice. Inside a callback do not spin: `await` the future.'),
    ('already spinning', 'One executor is spun twice. Inside a callback do not spin: `await` the future.'),
    ('destruction was requested', 'This node, publisher or client was destroyed: run the cell that creates it again.'),
)
# What else can say something about an exception: the sentence, or ''. The kernel's extension adds to these.
further_hints: list[Callable[[BaseException], str]] = []


class CallbackError(RuntimeError):
    """A callback raised. ``__cause__`` is the exception; ``node`` and ``callback`` say where it happened."""

    def __init__(self, node: str, callback: str, error: BaseException, times: int = 1, others: int = 0):
        self.node = node
        self.callback = callback
        again = f' ({times} times)' if times > 1 else ''
        more = f'; {others} more callback(s) raised too' if others else ''
        super().__init__(f'{callback} of node {node} raised {type(error).__name__}: {error}{again}{more}')
        self.__cause__ = error


class Failure:
    """One place where callbacks raise: node, callback, and how often."""

    def __init__(self, node: str, callback: str, error: BaseException):
        self.node = node
        self.callback = callback
        self.error = error.with_traceback(learners_part(error.__traceback__))
        self.times = 1
        self.shown_in = -1  # number of the cell run

    @property
    def place(self) -> tuple:
        """Equal for two failures at the same place, so that a timer that raises at every tick is shown once."""
        frames = traceback.extract_tb(self.error.__traceback__)
        last = (frames[-1].filename, frames[-1].lineno) if frames else None
        return self.node, self.callback, type(self.error), last

    def show(self) -> None:
        """Write the failure to stderr (in a kernel, the running cell's output), in one piece and once in a cell run."""
        if self.shown_in == journal.number():
            return
        self.shown_in = journal.number()
        lines = [f'An exception in {self.callback} of node {self.node}', '', *self._traceback_lines()]
        advice = hint(self.error)
        if advice:
            lines += ['', *advice.splitlines()]
        lines += ['', 'All nodes go on. The next spin_for, wait_for or collect raises this as a CallbackError.']
        box = ''.join(f'│ {line}'.rstrip() + '\n' for line in lines)
        say(f'┌{_RULE}\n{box}└{_RULE}\n')

    def _traceback_lines(self) -> list[str]:
        summary = traceback.TracebackException.from_exception(self.error)
        _name_cells(summary)
        return ''.join(summary.format()).splitlines()


def raise_failures(failures: list[Failure]) -> None:
    """Raise the first of ``failures`` as a CallbackError that names how many others there are; nothing if empty."""
    __tracebackhide__ = True
    if failures:
        first = failures[0]
        raise CallbackError(first.node, first.callback, first.error, first.times, len(failures) - 1)


def hint(error: BaseException) -> str:
    """Return what to do about a well-known mistake, or ''."""
    text = str(error)
    known = [advice for fragment, advice in _HINTS if fragment in text]
    return next(iter(known), '') or next((said for ask in further_hints if (said := ask(error))), '')


def say(text: str) -> None:
    """Write ``text`` to stderr; at the end of the process, when stderr may be closed, do nothing."""
    try:
        sys.stderr.write(text)
        sys.stderr.flush()
    except (AttributeError, OSError, ValueError):
        pass


def learners_part(tb):
    """Cut the frames of rclpy and of this package off the top: a learner's traceback begins in the learner's code."""
    whole = tb
    while tb is not None and _is_machinery(tb.tb_frame.f_code.co_filename):
        tb = tb.tb_next
    return tb or whole


def _is_machinery(filename: str) -> bool:
    path = Path(filename)
    return path.parent.name == 'rclpy' or path.parent in _ROOMS


def _name_cells(summary: traceback.TracebackException) -> None:
    """Show ``Cell In[3]`` instead of the temporary file name that IPython gives a cell."""
    naming = getattr(getattr(journal.shell(), 'compile', None), 'format_code_name', None)
    if naming is None:
        return
    for frame in summary.stack:
        _ = frame.line  # read the source line before the name of its file changes
        label = naming(frame.filename)
        if label:
            frame.filename = ' '.join(label)
    for chained in (summary.__cause__, summary.__context__):
        if chained is not None:
            _name_cells(chained)
