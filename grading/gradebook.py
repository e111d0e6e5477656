"""`gradebook.csv`: one row per learner, one column per exercise, total and status.

The columns are always these, in the order of the course, so that an LMS can be told once what is what.
"""

import csv
import io
from collections.abc import Iterable

from grading.record import Record
from grading.reports.safe import visible
from helpers.exercises.manifest import Exercise

# Also in the width that East Asian spreadsheets read like the plain sign.
_FORMULA = tuple('=+-@|%＝＋－＠')


def dumps(records: Iterable[Record], exercises: Iterable[Exercise]) -> str:
    """The gradebook's text. A score that a grader's fault leaves unknown is an empty field."""
    exercises = list(exercises)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator='\n')
    writer.writerow(['learner', *(exercise.id for exercise in exercises), 'total', 'status'])
    for record in sorted(records, key=lambda record: record.learner):
        marks = record.marks
        writer.writerow(
            [
                cell(record.learner),
                *(_number(marks.get(exercise.id)) for exercise in exercises),
                _number(record.score),
                record.status,
            ]
        )
    return text.getvalue()


def cell(text: str) -> str:
    """Text in one line that a spreadsheet does not take for a formula, whatever stands before the formula's sign."""
    text = visible(text.replace('\r', ' ').replace('\n', ' '))
    return f"'{text}" if text.lstrip(' \t\'"').startswith(_FORMULA) else text


def _number(score: float | None) -> str:
    return '' if score is None else f'{score:g}'
