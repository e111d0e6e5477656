"""Patterns that meet a learner's text must take time in proportion to it: tests wait for them, and so does the class.

Each pattern in the code that reads, judges or shows such texts is tried on long texts of the kind that makes patterns
slow: a beginning that fits, one sign many times, and an end that does not fit.
"""

import ast
import itertools
import re
import sys
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

import pytest

from helpers import paths

if sys.version_info >= (3, 11):
    from re import _parser as parser  # type: ignore[attr-defined]
else:
    import sre_parse as parser

pytestmark = pytest.mark.one_of(2)

READ = ('helpers/checks', 'helpers/exercises', 'helpers/runner', 'helpers/programs/faults', 'grading')
NO_READERS = {'tests', 'given', 'bench', 'authoring'}
UNITS = (' ', '\n', ' \n', 'a', '1', '/', '.', '-', '=', '"', "'", 'a ')
BEGINNINGS = ('', '"a=', "'a = ", "=x:y'", 'a=', 'a=x', '# ', '<!--')  # of what learners write
ENDS = '\x01', '\nx'
FLAGS = 'MULTILINE', 'DOTALL', 'IGNORECASE', 'VERBOSE'
LENGTH = 4000
SLOW = 0.01  # s of computing for LENGTH: a pattern that needs less needs no second look
LONGEST = 0.1  # s of computing for twice LENGTH; in proportion it is some thousandths of a second


class Use(NamedTuple):
    """A pattern with its flags, and how it is used: from each place of a text on, or from its beginning only."""

    pattern: str
    flags: int
    method: str


def _uses() -> dict[Use, str]:
    """The uses of patterns, and where each stands."""
    found: dict[Use, str] = {}
    for folder in READ:
        for path in sorted((paths.ROOT / folder).rglob('*.py')):
            if NO_READERS & set(path.relative_to(paths.ROOT).parts):
                continue
            source = path.read_text(encoding='utf-8')
            names: dict[ast.expr, str] = {}  # of compiled patterns
            for node in ast.walk(ast.parse(source)):
                if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                    names[node.value] = node.targets[0].id
                if isinstance(node, ast.Call) and ast.unparse(node.func).startswith('re.') and node.args:
                    if (text := _text(node.args[0])) is not None:
                        used = {ast.unparse(node.func).removeprefix('re.')}
                        if 'compile' in used:
                            used = set(re.findall(rf'\b{names.get(node, "nothing")}\.(\w+)', source))
                        words = ' '.join(map(ast.unparse, node.args[1:]))
                        flags = sum(getattr(re, name) for name in FLAGS if name in words)
                        method = next((one for one in ('fullmatch', 'match') if used <= {one, 'match'}), 'search')
                        found.setdefault(Use(text, flags, method), f'{path.relative_to(paths.ROOT)}:{node.lineno}')
    return found


def _text(node: ast.expr) -> str | None:
    """The pattern that is written there; a word in the place of each value that is put in."""
    match node:
        case ast.Constant(value=str(text)):
            return text
        case ast.JoinedStr(values=values):
            return ''.join(str(one.value) if isinstance(one, ast.Constant) else 'word' for one in values)
    return None


def _words(tree) -> Iterator[str]:
    """The fixed words in a pattern."""
    word = ''
    for kind, value in tree:
        if str(kind) == 'LITERAL':
            word += chr(value)
            continue
        yield word
        word = ''
        parts = value if isinstance(value, tuple) else ()
        for part in itertools.chain(parts, *(one for one in parts if isinstance(one, list))):
            if isinstance(part, parser.SubPattern):
                yield from _words(part)
    yield word


def _seconds(look: Callable[[str], object], text: str) -> float:
    begin = time.thread_time()
    look(text)
    return time.thread_time() - begin


def _slow(use: Use) -> str:
    """A text for which a pattern needs much more time than in proportion; empty if none is found."""
    look = getattr(re.compile(use.pattern, use.flags), use.method)
    words = dict.fromkeys(word for word in _words(parser.parse(use.pattern, use.flags)) if word)
    for beginning in (*BEGINNINGS, *itertools.islice(words, 5)):
        for unit, end in itertools.product(UNITS, ENDS):
            if _seconds(look, beginning + unit * (LENGTH // len(unit)) + end) < SLOW:
                continue
            longer = beginning + unit * (2 * LENGTH // len(unit)) + end
            if min(_seconds(look, longer) for _ in range(3)) > LONGEST:
                return f'{beginning!r} and {unit!r} again and again'
    return ''


@pytest.mark.parametrize(
    ('pattern', 'method'),
    [
        (r"""(['"])\s*[\w.-]+\s*=\s*([^'"=]*)\1""", 'search'),
        (r"""=\s*[\w.]+:\w+(['"])\s*\n\s*['"]""", 'search'),
        (r"""[^\s"'=:]*/opt/ros/""", 'search'),
        (r'([\w-]+)\s*=\s*(.*?)\s*', 'fullmatch'),
    ],
)
def test_slow_ones_are_found(pattern, method):
    assert _slow(Use(pattern, 0, method))


def test_none_is_slow():
    uses = _uses()
    assert len(uses) > 100
    slow = [f'{where}: {use.pattern}: {text}' for use, where in uses.items() if (text := _slow(use))]
    assert not slow, '\n'.join(slow)
