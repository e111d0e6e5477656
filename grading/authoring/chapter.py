"""A chapter's source, `solutions/NN_name.md`, read into cells that know their line numbers."""

import ast
import re
from dataclasses import dataclass, field, replace
from pathlib import Path

import yaml
from jupytext.myst import MystMetadataParsingError, myst_to_notebook
from nbformat import ValidationError

from grading.authoring import book as books
from grading.authoring import cards, checked, figures, indexes, quizzes, references, regions, table_names
from grading.authoring.book import FILE_NAME, Book, sources
from grading.authoring.cards import Card
from grading.authoring.chapter_errors import AuthoringError, CellError
from helpers.exercises import cell_ids, manifest

__all__ = ['Chapter', 'SourceCell', 'read', 'sources']
QUESTIONS = '### Check yourself'  # before this heading stand the chapter's new words


@dataclass(frozen=True)
class SourceCell:
    """One cell of the notebooks. ``line`` is the 1-based line of its first line of text in the source."""

    kind: str  # 'code', 'markdown' or 'raw'
    source: str  # as the author wrote it; empty if the build makes the cell
    author_metadata: dict
    line: int
    split: regions.Split
    card: Card | None = None  # of the exercise of which this is the answer cell
    rules: tuple[manifest.Rule, ...] = ()  # of that card
    figures: tuple[str, ...] = ()  # that are shown in it
    checked: str = ''  # statements that must hold after it, see `checked`
    checked_line: int = 0  # of their first line

    @property
    def exercise(self) -> dict | None:
        """The exercise's metadata."""
        return self.card.metadata if self.card else None

    @property
    def metadata(self) -> dict:
        """The cell's metadata in the solved notebook."""
        statements = {checked.KEY: self.checked} if self.checked else {}
        return ({'exercise': self.exercise} if self.card else {}) | statements | self.author_metadata

    @property
    def tags(self) -> list[str]:
        """The cell's tags."""
        return self.metadata.get('tags', [])

    def source_line(self, solved_line: int) -> int:
        """Return the line in the .md file of the given 1-based line of the solved cell."""
        lines = self.split.solved_lines
        return self.line + lines[min(max(solved_line, 1), len(lines)) - 1] if lines else self.line


@dataclass(frozen=True)
class Chapter:
    """One chapter's source."""

    path: Path
    number: int
    cells: tuple[SourceCell, ...]
    book: Book = field(compare=False, repr=False)  # what it may refer to

    @property
    def name(self) -> str:
        """The file's name without its suffix, '03_nodes_and_topics'."""
        return self.path.stem

    def exercises(self) -> list[manifest.Exercise]:
        """Return the chapter's rows of exercises.json; the source must be free of mistakes (rules.check)."""
        return [
            manifest.Exercise(
                id=cell.card.id,
                chapter=self.number,
                notebook=f'{self.name}.ipynb',
                title=cell.card.title,
                points=cell.card.points,
                names=cell.card.names,
                cell_id=cell_ids.of_exercise(cell.card.id),
                stub=manifest.stub_digest(cell.split.stub),
                rules=cell.rules,
                folder=cell.card.folder,
                earlier=cell.card.earlier,
            )
            for cell in self.cells
            if cell.card is not None
        ]


def read(path: Path, book: Book | None = None) -> Chapter:
    """Read one source.

    :param book: what it may refer to; default: the sources in its folder.
    :raises AuthoringError: the file is no MyST notebook, or a marker, role or directive in it is wrong.
    """
    match = FILE_NAME.fullmatch(path.name)
    if not match:
        raise AuthoringError(path, None, 'not the name of a chapter', 'call it NN_name.md, in lower case')
    text = path.read_text(encoding='utf-8')
    try:
        notebook = myst_to_notebook(text, add_source_map=True)
    except (MystMetadataParsingError, yaml.YAMLError) as error:
        found = re.search(r'at line (\d+)', str(error))
        problem = ' '.join(str(error).split())
        raise AuthoringError(path, int(found[1]) if found else 1, problem, 'correct the YAML of the metadata') from None
    except ValidationError as error:
        lines = text.splitlines()
        line = next((number for number, line in enumerate(lines, start=1) if str(error.instance) in line), 1)
        raise AuthoringError(path, line, f'metadata: {error.message}', 'write tags as :tags: [name, …]') from None
    lines = text.splitlines()
    starts = notebook.metadata.source_map
    reader = _Reader(path, int(match[1]), book or books.load(path.parent))
    for cell, start in zip(notebook.cells, starts, strict=True):
        line = _first_line(cell.source.splitlines(), lines, start) + 1
        try:
            reader.add(cell, line)
        except CellError as error:
            raise AuthoringError(path, line + error.offset, error.problem, error.remedy) from None
    reader.end()
    return Chapter(path, reader.number, tuple(reader.cells), reader.book)


class _Reader:
    """Takes the cells of a source one after the other, and adds what the build makes for exercises."""

    def __init__(self, path: Path, number: int, book: Book):
        self.path, self.number, self.book = path, number, book
        self._quizzes = 0
        self.cells: list[SourceCell] = []
        self._card: Card | None = None  # an exercise that has no answer cell yet
        self._card_line = 0
        self._rules: dict[str, manifest.Rule] = {}
        self._answered: Card | None = None  # an exercise that has no check cell yet
        self._after_answer = 0  # where its check cell goes if no cell asks for it

    def add(self, node, line: int) -> None:
        """Take the next cell, which begins in `line` (1-based)."""
        if node.cell_type == 'markdown':
            self._markdown(node.source, _plain(node.metadata), line)
        elif node.cell_type == 'code':
            self._code(node.source, _plain(node.metadata), line)
        else:
            self.cells.append(SourceCell(node.cell_type, node.source, _plain(node.metadata), line, _given(node.source)))

    def end(self) -> None:
        """Finish what the last exercise wants."""
        if self._card:
            raise AuthoringError(
                self.path,
                self._card_line,
                f'exercise {self._card.id} has no solution region',
                f'mark it in its answer cell with {regions.BEGIN} and {regions.END}',
            )
        self._place_check()

    def _markdown(self, source: str, metadata: dict, line: int) -> None:
        linked = references.render(source, self.book)  # the lines stay in their places
        part = cards.read(linked, self.number, self._card is not None)
        quizzes.render(linked, 1)  # its mistakes have the lines of the source
        if part.card:
            self.end()
            self._card, self._card_line, self._rules = part.card, line + part.begin, {}
        for offset, rule in part.rules:
            if rule.name in self._rules:
                problem = f'the card has the rule {rule.name!r} twice'
                raise AuthoringError(self.path, line + offset, problem, 'give each rule its own name')
            self._rules[rule.name] = rule
        text, self._quizzes = quizzes.render(part.text, self._quizzes + 1)
        if words := indexes.new_words(self.book, self.number):
            text = re.sub(f'(?m)^{QUESTIONS}$', f'### New words\n\n{words}\n\n{QUESTIONS}', text)
        placed = figures.place(source, table_names.marked(text), self.path.parent / figures.FOLDER)
        split = regions.Split(placed.solved, placed.learner, (), 0)
        self.cells.append(SourceCell('markdown', source, metadata, line, split, figures=placed.names))

    def _code(self, source: str, metadata: dict, line: int) -> None:
        if 'check' in metadata and not source.strip():
            if not self._answered:
                raise AuthoringError(
                    self.path,
                    line,
                    'a check cell without an exercise that it could check',
                    'put it after the answer cell, once',
                )
            self._place_check(line)
            return
        if checked.KEY in metadata:
            self._checked(source, metadata, line)
            return
        split = regions.split(source)
        if not self._card or not split.regions:
            self.cells.append(SourceCell('code', source, metadata, line, split))
            return
        first = f'{self._card.first_line}\n'
        stub = split.stub
        if self._card.folder:
            nothing = f'# Your answer is the folder {self._card.folder}: there is nothing to write into this cell.'
            stub = stub.replace(regions.PLACEHOLDER, nothing)
        split = regions.Split(first + split.solved, first + stub, (0, *split.solved_lines), split.regions)
        self.cells.append(SourceCell('code', source, metadata, line, split, self._card, tuple(self._rules.values())))
        self._answered, self._card, self._after_answer = self._card, None, len(self.cells)

    def _checked(self, source: str, metadata: dict, line: int) -> None:
        above = self.cells[-1] if self.cells else None
        if metadata != {checked.KEY: True}:
            raise CellError(0, 'checked statements with other metadata', 'write :checked: true, and nothing else')
        if above is None or above.kind != 'code' or above.checked:
            raise CellError(
                0, 'checked statements that do not follow a code cell', 'put them all in one block, directly below it'
            )
        try:
            statements = ast.parse(source).body
        except SyntaxError as error:
            raise CellError((error.lineno or 1) - 1, f'checked statements: {error.msg}', 'mend the syntax') from None
        if not any(isinstance(node, ast.Assert) for statement in statements for node in ast.walk(statement)):
            raise CellError(0, 'checked statements without an assertion', 'write assert …')
        self.cells[-1] = replace(above, checked=source, checked_line=line)

    def _place_check(self, line: int | None = None) -> None:
        """Add the check cell here, or, without a line, directly after the answer cell."""
        if self._answered:
            place = self._after_answer if line is None else len(self.cells)
            cell = SourceCell(
                'code',
                '',
                {'tags': list(self._answered.check_tags)},
                line or self.cells[place - 1].line,
                _given(self._answered.check),
            )
            self.cells.insert(place, cell)
            self._answered = None


def _given(text: str) -> regions.Split:
    return regions.Split(text, text, (), 0)


def _first_line(body, lines, start):
    """Return the index of the line where ``body`` begins, at or after ``start``: a cell's metadata may precede it."""
    for index in range(start, len(lines)):
        if lines[index : index + len(body)] == body and body:
            return index
    return start


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return [_plain(item) for item in value] if isinstance(value, list) else value
