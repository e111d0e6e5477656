"""A chapter's source, `solutions/NN_name.md`, read into cells that know their line numbers."""

import re
from dataclasses import dataclass
from pathlib import Path

import yaml
from jupytext.myst import MystMetadataParsingError, myst_to_notebook
from nbformat import ValidationError

from grading.authoring import regions
from grading.authoring.errors import AuthoringError
from helpers.exercises import cell_ids, manifest

FILE_NAME = re.compile(r'(\d\d)_[a-z0-9_]+\.md')


@dataclass(frozen=True)
class Cell:
    """One cell of the source. ``line`` is the 1-based line of its first line of text."""

    kind: str  # 'code', 'markdown' or 'raw'
    source: str
    metadata: dict
    line: int
    split: regions.Split

    @property
    def exercise(self) -> dict | None:
        """The exercise's metadata, as the author wrote it."""
        return self.metadata.get('exercise')

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
    cells: tuple[Cell, ...]

    @property
    def name(self) -> str:
        """The file's name without its suffix, '03_nodes_and_topics'."""
        return self.path.stem

    def exercises(self) -> list[manifest.Exercise]:
        """Return the chapter's rows of exercises.json; the source must be free of mistakes (rules.check)."""
        return [
            manifest.Exercise(
                id=cell.exercise['id'],
                chapter=self.number,
                notebook=f'{self.name}.ipynb',
                title=cell.source.splitlines()[0].split(':', 1)[1].strip(),
                points=cell.exercise['points'],
                names=tuple(cell.exercise['names']),
                cell_id=cell_ids.of_exercise(cell.exercise['id']),
                stub=manifest.stub_digest(cell.split.stub),
            )
            for cell in self.cells if cell.exercise is not None
        ]


def sources(folder: Path) -> list[Path]:
    """Return the chapters' sources in ``folder``, in order."""
    return sorted(path for path in folder.glob('*.md') if FILE_NAME.fullmatch(path.name))


def read(path: Path) -> Chapter:
    """Read one source.

    :raises AuthoringError: the file is no MyST notebook, or its solution markers do not match.
    """
    match = FILE_NAME.fullmatch(path.name)
    if not match:
        raise AuthoringError(path, None, 'not the name of a chapter', 'call it NN_name.md, in lower case')
    text = path.read_text(encoding='utf-8')
    try:
        notebook = myst_to_notebook(text, add_source_map=True)
    except (MystMetadataParsingError, yaml.YAMLError) as error:
        line = re.search(r'at line (\d+)', str(error))
        problem = ' '.join(str(error).split())
        raise AuthoringError(path, int(line[1]) if line else 1, problem, 'mend the YAML of the metadata') from None
    except ValidationError as error:
        lines = text.splitlines()
        line = next((number for number, line in enumerate(lines, start=1) if str(error.instance) in line), 1)
        raise AuthoringError(path, line, f'metadata: {error.message}', 'write tags as :tags: [name, …]') from None
    lines = text.splitlines()
    starts = notebook.metadata.source_map
    cells = [_cell(path, cell, lines, start) for cell, start in zip(notebook.cells, starts, strict=True)]
    return Chapter(path, int(match[1]), tuple(cells))


def _cell(path, node, lines, start):
    line = _first_line(node.source.splitlines(), lines, start) + 1
    try:
        if node.cell_type == 'code':
            split = regions.split(node.source)
        else:
            split = regions.Split(node.source, node.source, (), 0)
    except regions.MarkerError as error:
        raise AuthoringError(path, line + error.offset, error.problem, error.remedy) from None
    return Cell(node.cell_type, node.source, _plain(node.metadata), line, split)


def _first_line(body, lines, start):
    """Return the index of the line where ``body`` begins, at or after ``start``: a cell's metadata may precede it."""
    for index in range(start, len(lines)):
        if lines[index:index + len(body)] == body and body:
            return index
    return start


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return [_plain(item) for item in value] if isinstance(value, list) else value
