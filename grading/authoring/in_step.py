"""Proves that the generated files are in step with their sources, without running anything."""

from grading.authoring import chapter_build, figures, notebook_pair
from grading.authoring.chapter_build import CourseFolders
from helpers.exercises import manifest


def drift(tree: CourseFolders) -> list[str]:
    """Return one line for each generated file that its source would not give; empty if all is in step.

    :raises ChapterErrors: the sources themselves have mistakes.
    """
    chapters = chapter_build.read_all(tree)
    lines = []
    for chapter in chapters:
        lines += [f'solutions/{chapter.name}.ipynb {what}' for what in chapter_build.solved_drift(tree, chapter)]
        lines += _text_drift(tree.learner(chapter), notebook_pair.dumps(notebook_pair.learner(chapter)), tree)
    rows = [row for chapter in chapters for row in chapter.exercises()]
    lines += _text_drift(tree.manifest, manifest.dumps(rows), tree)
    pictures = figures.pictures(tree.figures)
    for name, text in pictures.items():
        lines += _text_drift(tree.pictures / name, text, tree)
    lines += [
        f'{path.relative_to(tree.root)} has no source'
        for path in sorted(tree.pictures.glob('*'))
        if path.name not in pictures
    ]
    for name, text in chapter_build.pages(tree).items():
        lines += _text_drift(tree.notebooks / name, text, tree)
    names = {f'{chapter.name}.ipynb' for chapter in chapters}
    for folder in (tree.solutions, tree.notebooks):
        found = sorted(path.name for path in folder.glob('*.ipynb'))
        lines += [f'{folder.name}/{name} has no source' for name in found if name not in names]
    return lines


def _text_drift(path, wanted, tree):
    name = path.relative_to(tree.root)
    if not path.exists():
        return [f'{name} is missing']
    return [] if path.read_text(encoding='utf-8') == wanted else [f'{name} is not what its source gives']
