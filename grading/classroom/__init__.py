"""GitHub Classroom: the workflow that a learner's repository carries.

It runs the visible checks, chapter by chapter, so that Classroom shows how far a learner is. It is no grading: learners
may change all that is in their repository, the workflow too. Marks come from `./course grade`, run elsewhere.
"""

from collections.abc import Iterable
from pathlib import Path

from jinja2 import Environment, StrictUndefined

from helpers.exercises.manifest import Exercise

PATH = '.github/workflows/classroom.yml'
_TEMPLATE = Path(__file__).parent / 'classroom.yml.j2'


def workflow(exercises: Iterable[Exercise]) -> str:
    """The workflow's text, with one check for each chapter that has exercises."""
    chapters: dict[int, float] = {}
    for exercise in exercises:
        chapters[exercise.chapter] = chapters.get(exercise.chapter, 0) + exercise.points
    # GitHub's own ${{ … }} stays as it is.
    environment = Environment(
        variable_start_string='[[',
        variable_end_string=']]',
        block_start_string='[%',
        block_end_string='%]',
        comment_start_string='[#',
        comment_end_string='#]',
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
    )
    template = environment.from_string(_TEMPLATE.read_text(encoding='utf-8'))
    return template.render(chapters=[(number, round(points)) for number, points in sorted(chapters.items())])
