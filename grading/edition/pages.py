"""Writes the pages of the edition.

Chapters that show a `TfView` are executed anew, because their saved notebooks hold only pictures.
`helpers.show.views.recording` then writes a page for each view, and the chapter's page opens it in place of the picture
when somebody clicks.
"""

import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import nbformat
from jinja2 import Environment, FileSystemLoader
from nbconvert import HTMLExporter

from grading.authoring import chapter_build as builder
from grading.authoring import execution, figures, notebook_pair, outputs
from grading.authoring.chapter import Chapter
from grading.authoring.chapter_errors import AuthoringError, ChapterErrors
from grading.edition import file_lexer
from helpers.exercises import start_page
from helpers.show.views import recording

TEMPLATES = Path(__file__).with_name('templates')
_TO_A_CHAPTER = re.compile(r'\]\((\d\d_\w+|GLOSSARY|SYMPTOMS)\.(?:ipynb|md)\b(#)?(?:heading=)?')
SCENES = 'scenes'  # the folder of the views' pages, beside the chapters' pages


class EditionError(Exception):
    """The pages cannot be written; the message names the remedy."""


@dataclass(frozen=True)
class Entry:
    """A chapter in the list of contents."""

    page: str
    title: str
    thesis: str
    time: str
    exercises: int


def write(
    tree: builder.CourseFolders,
    output: Path,
    say: Callable[[str], None] = print,
    scenes: bool = True,
    timeout: float = execution.CELL_TIMEOUT,
) -> list[Path]:
    """Write ``index.html`` and a page for each chapter to `output`, from the executed notebooks; returns the pages.

    :param scenes: execute the chapters with 3-D views, and add a page for each view; else pictures are all.
    :param timeout: longest time of one cell then, in seconds.
    :raises EditionError: `output` is not empty, or an executed notebook does not fit its source.
    :raises grading.authoring.chapter_errors.ChapterErrors: mistakes in the sources, a failing cell.
    """
    if output.exists() and (not output.is_dir() or any(output.iterdir())):
        raise EditionError(f'{output} is not empty: give a new folder')
    chapters = builder.read_all(tree)
    for chapter in chapters:
        if drift := builder.solved_drift(tree, chapter):
            raise EditionError(f'{tree.solved(chapter).name} {drift[0]}: run ./course build {chapter.number:02} first')
    with TemporaryDirectory() as folder:
        executed = [
            _recorded(tree, chapter, Path(folder), timeout, say)
            if scenes and _has_views(chapter)
            else nbformat.read(tree.solved(chapter), as_version=4)
            for chapter in chapters
        ]
        shown = [readable(chapter, notebook) for chapter, notebook in zip(chapters, executed, strict=True)]
        output.mkdir(parents=True, exist_ok=True)
        if tree.pictures.is_dir():
            shutil.copytree(tree.pictures, output / figures.FOLDER)
        _keep_scenes(shown, Path(folder), output / SCENES, say)
    entries = [_entry(tree, chapter) for chapter in chapters]
    written = []
    for number, notebook in enumerate(shown):
        around = {
            'before': entries[number - 1] if number else None,
            'after': entries[number + 1] if number + 1 < len(entries) else None,
            'scenes': SCENES,
        }
        path = output / entries[number].page
        path.write_text(_page(notebook, entries[number].title, around), encoding='utf-8')
        say(f'{path.name}: {path.stat().st_size / 1e6:.1f} MB')
        written.append(path)
    extra = {}
    for name, text in builder.pages(tree).items():
        notebook = nbformat.v4.new_notebook(
            cells=[nbformat.v4.new_markdown_cell(_TO_A_CHAPTER.sub(r'](\1.html\2', text))]
        )
        title = text.partition('\n')[0].lstrip('# ')
        path = output / f'{Path(name).stem}.html'
        path.write_text(_page(notebook, title, {'before': None, 'after': None, 'scenes': SCENES}), encoding='utf-8')
        extra[title] = path.name
    contents = Environment(loader=FileSystemLoader(TEMPLATES), autoescape=True).get_template('contents.html.j2')
    index = output / 'index.html'
    index.write_text(contents.render(chapters=entries, extra=extra) + '\n', encoding='utf-8')
    return [index, *written]


def readable(chapter: Chapter, notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """Take the solutions out of a chapter's executed notebook; returns it.

    Exercises are as the learner gets them; they and checks print nothing. Links to other chapters lead to their pages,
    figures are beside the pages. Of a drawing with two forms, the page itself holds the SVG.
    """
    for cell, stub in zip(notebook.cells, notebook_pair.learner(chapter).cells, strict=True):
        if 'exercise' in cell.metadata or cell.cell_type == 'code' and cell.source.startswith('check('):
            cell.source, cell.outputs, cell.execution_count = stub.source, [], None
        elif cell.cell_type == 'markdown':
            cell.source = _TO_A_CHAPTER.sub(r'](\1.html\2', stub.source)
        if cell.cell_type == 'code' and file_lexer.has_files(cell.source):
            cell.metadata['magics_language'] = file_lexer.NAME
        for output in cell.get('outputs', ()):
            if 'image/svg+xml' in output.get('data', ()):
                output.data.pop('text/html', None)
    return notebook


def scenes_of(notebook: nbformat.NotebookNode) -> list[str]:
    """Return the pages of the views that a notebook shows."""
    return [
        output.metadata.scene
        for cell in notebook.cells
        for output in cell.get('outputs', ())
        if 'scene' in output.get('metadata', ())
    ]


def _has_views(chapter: Chapter) -> bool:
    return any('TfView(' in cell.source for cell in notebook_pair.learner(chapter).cells if cell.cell_type == 'code')


def _recorded(
    tree: builder.CourseFolders, chapter: Chapter, folder: Path, timeout: float, say: Callable[[str], None]
) -> nbformat.NotebookNode:
    """Execute a chapter; what its views show goes to `folder`."""
    say(f'{chapter.name}: executing, for its 3-D scenes')
    notebook = notebook_pair.solved(chapter)
    try:
        execution.execute(notebook, chapter, tree.notebooks, timeout, {recording.VARIABLE: str(folder)})
    except AuthoringError as error:
        raise ChapterErrors([error]) from None
    outputs.settle(notebook, tree.root)
    return notebook


def _keep_scenes(shown: list[nbformat.NotebookNode], folder: Path, target: Path, say: Callable[[str], None]) -> None:
    """Copy the scenes that the pages show; not those of solutions."""
    if not (names := [name for notebook in shown for name in scenes_of(notebook)]):
        return
    target.mkdir()
    for name in [*names, *recording.SHARED]:
        shutil.copy(folder / name, target / name)
    size = sum(path.stat().st_size for path in target.iterdir()) / 1e6
    say(f'{SCENES}: {len(names)} scenes, {size:.1f} MB')


def _page(notebook: nbformat.NotebookNode, title: str, around: dict) -> str:
    exporter = HTMLExporter(template_name='course', extra_template_basedirs=[str(TEMPLATES)])
    text, _ = exporter.from_notebook_node(notebook, resources={'metadata': {'name': title}, 'course': around})
    return text


def _entry(tree: builder.CourseFolders, chapter: Chapter) -> Entry:
    said = start_page.introduction(tree.learner(chapter))
    return Entry(f'{chapter.name}.html', said.title, said.thesis, said.time, len(list(chapter.exercises())))
