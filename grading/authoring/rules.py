"""What a chapter's source must hold to; each breach becomes one AuthoringError."""

import ast
import re
import statistics
from collections.abc import Iterable, Iterator
from itertools import takewhile

from grading.authoring import regions
from grading.authoring.chapter import Cell, Chapter
from grading.authoring.errors import AuthoringError

MAX_LINES = 25
MAX_EXERCISE_LINES = 36  # an exercise's cell cannot be split, and may hold the texts of files
MEDIAN_LINES = 6
METADATA = {'exercise', 'tags', 'editable', 'deletable', 'slideshow', 'jupyter'}
NBVAL_TAGS = {'nbval-check-output', 'nbval-ignore-output', 'nbval-raises-exception', 'nbval-skip'}
FIRST_LINE = re.compile(r'# Exercise (\d+\.\d+): \S.*')


def check(chapters: Iterable[Chapter]) -> list[AuthoringError]:
    """Return all mistakes in ``chapters``, in order."""
    errors, owners = [], {}
    for chapter in chapters:
        errors += _check_chapter(chapter)
        for cell in chapter.cells:
            if not isinstance(cell.exercise, dict) or not isinstance(identifier := cell.exercise.get('id'), str):
                continue
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


def _check_chapter(chapter: Chapter) -> Iterator[AuthoringError]:
    first = chapter.cells[0] if chapter.cells else None
    if first is None or first.kind != 'markdown' or not first.source.startswith('# '):
        yield AuthoringError(chapter.path, 1, 'no title', "begin the text with a line '# N Title'")
    for index, cell in enumerate(chapter.cells):
        if cell.kind == 'markdown' and regions.has_marker(cell.source):
            offset = next(i for i, line in enumerate(cell.source.splitlines()) if regions.has_marker(line))
            problem = 'solution marker in prose'
            yield AuthoringError(chapter.path, cell.line + offset, problem, 'move it into an exercise cell')
        if cell.kind == 'code':
            for problem, remedy in (*_code_cell(cell), *_metadata(cell)):
                yield AuthoringError(chapter.path, cell.line, problem, remedy)
            if cell.exercise is not None:
                for line, problem, remedy in _exercise(chapter, cell, chapter.cells[index + 1:]):
                    yield AuthoringError(chapter.path, line, problem, remedy)


def _code_cell(cell: Cell):
    length = max(len(cell.split.solved.splitlines()), len(cell.split.stub.splitlines()))
    limit = MAX_LINES if cell.exercise is None else MAX_EXERCISE_LINES
    if length > limit:
        yield f'a code cell of {length} lines, at most {limit} are allowed', 'split it'
    if not cell.source.strip():
        yield 'an empty code cell', 'remove it'
    if cell.split.regions and cell.exercise is None:
        yield 'a solution region outside of an exercise', "add the cell's metadata, ':exercise: {\"id\": …}'"


def _metadata(cell: Cell):
    for key in sorted(cell.metadata.keys() - METADATA):
        yield f'unknown metadata {key!r}', f'use one of {", ".join(sorted(METADATA))}'
    for tag in cell.tags:
        if str(tag).startswith('nbval') and tag not in NBVAL_TAGS:
            yield f'unknown tag {tag!r}', f'use one of {", ".join(sorted(NBVAL_TAGS))}'


def _exercise(chapter: Chapter, cell: Cell, following: tuple[Cell, ...]):
    fields = cell.exercise
    if not isinstance(fields, dict):
        example = ':exercise: {"id": "3.1", "points": 10, "names": ["Talker"]}'
        yield cell.line, 'exercise metadata without fields', f'write {example}'
        return
    identifier, points, names = fields.get('id'), fields.get('points'), fields.get('names')
    if not isinstance(identifier, str) or not re.fullmatch(rf'{chapter.number}\.[1-9]\d*', identifier):
        yield cell.line, f'exercise id {identifier!r}', f'write a quoted "{chapter.number}.N" in this chapter'
        return
    label = f'exercise {identifier}'
    for key in fields.keys() - {'id', 'points', 'names'}:
        yield cell.line, f'{label} has an unknown field {key!r}', 'use id, points and names'
    if isinstance(points, bool) or not isinstance(points, (int, float)) or points <= 0:
        yield cell.line, f'{label} without points', 'add "points": N, more than 0, to its metadata'
    said = re.search(rf'^#+ Exercise {identifier}: .*\(([\d.]+) points?\)$', '\n'.join(
        other.source for other in chapter.cells if other.kind == 'markdown'), re.MULTILINE)
    if said and str(points) != said[1]:
        yield cell.line, f'{label} has {points} points, and {said[1]} in the heading of its card', 'write the same'
    if not isinstance(names, list) or not names or not all(str(name).isidentifier() for name in names):
        yield cell.line, f'{label} without names', 'add "names": [what the cell must define] to its metadata'
        names = []
    match = FIRST_LINE.fullmatch(cell.source.splitlines()[0] if cell.source else '')
    if not match or match[1] != identifier:
        yield cell.line, f"the first line of {label} is not '# Exercise {identifier}: title'", 'make it so'
    if not cell.split.regions:
        yield cell.line, f'{label} has no solution region', f'mark it with {regions.BEGIN} and {regions.END}'
    yield from _programs(cell, label, names)
    until_next = takewhile(lambda other: other.exercise is None, following)
    if not any(other.kind == 'code' and _calls_check(other.source, identifier) for other in until_next):
        yield cell.line, f'{label} has no check cell', f'add a cell check("{identifier}") after it'


def _programs(cell: Cell, label: str, names: list[str]):
    trees = {}
    for form, text, remedy in (('solution', cell.split.solved, 'mend it'),
                               ('stub', cell.split.stub, 'add what a body needs, as in # STUB: pass')):
        try:
            trees[form] = ast.parse(text)
        except SyntaxError as error:
            lines = text.splitlines()
            shown = lines[error.lineno - 1].strip() if error.lineno and error.lineno <= len(lines) else ''
            yield cell.line, f'the {form} of {label} does not parse ({error.msg} at {shown!r})', remedy
    if len(trees) == 2:
        if ast.dump(trees['solution']) == ast.dump(trees['stub']):
            yield cell.line, f'{label} leaves nothing to do, its stub is its solution', 'mark the solution'
        for name in names:
            if name not in _defined(trees['solution']):
                yield cell.line, f'{label} does not define {name}', 'define it in this cell or take it from names'


def _defined(tree: ast.Module) -> set[str]:
    found = set()
    for node in tree.body:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            found.add(node.name)
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            found |= {name.id for target in targets for name in ast.walk(target) if isinstance(name, ast.Name)}
    return found


def _calls_check(source: str, identifier: str) -> bool:
    return bool(re.search(rf'''\bcheck\(\s*['"]{re.escape(identifier)}['"]''', source))
