"""A course in a temporary folder, with one tiny chapter."""

import pytest

from grading.authoring import chapter_build
from grading.tests.authoring import sources


@pytest.fixture
def tree(tmp_path):
    """The folders of a course; its one source is sources.TINY."""
    tree = chapter_build.CourseFolders(tmp_path / 'course')
    tree.solutions.mkdir(parents=True)
    tree.notebooks.mkdir()
    write(tree, sources.TINY)
    return tree


@pytest.fixture
def built(tree):
    """The same, with notebooks that were made without running a kernel: outputs are invented."""
    make_without_kernel(tree)
    return tree


def write(tree, text, name='07_tiny.md'):
    """Write a source and return its path."""
    path = tree.solutions / name
    path.write_text(text, encoding='utf-8')
    return path


def make_without_kernel(tree):
    """Do what build does, with a stand-in for the kernel."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(chapter_build.execution, 'execute', count_cells)
        chapter_build.build(tree, say=lambda line: None)


def count_cells(notebook, chapter, folder, timeout):
    """Stand in for execution.execute."""
    for number, cell in enumerate(cell for cell in notebook.cells if cell.cell_type == 'code'):
        cell.execution_count = number + 1
