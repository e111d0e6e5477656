"""Writes the pages of the edition."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import nbformat
from jinja2 import Environment, FileSystemLoader
from nbconvert import HTMLExporter

from grading.authoring import build as builder
from grading.authoring import notebooks
from grading.authoring.chapter import Chapter
from helpers import start_page

TEMPLATES = Path(__file__).with_name('templates')


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


def write(tree: builder.Tree, output: Path, say: Callable[[str], None] = print) -> list[Path]:
    """Write ``index.html`` and a page for each chapter to `output`, from the executed notebooks; returns the pages.

    :raises EditionError: `output` is not empty, or an executed notebook does not fit its source.
    :raises grading.authoring.errors.ChapterErrors: mistakes in the sources.
    """
    if output.exists() and (not output.is_dir() or any(output.iterdir())):
        raise EditionError(f'{output} is not empty: give a new folder')
    chapters = builder.read_all(tree)
    for chapter in chapters:
        if drift := builder.solved_drift(tree, chapter):
            raise EditionError(f'{tree.solved(chapter).name} {drift[0]}: run ./course build {chapter.number:02} first')
    output.mkdir(parents=True, exist_ok=True)
    entries = [_entry(tree, chapter) for chapter in chapters]
    written = []
    for number, chapter in enumerate(chapters):
        around = {'before': entries[number - 1] if number else None,
                  'after': entries[number + 1] if number + 1 < len(entries) else None}
        path = output / entries[number].page
        path.write_text(_page(readable(tree, chapter), entries[number].title, around), encoding='utf-8')
        say(f'{path.name}: {path.stat().st_size / 1e6:.1f} MB')
        written.append(path)
    contents = Environment(loader=FileSystemLoader(TEMPLATES), autoescape=True).get_template('contents.html.j2')
    index = output / 'index.html'
    index.write_text(contents.render(chapters=entries) + '\n', encoding='utf-8')
    return [index, *written]


def readable(tree: builder.Tree, chapter: Chapter) -> nbformat.NotebookNode:
    """The executed notebook without solutions: exercises as the learner gets them; they and checks print nothing."""
    notebook = nbformat.read(tree.solved(chapter), as_version=4)
    for cell, stub in zip(notebook.cells, notebooks.learner(chapter).cells, strict=True):
        if 'exercise' in cell.metadata or cell.cell_type == 'code' and cell.source.startswith('check('):
            cell.source, cell.outputs, cell.execution_count = stub.source, [], None
    return notebook


def _page(notebook: nbformat.NotebookNode, title: str, around: dict) -> str:
    exporter = HTMLExporter(template_name='course', extra_template_basedirs=[str(TEMPLATES)])
    text, _ = exporter.from_notebook_node(notebook, resources={'metadata': {'name': title}, 'course': around})
    return text


def _entry(tree: builder.Tree, chapter: Chapter) -> Entry:
    said = start_page.introduction(tree.learner(chapter))
    return Entry(f'{chapter.name}.html', said.title, said.thesis, said.time, len(list(chapter.exercises())))
