"""Answers to exercises that differ from the solution: wrong ones (mutants) and other right ones (alternatives).

They stand in `grading/exercises/N_M/`: `mutants.py` holds the list MUTANTS, `alternatives.py` the list ALTERNATIVES.
Each answer is a named edit of the solved cell::

    Mutant('best_effort', old="'beacon', 10)", new="'beacon', SENSOR)",
           expect='offers reliability BEST_EFFORT', breaks='qos')

`old` is a part of one line, or whole lines in triple quotes. The lines' common indentation does not matter; `new` gets
that of the lines that it replaces. A line of which nothing is left goes. If the solution does not hold the text exactly
once (or `count` times) that is an error, so no answer can fall behind the solution unnoticed.
"""

import textwrap
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from grading.course import HIDDEN

FOLDER = HIDDEN


class VariantError(Exception):
    """A mutant or an alternative that does not fit its exercise; the message names exercise, answer and text."""


@dataclass(frozen=True)
class Variant:
    """An answer, as an edit of the solved cell; or, if it has little in common with it, as a whole text."""

    name: str
    old: str = ''
    new: str = ''
    edits: tuple[tuple[str, str], ...] = ()  # (old, new) for several places
    imports: str = ''  # lines that come after the cell's first one
    count: int = 1  # in how many places each `old` stands; all are changed
    source: str | None = None  # all that comes after the cell's first line
    alone: bool = False  # needs a notebook of its own: its exercise uses the answers of others, which must be right

    def applied(self, solved: str, exercise: str) -> str:
        """Return the text of the cell; `solved` is the solution's.

        :raises VariantError: an `old` does not stand in it `count` times, or nothing is changed.
        """
        where = f'exercise {exercise}, {type(self).__name__.lower()} {self.name!r}'
        edits = (*([(self.old, self.new)] if self.old or self.new else []), *self.edits)
        if (self.source is None) is not bool(edits or self.imports):
            raise VariantError(f'{where}: give either an edit (old and new, or edits, or imports) or the whole source')
        if self.source is not None:
            return solved.partition('\n')[0] + '\n' + self.source.strip('\n') + '\n'
        spans = []
        for old, new in edits:
            found = list(_places(solved, old, new))
            if len(found) != self.count:
                raise VariantError(
                    f'{where}: the solution holds this text {len(found)} times, not {self.count}; '
                    f'edit `old`, or give `count`:\n{textwrap.dedent(old).strip()}'
                )
            spans += found
        if self.imports:
            end = solved.find('\n') + 1
            spans.append((end, end, textwrap.dedent(self.imports).strip() + '\n\n\n'))
        text, last = '', 0
        for start, end, new in sorted(spans):
            if start < last:
                raise VariantError(f'{where}: two edits change the same text; make one of them:\n{solved[start:end]}')
            text, last = text + solved[last:start] + new, end
        text += solved[last:]
        if text == solved:
            raise VariantError(f'{where}: the edit changes nothing')
        return text


@dataclass(frozen=True)
class Mutant(Variant):
    """A wrong answer: which rule it breaks, and what the learner must read about it.

    At least one visible and one hidden test with the mark of this rule must reject it and name the rule.
    """

    breaks: str = ''  # the rule of the card that it breaks
    also: tuple[str, ...] = ()  # further rules that it cannot help breaking
    expect: str | tuple[str, ...] = ()  # parts of what the learner must read; a tuple after `__post_init__`

    def __post_init__(self):
        for field in ('also', 'expect'):
            value = getattr(self, field)
            object.__setattr__(self, field, (value,) if isinstance(value, str) else tuple(value))


@dataclass(frozen=True)
class Alternative(Variant):
    """Another right answer, which must get full marks."""


def mutants(exercise: str, folder: Path = FOLDER) -> tuple[Mutant, ...]:
    """Return the wrong answers to an exercise, such as '3.1'.

    :raises VariantError: there is no list, or it is wrong.
    """
    return _listed(exercise, folder, 'mutants', Mutant)


def alternatives(exercise: str, folder: Path = FOLDER) -> tuple[Alternative, ...]:
    """Return the other right answers to an exercise.

    :raises VariantError: there is no list, or it is wrong.
    """
    return _listed(exercise, folder, 'alternatives', Alternative)


@cache
def solved_cells(solutions: Path) -> Mapping[str, str]:
    """Return the solved cell of each exercise, from the chapters' sources in this folder."""
    from grading.authoring import book as books
    from grading.authoring import chapter

    book = books.load(solutions)
    return {
        cell.exercise['id']: cell.split.solved
        for path in chapter.sources(solutions)
        for cell in chapter.read(path, book).cells
        if cell.exercise is not None
    }


def _listed(exercise: str, folder: Path, kind: str, wanted: type) -> tuple:
    path = folder / exercise.replace('.', '_') / f'{kind}.py'
    space: dict = {'__name__': f'{kind}_{path.parent.name}', '__file__': str(path)}
    try:
        exec(compile(path.read_text(encoding='utf-8'), str(path), 'exec'), space)
    except FileNotFoundError:
        raise VariantError(f'exercise {exercise}: {path} is missing') from None
    except Exception as error:
        raise VariantError(f'exercise {exercise}: {path} cannot be read ({type(error).__name__}: {error})') from error
    found = space.get(kind.upper())
    if not isinstance(found, list) or not all(type(one) is wanted for one in found):
        raise VariantError(f'exercise {exercise}: {path} must hold {kind.upper()}, a list of {wanted.__name__}(…)')
    names = [one.name for one in found]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise VariantError(f'exercise {exercise}: {path} has {twice[0]!r} twice')
    return tuple(found)


def _places(text: str, old: str, new: str) -> Iterator[tuple[int, int, str]]:
    """Where `old` stands in the text, from and to, and what comes there."""
    if '\n' in old or '\n' in new:
        yield from _whole_lines(text.splitlines(keepends=True), _block(old), _block(new))
        return
    start = text.find(old) if old.strip() else -1
    while start >= 0:
        end = start + len(old)
        first, last = text.rfind('\n', 0, start) + 1, (text + '\n').find('\n', end)
        left_over = text[first:start] + new + text[end:last]
        yield (start, end, new) if left_over.strip() else (first, last + 1, '')
        start = text.find(old, end)


def _block(text: str) -> list[str]:
    lines = textwrap.dedent(text).strip('\n').split('\n')
    return [line.rstrip() for line in lines] if text.strip() else []


def _whole_lines(lines: list[str], old: list[str], new: list[str]) -> Iterator[tuple[int, int, str]]:
    place = 0
    lead = len(old[0]) - len(old[0].lstrip()) if old else 0  # the first line may be further in than a later one
    for index, line in enumerate(lines):
        indent = line[lead : len(line) - len(line.lstrip())]
        part = lines[index : index + len(old)]
        if old and [one.rstrip() for one in part] == _indented(old, indent):
            yield place, place + len(''.join(part)), ''.join(f'{one}\n' for one in _indented(new, indent))
        place += len(line)


def _indented(lines: Iterable[str], indent: str) -> list[str]:
    return [indent + line if line else '' for line in lines]
