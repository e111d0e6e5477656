"""What the line that has raised an exception shows of common slips. Nothing is executed."""

import inspect
import re
from collections.abc import Sequence

from rclpy.clock import Clock
from rclpy.node import Node
from rclpy.task import Future

from helpers.runner import slips

_OF_LISTS_AND_SETS = frozenset('add append discard extend insert remove reverse sort union'.split())
# A method that is called where a callback is given: what it returns would be the callback.
_GIVEN = re.compile(
    r'\b(?:add_done_callback\(|create_timer\([^(),]+,|create_subscription\([^(),]+,[^(),]+,|'
    r'create_service\([^(),]+,[^(),]+,)\s*(self\.\w+)\('
)


def explain(kind: str, text: str, lines: Sequence[str], answer: str) -> str:
    """A sentence on an exception of the type `kind` with this text, or ''.

    :param lines: the learner's lines that have raised it, the innermost one last.
    :param answer: the text of the exercise's cell.
    """
    # Lines in which a call has not come to its end; or it has, and gave None.
    if said := _called_at_once(lines if text == "'NoneType' object is not callable" else lines[:-1]):
        return said
    line = lines[-1] if lines else ''
    if kind == 'AttributeError' and (found := re.match(r"'(\w+)' object has no attribute '([A-Za-z]\w*)'$", text)):
        if found[1] == 'dict':
            return _on_dictionary(found[2], line, answer)
        if found[1] in ('builtin_function_or_method', 'function', 'method'):
            return _without_parentheses(found[2], line)
    if kind == 'KeyError' and (found := re.match(r"'([A-Z]\w*)'$", text)):
        variables = re.search(rf"(\b(?:os\.)?environ)\[[\"']{found[1]}[\"']\]", line)
        return f"It is not set. {variables[1]}.get('{found[1]}') gives None then, and no error." if variables else ''
    if kind == 'TypeError' and (found := re.match(r'(\w+)\.__init__\(\) takes 1 positional argument but', text)):
        if found[1] != 'object' and re.search(r"""\bsuper\(\)\.__init__\(\s*f?["']""", line):
            return f'`super()` is `{found[1]}` here, and not Node: its `__init__` takes no name, so leave it out.'
    if kind == 'AssertionError' and (found := re.match(r"The '(\w+)' field must be of type 'str'$", text)):
        return 'A text is wanted, and None is no text.' if re.search(rf'\b{found[1]}\s*=\s*None\b', line) else ''
    return ''


def _called_at_once(lines: Sequence[str]) -> str:
    for line in lines:
        if found := _GIVEN.search(line):
            given = 'future' if 'add_done_callback(' in found[0] else '' if 'create_timer(' in found[0] else '…'
            return (
                f'`{found[1]}(…)` is called here at once, and what it returns is the callback. If it is to be called '
                f'later, give a function: {f"lambda {given}".strip()}: {found[1]}(…)'
            )
    return ''


def without_arguments(name: str, missing: int, line: str) -> str:
    """A sentence on a method that wants so many arguments more; '' if it is no callback, as far as the line shows."""
    if missing == 1:
        if line and not re.search(rf'\b{name}\(\s*\)', line):  # it is called with something
            return ''
    elif not re.search(rf'(?:[(,]\s*|\w=)self\.{name}\(\s*\)|^self\.{name}\(\s*\)\s*[,)]', line):
        return ''
    said = f'If it is a callback, give the function itself, without parentheses: self.{name}, not self.{name}().'
    return f'{said} If that is so, it has more parameters than it is called with.' if missing == 1 else said


def _on_dictionary(name: str, line: str, answer: str) -> str:
    found = re.search(rf'(?<![\w.\])])((?:\w+\.)*\w+)\.{name}\b', line)
    whose = found[1] if found else '…'
    if name in _OF_LISTS_AND_SETS and (not line or re.search(rf'\.{name}\(', line)):
        more = f': write {whose}[name] = value. (An empty list is [], and an empty set is set().)'
        return f'A dictionary has no `{name}`{more if name in ("add", "append", "insert") else "."}'
    if slips.is_variable(name, answer):
        return f"It is a dictionary: write {whose}[{name}], or {whose}['{name}'] for the entry with this name."
    return f"It is a dictionary: write {whose}['{name}']."


def _without_parentheses(name: str, line: str) -> str:
    """On a function that is asked for `name`, which what it returns has."""
    found = {one.groups() for one in re.finditer(rf'(?<![\w.\])])((?:\w+\.)*)(\w+)\.{name}\b(\s*\()?', line)}
    if len(found) != 1:
        return ''
    before, function, called = found.pop()
    what = 'method' if before.startswith('self.') else 'function'
    written = f'{before}{function}{_parentheses(function)}.{name}{"(…)" if called else ""}'
    return f'`{function}` is a {what}. Parentheses call it: {written}'


def _parentheses(function: str) -> str:
    """How a function is called, as far as it is known."""
    known = [getattr(kind, function) for kind in (Node, Future, Clock) if callable(getattr(kind, function, None))]
    if not known:
        return '(…)'
    parameters = list(inspect.signature(known[0]).parameters.values())[1:]
    return '(…)' if any(one.default is one.empty for one in parameters) else '()'
