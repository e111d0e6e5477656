"""`gradebook.csv`: one row per learner, one column per exercise, total and status."""

import csv
import io
from collections.abc import Iterable

from grading.record import Record
from helpers.exercises.manifest import Exercise


def dumps(records: Iterable[Record], exercises: Iterable[Exercise]) -> str:
    """The gradebook's text. A score that a grader's fault leaves unknown is an empty field."""
    exercises = list(exercises)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator='\n')
    writer.writerow(['learner', *(exercise.id for exercise in exercises), 'total', 'status'])
    for record in sorted(records, key=lambda record: record.learner):
        scores = {exercise.id: exercise.score for exercise in record.exercises}
        writer.writerow([cell(record.learner), *(_number(scores.get(exercise.id)) for exercise in exercises),
                         _number(record.score), record.status])
    return text.getvalue()


def cell(text: str) -> str:
    """Text in one line that a spreadsheet does not take for a formula."""
    text = text.replace('\r', ' ').replace('\n', ' ')
    return f"'{text}" if text[:1] in ('=', '+', '-', '@', '\t') else text


def _number(score: float | None) -> str:
    return '' if score is None else f'{score:g}'
