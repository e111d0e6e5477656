"""Programs that are right: the course's own solutions, as the learner's process would load them.

With them the grader finds out who makes a fault, the tests or the program: see `helpers.runner.session`. They decide
only whether a mark stays open.
"""

from functools import cache

from helpers import paths
from helpers.exercises import notebooks
from helpers.exercises import program as programs
from helpers.exercises.manifest import Exercise

SOLUTIONS = paths.ROOT / 'solutions'


@cache
def solved(number: int) -> tuple[notebooks.NotebookCell, ...]:
    """The cells of a chapter's solved notebook.

    :raises LookupError: its source is not here, as where only marks are given.
    """
    from grading.authoring import chapter as chapters  # both are needed rarely
    from grading.authoring import notebook_pair as authored

    for path in chapters.sources(SOLUTIONS):
        if path.name.startswith(f'{number:02}_'):
            cells = authored.solved(chapters.read(path))
            return tuple(notebooks.parse(authored.dumps(cells).encode(), path.name))
    raise LookupError(f'there is no source of chapter {number}')


def program(exercise: Exercise) -> dict | None:
    """The solution of an exercise; None if it is not here."""
    try:
        return programs.build(list(solved(exercise.chapter)), exercise).as_dict()
    except (ImportError, LookupError, programs.NotAttempted, programs.InvalidExercise):
        return None
