"""From a chapter to its two notebooks, without running anything."""

from collections import Counter

import nbformat
from nbformat import NotebookNode

from grading.authoring import checked
from grading.authoring.chapter import Chapter, SourceCell
from helpers.exercises import cell_ids

# Fixed, so that neither the author's machine nor the kernel's version shows.
METADATA = {
    'kernelspec': {'display_name': 'Python 3 (ipykernel)', 'language': 'python', 'name': 'python3'},
    'language_info': {
        'codemirror_mode': {'name': 'ipython', 'version': 3},
        'file_extension': '.py',
        'mimetype': 'text/x-python',
        'name': 'python',
        'nbconvert_exporter': 'python',
        'pygments_lexer': 'ipython3',
    },
}


def solved(chapter: Chapter) -> NotebookNode:
    """Return the notebook with all solutions, not executed."""
    return _notebook(chapter, lambda cell: (cell.split.solved, cell.metadata))


def learner(chapter: Chapter) -> NotebookNode:
    """Return the notebook that the learner opens: stubs instead of solutions, exercise cells that cannot be deleted."""
    return _notebook(chapter, lambda cell: (cell.split.stub, _learner_metadata(cell.metadata)))


def dumps(notebook: NotebookNode) -> str:
    """Return the text of the notebook's file."""
    nbformat.validate(notebook)
    return nbformat.writes(notebook).rstrip('\n') + '\n'


def _notebook(chapter, form):
    cells = []
    for cell, identifier in zip(chapter.cells, _ids(chapter.cells), strict=True):
        source, metadata = form(cell)
        node = {'id': identifier, 'cell_type': cell.kind, 'metadata': dict(metadata), 'source': source}
        if cell.kind == 'code':
            node |= {'execution_count': None, 'outputs': []}
        cells.append(node)
    return nbformat.from_dict({'cells': cells, 'metadata': METADATA, 'nbformat': 4, 'nbformat_minor': 5})


def _learner_metadata(metadata: dict) -> dict:
    """Outputs are not compared in the learner's notebook, so their tags go; an exercise cell is kept in place."""
    kept = {key: value for key, value in metadata.items() if key not in ('tags', checked.KEY)}
    tags = [tag for tag in metadata.get('tags', []) if not tag.startswith('nbval-')]
    if tags:
        kept['tags'] = tags
    if 'exercise' in metadata:
        kept['deletable'] = False
    return kept


def _ids(cells: tuple[SourceCell, ...]) -> list[str]:
    """Return the cells' ids, see helpers.exercises.cell_ids."""
    seen: Counter[tuple[str, str]] = Counter()
    ids = []
    for cell in cells:
        if cell.exercise is not None:
            ids.append(cell_ids.of_exercise(cell.exercise['id']))
            continue
        text = cell.split.stub  # what the learner gets: by its id one sees whether it is still that
        seen[cell.kind, text] += 1
        ids.append(cell_ids.of_given(cell.kind, text, seen[cell.kind, text]))
    return ids
