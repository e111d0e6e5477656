"""A learner's program, loaded from its cells, and what its errors say."""

import __future__

import ast
import asyncio
import functools
import inspect
import linecache
import operator
import re
import sys
import traceback
import types
from collections.abc import Sequence
from contextlib import nullcontext, suppress
from typing import Any

from rclpy.node import Node

from helpers.runner.mistakes import MistakeWatch, WaitsInCallback
from helpers.runner.rclpy_changes import on_trial


class RequestError(Exception):
    """A request that the learner's code made fail; `kind` and fields go to the tests' side."""

    def __init__(self, kind: str, **fields):
        super().__init__(kind)
        self.fields = {'kind': kind, **fields}


class _Lines(Sequence):
    """The lines of a source that stands further down in its cell: empty ones before it, which take no memory."""

    def __init__(self, source: str, line: int):
        """`line`: the number of the source's first line."""
        self._before, self._lines = line - 1, source.splitlines(True)

    def __len__(self) -> int:
        return self._before + len(self._lines)

    def __getitem__(self, index):
        places = range(len(self))[index]
        return (
            [self[place] for place in places]
            if isinstance(places, range)
            else ('\n' if places < self._before else self._lines[places - self._before])
        )


_FUTURE = functools.reduce(
    operator.or_, (getattr(__future__, name).compiler_flag for name in __future__.all_feature_names)
)


def _compiled(source: str, line: int, filename: str, flags: int):
    """The code of a source whose first line has this number. As in notebooks, it may await outside of functions."""
    flags |= ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
    if line == 1:
        return compile(source, filename, 'exec', flags, dont_inherit=True)
    tree = ast.increment_lineno(ast.parse(source, filename), line - 1)
    return compile(tree, filename, 'exec', flags, dont_inherit=True)


def _destroy(node: Node) -> None:
    with suppress(Exception):  # the learner's destroy_node may raise; or it is destroyed
        node.destroy_node()


class LoadedProgram:
    """The learner's code, loaded into a module of its own."""

    def __init__(self) -> None:
        self.module = types.ModuleType('notebook')
        self.notes: list[tuple[str, str]] = []  # cells that could not be run: their text, and what happened
        self.watch: MistakeWatch | None = None
        self.labels: dict[str, str] = {}
        # In notebooks these are there without an import.
        vars(self.module).update(display=lambda *objects, **options: None, get_ipython=_shell)
        sys.modules['notebook'] = self.module

    def load(self, cells: list[dict]) -> None:
        """Run the cells; they have `label`, `source`, `line` (of the source's beginning) and `required`.

        An exception in a cell that is not required is remembered in `notes`; in the required one it is a RequestError,
        and so is the end of the process in a trial below the answer.
        """
        own = cells[-1]['label']
        tried: list[Node] = []
        flags = 0  # of `from __future__ import …`, which holds for all later cells, as in the notebook
        for number, cell in enumerate(cells):
            filename = f'<cell {number}>'
            self.labels[filename] = cell['label']
            # For tracebacks: the learner's own lines.
            lines: Any = _Lines(cell['source'], cell['line'])  # any sequence will do
            linecache.cache[filename] = (len(cell['source']), None, lines, filename)
            try:
                # Names are resolved when a function runs, so annotations and defaults behave as in the notebook.
                code = _compiled(cell['source'], cell['line'], filename, flags)
                flags |= code.co_flags & _FUTURE
                with nullcontext() if cell['required'] else on_trial(tried):
                    awaited = eval(code, self.module.__dict__)  # noqa: S307 - the code is the learner's, and is to run
                    if inspect.iscoroutine(awaited):
                        asyncio.run(awaited)
            except BaseException as error:  # noqa: BLE001 - SystemExit in a cell, too
                if cell['required'] or cell['label'] == own and not isinstance(error, Exception):
                    raise self.error('load', error) from None
                self.notes.append((cell['source'], f'{cell["label"]}: {type(error).__name__}: {_text(error)}'))
        for node in tried:  # before a test listens, so that it never knows of them
            _destroy(node)

    def find(self, name: str):
        """The learner's object of that name; RequestError `missing` if there is none."""
        try:
            return getattr(self.module, name)
        except AttributeError:
            raise RequestError('missing', name=name) from None

    def destroy_instances(self, of: Any) -> None:
        """Destroy the nodes of this class that a name is bound to, or a list: the cell tried it above its last name."""
        if not (isinstance(of, type) and issubclass(of, Node)):
            return
        for value in list(vars(self.module).values()):
            for node in value if isinstance(value, (list, tuple)) else [value]:
                if type(node) is of:
                    _destroy(node)

    def error(self, where: str, error: BaseException, **fields) -> RequestError:
        """A RequestError that tells of `error` with the learner's own lines only."""
        if isinstance(error, RequestError):
            return error
        lines = self.lines(traceback.extract_tb(error.__traceback__))
        if isinstance(error, WaitsInCallback):
            return RequestError('waits', call=error.call, lines=lines)
        if isinstance(error, SyntaxError) and error.filename in self.labels:
            lines.append(
                {
                    'cell': self.labels[error.filename],
                    'line': error.lineno,
                    'function': '',
                    'code': (error.text or '').strip(),
                }
            )
        if isinstance(error, AttributeError) and self.watch is not None and self.watch.early:
            file, line = self.watch.early
            fields['early'] = f'at {self.labels.get(file, "your cell")}, line {line}'
        return RequestError(
            'exception',
            where=where,
            type=type(error).__name__,
            text=_text(error),
            lines=lines,
            notes=self.notes_on(error),
            **fields,
        )

    def notes_on(self, error: BaseException) -> list[str]:
        """What happened to the cells that could not be run and that hold the name that is missing."""
        name = getattr(error, 'name', None) or _text(error)
        return [note for source, note in self.notes if re.search(rf'\b{re.escape(name)}\b', source)][-5:]

    def lines(self, frames) -> list[dict]:
        """Those of the stack's frames (oldest first) that are the learner's."""
        found = [
            {
                'cell': self.labels[frame.filename],
                'line': frame.lineno,
                'function': frame.name,
                'code': (linecache.getline(frame.filename, frame.lineno) or '').strip()[:200],
            }
            for frame in frames
            if frame.filename in self.labels
        ]
        return found[:3] + found[-7:] if len(found) > 10 else found


def _shell():
    """Stands for IPython: whatever a cell asks of it is not done, as a line magic is left out."""
    from unittest.mock import MagicMock  # takes time to import, and few cells need it

    return MagicMock(name='get_ipython()')


def _text(error: BaseException) -> str:
    try:
        return str(error)[:2000]
    except BaseException:  # noqa: BLE001 - a learner's __str__ may raise, SystemExit too
        return ''
