"""Builds the chapters: sources to solved notebooks, learner's notebooks and the list of exercises."""

import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import nbformat
from nbformat import NotebookNode

from environment.setup import whole_file
from grading.authoring import book as books
from grading.authoring import chapter as chapters
from grading.authoring import execution, figures, indexes, notebook_pair, outputs, rules
from grading.authoring.chapter import Chapter
from grading.authoring.chapter_errors import AuthoringError, ChapterErrors
from helpers.exercises import manifest

RULES_KEPT = re.compile(r'\bof (\d+) rules are kept')  # in what a check prints


@dataclass(frozen=True)
class CourseFolders:
    """Where sources and generated files are, below the root of the course."""

    root: Path

    @property
    def solutions(self) -> Path:
        """Sources and executed notebooks."""
        return self.root / 'solutions'

    @property
    def notebooks(self) -> Path:
        """What the learner opens."""
        return self.root / 'notebooks'

    @property
    def manifest(self) -> Path:
        """The list of exercises."""
        return self.root / manifest.MANIFEST.relative_to(manifest.MANIFEST.parents[2])

    @property
    def figures(self) -> Path:
        """What draws the figures."""
        return self.solutions / figures.FOLDER

    @property
    def pictures(self) -> Path:
        """The figures as the notebooks show them."""
        return self.notebooks / figures.FOLDER

    def solved(self, chapter: Chapter) -> Path:
        """The executed notebook of ``chapter``."""
        return self.solutions / f'{chapter.name}.ipynb'

    def learner(self, chapter: Chapter) -> Path:
        """The learner's notebook of ``chapter``."""
        return self.notebooks / f'{chapter.name}.ipynb'


def read_all(tree: CourseFolders) -> list[Chapter]:
    """Read every source and check it against the rules.

    :raises ChapterErrors: with all mistakes found.
    """
    try:
        book = books.load(tree.solutions)
    except AuthoringError as error:
        raise ChapterErrors([error]) from None
    read, errors = [], []
    for path in chapters.sources(tree.solutions):
        try:
            read.append(chapters.read(path, book))
        except AuthoringError as error:
            errors.append(error)
    errors += rules.check(read)
    if not errors:  # a chapter that cannot be read may show any figure
        errors = figures.check(tree.figures, [name for one in read for cell in one.cells for name in cell.figures])
    if errors:
        raise ChapterErrors(errors)
    return read


def pages(tree: CourseFolders) -> dict[str, str]:
    """Return the pages for all chapters, glossary and symptoms, by file name; the sources are free of mistakes."""
    return indexes.pages(tree.solutions, books.load(tree.solutions))


def build(
    tree: CourseFolders,
    selected: set[int] | None = None,
    force: bool = False,
    timeout: float = execution.CELL_TIMEOUT,
    say: Callable[[str], None] = print,
) -> None:
    """Build the chapters numbered in ``selected`` (default: all) that differ from their sources, or all with ``force``.

    A chapter in which only prose has changed, and no rule of a card, keeps its outputs and is not executed, unless
    with ``force``.
    Figures, pages, learner's notebook and list of exercises are written first: ``check`` in the executed notebook needs
    the list.

    :param timeout: longest time of one cell, in seconds.
    :param say: takes the lines that tell the progress.
    :raises ChapterErrors: mistakes in the sources, a failing cell, a notebook that is too big.
    """
    all_chapters = read_all(tree)
    whole_file.update(tree.manifest, manifest.dumps(row for chapter in all_chapters for row in chapter.exercises()))
    _draw(tree)
    for name, text in pages(tree).items():
        whole_file.update(tree.notebooks / name, text)
    errors = []
    for chapter in all_chapters:
        if selected is not None and chapter.number not in selected:
            continue
        for text in rules.advice(chapter):
            say(text)
        whole_file.update(tree.learner(chapter), notebook_pair.dumps(notebook_pair.learner(chapter)))
        if not force and not solved_drift(tree, chapter):
            say(f'{chapter.name}: unchanged')
            continue
        try:
            whole_file.update(tree.solved(chapter), _executed(tree, chapter, timeout, not force, say))
        except AuthoringError as error:
            errors.append(error)
    if errors:
        raise ChapterErrors(errors)


def solved_drift(tree: CourseFolders, chapter: Chapter) -> list[str]:
    """Return in what the executed notebook differs from its source, as short texts; empty if in step."""
    path = tree.solved(chapter)
    try:
        text = path.read_text(encoding='utf-8')
        notebook = nbformat.reads(text, as_version=4)
    except FileNotFoundError:
        return ['is missing']
    except (ValueError, nbformat.ValidationError) as error:
        return [f'cannot be read ({error})']
    drift = [] if len(text.encode()) <= outputs.MAX_BYTES else [f'is larger than {outputs.MAX_BYTES // 1000} kB']
    if any(cell.cell_type == 'code' and cell.execution_count is None for cell in notebook.cells):
        drift.append('has cells that were never executed')
    return drift + differences(notebook, notebook_pair.solved(chapter)) + other_rules(notebook, chapter)


def differences(found: nbformat.NotebookNode, wanted: nbformat.NotebookNode) -> list[str]:
    """Return how two notebooks differ, outputs and execution counts aside."""
    if [cell.id for cell in found.cells] != [cell.id for cell in wanted.cells]:
        return ['has other cells than its source']
    result = []
    for number, (one, other) in enumerate(zip(found.cells, wanted.cells, strict=True), start=1):
        what = [part for part in ('cell_type', 'source', 'metadata') if one[part] != other[part]]
        if what:
            result.append(f'differs from its source in the {" and ".join(what)} of cell {number} ({one.id})')
    if found.metadata != wanted.metadata:
        result.append("differs from its source in the notebook's metadata")
    return result


def other_rules(notebook: NotebookNode, chapter: Chapter) -> list[str]:
    """Return what kept outputs of checks say of more or fewer rules than the cards have.

    Rules stand in prose, so a check counts others when no code has changed.
    """
    cells = {cell.card.check: cell for cell in chapter.cells if cell.card is not None}
    result = []
    for cell in notebook.cells:
        check = cell.source.strip()
        if check not in cells:
            continue
        counted = {int(count) for count in RULES_KEPT.findall(json.dumps(cell.get('outputs', [])))}
        rules_of_card = len(cells[check].rules)
        if counted - {rules_of_card}:
            result.append(f'has an output of {check} that counts {max(counted)} rules; its card has {rules_of_card}')
    return result


def _draw(tree: CourseFolders) -> None:
    """Write all figures, and remove the pictures of those that are gone."""
    pictures = figures.pictures(tree.figures)
    for name, text in pictures.items():
        whole_file.update(tree.pictures / name, text)
    for path in tree.pictures.glob('*.svg'):
        if path.name not in pictures:
            path.unlink()


def _executed(tree: CourseFolders, chapter: Chapter, timeout: float, keep: bool, say: Callable[[str], None]) -> str:
    notebook = notebook_pair.solved(chapter)
    if keep and _keep_outputs(tree.solved(chapter), notebook) and not other_rules(notebook, chapter):
        say(f'{chapter.name}: only its prose has changed')
    else:
        say(f'{chapter.name}: executing')
        execution.execute(notebook, chapter, tree.notebooks, timeout)
        outputs.settle(notebook, tree.root)
    text = notebook_pair.dumps(notebook)
    size = len(text.encode()) / 1e6
    if size > outputs.MAX_BYTES / 1e6:
        raise AuthoringError(
            chapter.path,
            None,
            f'its notebook has {size:.1f} MB with outputs, 1 MB is allowed',
            'make its outputs smaller: fewer or smaller pictures, a link instead of a page',
        )
    return text


def _keep_outputs(path: Path, notebook: NotebookNode) -> bool:
    """Give `notebook` the outputs of the executed one in `path` if only prose differs; tells whether it did."""
    try:
        old = nbformat.read(path, as_version=4)
    except (OSError, ValueError, nbformat.ValidationError):
        return False

    def code(of):
        return [cell for cell in of.cells if cell.cell_type == 'code']

    pairs = list(zip(code(old), code(notebook), strict=False))
    if len(code(old)) != len(code(notebook)) or any(
        one.execution_count is None or (one.id, one.source, one.metadata) != (other.id, other.source, other.metadata)
        for one, other in pairs
    ):
        return False
    for one, other in pairs:
        other.outputs, other.execution_count = one.outputs, one.execution_count
    return True
