"""What a chapter's source must hold to; each breach becomes one AuthoringError."""

import ast
import re
import statistics
from collections.abc import Iterable, Iterator

from grading.authoring import cards, indexes, regions, relative_links
from grading.authoring.chapter import QUESTIONS, Chapter, SourceCell
from grading.authoring.chapter_errors import AuthoringError
from helpers.exercises import definitions, file_answers, file_syntax

MAX_LINES = 15  # without the line of a `%%writefile`
MAX_EXERCISE_LINES = 50  # a class that is an answer cannot be split, and a cell may hold the texts of files
MEDIAN_LINES = 6
METADATA = {'tags', 'editable', 'deletable', 'slideshow', 'jupyter'}
NBVAL_TAGS = {'nbval-check-output', 'nbval-ignore-output', 'nbval-raises-exception', 'nbval-skip'}
# Checked statements by chapter, see `checked`. Raise a number when a chapter has got more; never lower it.
CHECKED_AT_LEAST = {1: 30, 2: 27, 3: 47, 4: 54, 5: 48, 6: 70, 7: 60, 8: 39}
OTHER_DISTRIBUTION = re.compile(r'docs\.ros\.org/en/(?!jazzy/)[a-z]+')
BELOW_A_HINT = re.compile(r'</details>\s+(?=[^\s<])')
BY_HAND = re.compile(r"""check\(['"]\d+\.\d+['"]\)|# Exercise \d+\.\d+\b.*""")


def check(chapters: Iterable[Chapter]) -> list[AuthoringError]:
    """Return all mistakes in ``chapters``, in order."""
    chapters = list(chapters)
    errors: list[AuthoringError] = list(_terms(chapters))
    owners: dict[str, str] = {}
    for chapter in chapters:
        errors += _check_chapter(chapter)
        for cell in chapter.cells:
            if cell.card is None:
                continue
            identifier = cell.card.id
            if identifier in owners:
                problem = f'exercise {identifier} is there twice (first {owners[identifier]})'
                errors.append(AuthoringError(chapter.path, cell.line, problem, 'give each exercise its own id'))
            owners.setdefault(identifier, f'{chapter.path.name}:{cell.line}')
    return errors


def advice(chapter: Chapter) -> list[str]:
    """Return what is allowed but should be better."""
    lengths = [len(cell.split.solved.splitlines()) for cell in chapter.cells if cell.kind == 'code']
    median = statistics.median(lengths) if lengths else 0
    if median > MEDIAN_LINES:
        return [f'{chapter.path.name}: code cells have {median:g} lines in the median; aim at {MEDIAN_LINES} or fewer']
    return []


def checked_counts(chapters: Iterable[Chapter]) -> dict[int, int]:
    """Return how many checked statements each chapter has."""
    return {
        chapter.number: sum(
            isinstance(node, ast.Assert) for cell in chapter.cells for node in ast.walk(ast.parse(cell.checked))
        )
        for chapter in chapters
    }


def _terms(chapters: list[Chapter]) -> Iterator[AuthoringError]:
    """Yield terms that are marked twice in a chapter, or never, and chapters without a place for their new words."""
    if not chapters:
        return
    book = chapters[0].book
    for name, uses in book.uses.items():
        for before, use in zip(uses, uses[1:], strict=False):
            if before.path == use.path:
                problem = f'the term {name!r} is marked twice in this chapter (first in line {before.line})'
                yield AuthoringError(use.path, use.line, problem, 'mark its first use only')
    for name, term in book.terms.items():
        if book.glossary_file and name not in book.uses:
            yield AuthoringError(
                book.glossary_file, term.line, f'no chapter uses the term {name!r}', 'mark it or remove it'
            )
    for chapter in chapters:
        text = '\n'.join(cell.source for cell in chapter.cells if cell.kind == 'markdown')
        if indexes.new_words(book, chapter.number) and QUESTIONS not in text.splitlines():
            problem = 'no place for the new words of this chapter'
            yield AuthoringError(chapter.path, None, problem, f'add the heading {QUESTIONS!r}')


def _check_chapter(chapter: Chapter) -> Iterator[AuthoringError]:
    first = chapter.cells[0] if chapter.cells else None
    if first is None or first.kind != 'markdown' or not first.source.startswith('# '):
        yield AuthoringError(chapter.path, 1, 'no title', "begin the text with a line '# N Title'")
    for cell in chapter.cells:
        if cell.kind == 'markdown':
            folder = chapter.path.parents[1] / 'notebooks'
            for offset, problem, remedy in relative_links.broken(
                cell.source, f'{chapter.name}.ipynb', chapter.book, folder
            ):
                yield AuthoringError(chapter.path, cell.line + offset, problem, remedy)
        if cell.kind == 'markdown' and regions.has_marker(cell.source):
            offset = next(i for i, line in enumerate(cell.source.splitlines()) if regions.has_marker(line))
            problem = 'solution marker in prose'
            yield AuthoringError(chapter.path, cell.line + offset, problem, 'move it into an exercise cell')
        if cell.kind == 'markdown' and (other := OTHER_DISTRIBUTION.search(cell.source)):
            yield AuthoringError(
                chapter.path, cell.line, f'a link to {other[0]}', 'link to the page of Jazzy, or to a branch "jazzy"'
            )
        if cell.kind == 'markdown' and (hint := BELOW_A_HINT.search(cell.source)):
            line = cell.line + cell.source[: hint.end()].count('\n')
            problem = 'this text has no distance from the folded hint above it'
            yield AuthoringError(chapter.path, line, problem, "begin a cell of its own for it, by a line '+++'")
        if cell.kind == 'code':
            for problem, remedy in (*_code_cell(cell), *_metadata(cell)):
                yield AuthoringError(chapter.path, cell.line, problem, remedy)
            if cell.card is not None:
                for problem, remedy in _programs(cell, cell.card):
                    yield AuthoringError(chapter.path, cell.line, problem, remedy)


def _code_cell(cell: SourceCell):
    length = max(len(cell.split.solved.splitlines()), len(cell.split.stub.splitlines()))
    length -= cell.source.startswith('%%writefile')
    if cell.card is not None and cell.card.folder:  # the solution is a whole package, which no learner's notebook shows
        length = len(cell.split.stub.splitlines())
    limit = MAX_LINES if cell.card is None else MAX_EXERCISE_LINES
    if length > limit:
        yield f'a code cell of {length} lines, at most {limit} are allowed', 'split it'
    if not cell.split.solved.strip():
        yield 'an empty code cell', 'remove it'
    if cell.split.regions and cell.card is None:
        yield 'a solution region outside of an exercise', f'declare the exercise before it: {cards.EXAMPLE}'
    first = next(iter(cell.source.splitlines()), '').strip()
    if BY_HAND.fullmatch(first):
        yield f'{first!r} is written by hand', 'leave it out: the build writes it from the directive of the exercise'


def _metadata(cell: SourceCell):
    for key in sorted(cell.author_metadata.keys() - METADATA):
        yield f'unknown metadata {key!r}', f'use one of {", ".join(sorted(METADATA))}'
    for tag in cell.tags:
        if str(tag).startswith('nbval') and tag not in NBVAL_TAGS:
            yield f'unknown tag {tag!r}', f'use one of {", ".join(sorted(NBVAL_TAGS))}'


def _programs(cell: SourceCell, card: cards.Card):
    label, trees = f'exercise {card.id}', {}
    for form, text, remedy in (
        ('solution', cell.split.solved, 'correct it'),
        ('stub', cell.split.stub, 'add what a body needs, as in # STUB: pass'),
    ):
        try:
            trees[form] = ast.parse(file_answers.as_python(text))
        except SyntaxError as error:
            lines = text.splitlines()
            shown = lines[error.lineno - 1].strip() if error.lineno and error.lineno <= len(lines) else ''
            yield f'the {form} of {label} does not parse ({error.msg} at {shown!r})', remedy
        for _, path, content, _ in file_answers.files(text):
            if found := file_syntax.mistake(path, content):
                yield f'the {form} of {label}: {file_syntax.shown(path, content, found)}', remedy
    if len(trees) == 2:
        if ast.dump(trees['solution']) == ast.dump(trees['stub']):
            yield f'{label} leaves nothing to do, its stub is its solution', 'mark the solution'
        for name in card.names:
            if name not in definitions.defined(trees['solution'].body):
                yield f'{label} does not define {name}', 'define it in this cell or take it from :names:'
