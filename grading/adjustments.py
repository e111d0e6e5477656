"""Marks that the instructor sets or changes by hand, from a CSV or YAML file. They are merged last.

    learner,exercise,points,delta,reason
    ada,3.2,8,,the header is right on paper
    bob,3.1,,-1,handed in twice

`points` is the mark itself, `delta` is added to it; one of the two. YAML is a list of the same: `- {learner: ada, …}`.
Columns may be separated by `;` or tabs, too, as spreadsheets of other languages save them.
"""

import csv
import io
import math
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import yaml

from grading import plain_yaml

FIELDS = ('learner', 'exercise', 'points', 'delta', 'reason')


class AdjustmentError(Exception):
    """The adjustments cannot be used; the message names the place."""


@dataclass(frozen=True)
class Adjustment:
    """One change of one mark."""

    learner: str
    exercise: str
    points: float | None
    delta: float | None
    reason: str

    def applied(self, mark: float | None, points: float) -> float | None:
        """The mark with this change, from 0 to the exercise's points. An unknown mark stays so, unless it is set."""
        if self.points is not None:
            mark = self.points
        elif mark is not None:
            mark += self.delta or 0.0
        return None if mark is None else round(min(points, max(0.0, mark)), 2)


def load(path: Path, points: dict[str, float]) -> list[Adjustment]:
    """Read adjustments; `points` are what each exercise has.

    :raises AdjustmentError: the file cannot be read, or an exercise in it is unknown, or a value unusable.
    """
    try:
        text = path.read_text(encoding='utf-8-sig')
        rows = plain_yaml.read(text) if path.suffix in ('.yaml', '.yml') else _csv(text)
    except UnicodeDecodeError:
        raise AdjustmentError(f'{path} is not in UTF-8: save it again, as "CSV UTF-8"') from None
    except (OSError, yaml.YAMLError, csv.Error) as error:
        raise AdjustmentError(f'{path} cannot be read: {getattr(error, "strerror", None) or error}') from None
    if rows is None:
        return []
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise AdjustmentError(f'{path}: expected a list of {", ".join(FIELDS)}')
    adjustments = [_read(f'{path}, entry {number}', row, points) for number, row in enumerate(rows, 1)]
    set_by: dict[tuple[str, str], int] = {}
    for number, one in enumerate(adjustments, 1):
        if one.points is not None and set_by.setdefault((one.learner, one.exercise), number) != number:
            raise AdjustmentError(
                f'{path}, entry {number}: the mark of {one.learner} in {one.exercise} is set in entry '
                f'{set_by[one.learner, one.exercise]}, too'
            )
    return adjustments


def check(adjustments: Iterable[Adjustment], learners: Iterable[str]) -> None:
    """Make sure that every adjustment is for one of `learners`.

    :raises AdjustmentError: one is not.
    """
    known = set(learners)
    for adjustment in adjustments:
        if adjustment.learner not in known:
            raise AdjustmentError(f'an adjustment is for the unknown learner {adjustment.learner!r}')


def _csv(text: str) -> list[dict]:
    header = text.partition('\n')[0]
    delimiter = max(',;\t', key=header.count)
    table = csv.DictReader(io.StringIO(text, newline=''), delimiter=delimiter, strict=True)
    names = [name.strip() for name in table.fieldnames or ()]
    table.fieldnames = names
    doubled = next((name for name in names if names.count(name) > 1 and name), '')
    if doubled:
        raise csv.Error(f'there are two columns {doubled}')
    if names and not {'learner', 'exercise', 'reason'} <= set(names):
        raise csv.Error(f'its first line must be the names of the columns: {",".join(FIELDS)}')
    rows = ({name: text.strip() if isinstance(text, str) else text for name, text in row.items()} for row in table)
    return [row for row in rows if any(row.values())]  # spreadsheets leave empty rows at the end


def _read(where: str, row: dict, points: dict[str, float]) -> Adjustment:
    row = {key: value for key, value in row.items() if value not in (None, '')}
    unknown = [key for key in row if key not in FIELDS]
    if unknown:
        raise AdjustmentError(f'{where}: {unknown[0]!r} is unknown; there are: {", ".join(FIELDS)}')
    for key in ('learner', 'exercise', 'reason'):
        if key not in row:
            raise AdjustmentError(f'{where}: {key} is missing')
    if not isinstance(row['exercise'], str):  # YAML takes 3.10 for the number 3.1
        raise AdjustmentError(f"{where}: write the exercise in quotes, '{row['exercise']}'")
    if isinstance(row['learner'], bool) or not isinstance(row['learner'], (str, int)):  # 1.50 is read as 1.5
        raise AdjustmentError(f"{where}: write the learner in quotes, '{row['learner']}'")
    exercise = row['exercise'].strip()
    if exercise not in points:
        raise AdjustmentError(f'{where}: there is no exercise {exercise!r}')
    if ('points' in row) == ('delta' in row):
        raise AdjustmentError(f'{where}: give either points or delta')
    mark, delta = _number(where, row, 'points'), _number(where, row, 'delta')
    if mark is not None and not 0 <= mark <= points[exercise]:
        raise AdjustmentError(f'{where}: exercise {exercise} has {points[exercise]:g} points, not {mark:g}')
    return Adjustment(str(row['learner']).strip(), exercise, mark, delta, str(row['reason']).strip())


def _number(where: str, row: dict, name: str) -> float | None:
    if name not in row:
        return None
    try:
        value = math.nan if isinstance(row[name], bool) else float(row[name])  # YAML takes yes for True
    except (TypeError, ValueError, OverflowError):
        value = math.nan
    if not math.isfinite(value):
        raise AdjustmentError(f'{where}: {name} must be a number, not {row[name]!r}')
    return value
