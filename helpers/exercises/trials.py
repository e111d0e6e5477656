"""An exercise's cell with which its learner also tries the answer: what stands below it must not cost marks.

In the notebook a class may be tried in the cell that defines it. In a check such a trial cannot work: nothing spins
while the program is loaded, time stands still, and programs beside it would be strangers.
"""

import ast
from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace

from helpers.exercises import cell_python, definitions

# Functions of `helpers` that wait, spin nodes or start programs, and what others call so: `rclpy.spin`, `time.sleep`.
_LIVE = frozenset({'background', 'collect', 'spin_for', 'spinning', 'timeline', 'wait_for'})
_LIVE_METHODS = frozenset(
    'call send_goal sleep sleep_for sleep_until spin spin_once spin_once_until_future_complete '
    'spin_until_future_complete wait_for_message wait_for_server wait_for_service'.split()
)
_MOST = 200  # parts; nobody writes so many by hand


@dataclass(frozen=True)
class Part:
    """Statements of a cell."""

    line: int  # of the cell, the first one is 1
    text: str
    required: bool  # an exception in it means that the program cannot be loaded
    left_out: bool = False  # it waits, spins nodes or starts programs


def parts(source: str, names: Collection[str], others: Iterable[str] = ()) -> list[Part]:
    """The parts of an exercise's cell, which is Python and defines `names`: the answer, and below it each trial alone.

    What stands below the names and only defines, or binds one of them anew, is a part of the answer. A cell without a
    trial, or with very many, is one part.

    :param others: definitions of other cells
    :raises SyntaxError: it is not Python.
    """
    body, missing, first = ast.parse(source).body, set(names), 0
    while missing or first < len(body) and not _is_trial(body[first], names):
        if first == len(body):
            return [Part(1, source, True)]
        missing -= definitions.defined([body[first]])
        first += 1
    if first == len(body):
        return [Part(1, source, True)]
    lines, ends = definitions.lines(source), body[first - 1].end_lineno or 0
    live = _live_functions([body, *map(_body, others)])
    found = [Part(1, ''.join(lines[:ends]), True)]
    for node in body[first:]:
        start, end, trial = definitions.first_line(node), node.end_lineno or 0, _is_trial(node, names)
        if start > ends:
            found.append(Part(start, ''.join(lines[start - 1 : end]), not trial, trial and _is_live(node, live)))
        else:  # it begins in the line in which the one before ends
            one = found.pop()
            left_out = one.left_out or trial and _is_live(node, live)
            found.append(Part(one.line, one.text + ''.join(lines[ends:end]), one.required or not trial, left_out))
        ends = end
    if len(found) > _MOST:
        return [Part(1, source, True)]
    return [replace(one, left_out=one.left_out and not one.required) for one in found]


def _body(source: str) -> list[ast.stmt]:
    tree = cell_python.syntax_tree(source)
    return tree.body if tree else []


def _is_trial(node: ast.stmt, names: Collection[str]) -> bool:
    """Whether a statement below the answer does more than define, and does not bind one of its names anew."""
    harmless = isinstance(node, ast.Pass) or definitions.is_definition(node)
    return not harmless and not definitions.defined([node]) & set(names)


def _is_live(node: ast.stmt, live: Collection[str]) -> bool:
    """Whether a statement calls something that waits, spins nodes or starts programs; `live` are functions that do."""
    if isinstance(node, ast.If) and any(
        isinstance(part, ast.Name) and part.id == '__name__' for part in ast.walk(node.test)
    ):
        return False  # it is for a program that is started by itself, and does nothing in a check
    called = [part.func for part in ast.walk(node) if isinstance(part, ast.Call)]
    return any(one.attr in _LIVE_METHODS for one in called if isinstance(one, ast.Attribute)) or any(
        one.id in live for one in called if isinstance(one, ast.Name)
    )


def _live_functions(bodies: Iterable[list[ast.stmt]]) -> set[str]:
    """The names of functions that wait, spin nodes or start programs, themselves or in what they call."""
    functions = {
        node.name: node for body in bodies for node in body if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))
    }
    callers: dict[str, set[str]] = {}
    for name, node in functions.items():
        for part in ast.walk(node):
            if isinstance(part, ast.Call) and isinstance(part.func, ast.Name):
                callers.setdefault(part.func.id, set()).add(name)
    waiting = [name for name, node in functions.items() if _is_live(node, _LIVE)]
    return definitions.reached([*_LIVE, *waiting], lambda name: callers.get(name, ()))
