"""`gradescope/<learner>.json`: Gradescope's results.json.

Each exercise gives two entries: its visible tests, which are always shown, and its hidden ones, which are shown when
`HIDDEN` says so. Were they shown at once, a learner could find out by repeated submissions what is tested. As long as
they are not shown, no other text tells of them: neither the output nor the visible entries.

A deduction for lateness, or a change by hand, is in the total only, which overrides the sum of the entries.

The contract is `grading/schemas/gradescope.schema.json`; see also
https://gradescope-autograders.readthedocs.io/en/latest/specs/.
"""

import json

from grading.record import Record
from grading.reports import page
from grading.reports.safe import line, visible
from helpers.exercises import result_display
from helpers.runner import results, verdicts
from helpers.runner.results import ExerciseResult, TestResult

VISIBILITIES = ('visible', 'after_due_date', 'after_published', 'hidden')
HIDDEN = 'after_published'
LONGEST = 20_000  # characters of one entry


def dumps(record: Record, hidden: str = HIDDEN, warnings: list[str] | None = None) -> str:
    """The report as JSON text. A run with a fault of the grader's has no total score.

    :param hidden: when the learner sees the hidden tests, one of VISIBILITIES.
    :param warnings: lines that the learner and the instructor read first.
    :raises ValueError: `hidden` is none of them.
    """
    if hidden not in VISIBILITIES:
        raise ValueError(f'{hidden!r} is none of {", ".join(VISIBILITIES)}')
    tests = [entry for exercise in record.exercises for entry in _entries(exercise, hidden)]
    result = {
        'output': _clip('\n'.join([*(warnings or ()), *_overall(record, hidden)])),
        'output_format': 'text',
        'visibility': 'visible',
        'stdout_visibility': 'hidden',
        'tests': tests,
        'execution_time': round(sum(test.seconds for exercise in record.exercises for test in exercise.tests), 3),
        'extra_data': {'sandbox': record.sandbox, 'key': record.key, 'seed': record.seed, 'status': record.status},
    }
    if record.score is not None:
        result['score'] = record.score
    return json.dumps(result, indent=1, ensure_ascii=False) + '\n'


def _overall(record: Record, hidden: str) -> list[str]:
    if record.score is None:
        return ['A part of this work must be graded again because of a fault of the grader. No mark is lost.']
    if hidden == 'visible':
        return [f'{page.points(record.score)} of {page.points(record.points)} points']
    public = [test for exercise in record.exercises for test in exercise.tests if not test.hidden]
    passed = sum(test.passed for test in public)
    untested = sum(not exercise.tests for exercise in record.exercises)
    if public and passed == len(public) and not untested:
        head = 'All public tests passed'
    else:
        head = f'{passed} of {page.plural(len(public), "public test")} passed'
    lines = [f'{head}; hidden tests run after submission. They count too: their results and the total are shown later.']
    if untested:
        lines.append(f'{page.plural(untested, "exercise")} could not be tested: see below.')
    return lines


def _entries(exercise: ExerciseResult, hidden: str) -> list[dict]:
    """The entries of one exercise. Their scores add up to its score, their greatest scores to its points."""
    public = [test for test in exercise.tests if not test.hidden]
    secret = [test for test in exercise.tests if test.hidden]
    if not public or not secret:
        shown = hidden if secret else 'visible'
        return [_entry(exercise, exercise.tests, '', exercise.points, exercise.score, shown)]
    weight = sum(test.weight for test in exercise.tests)
    share, reached = (
        (sum(test.weight for test in public if test.passed or every) / weight * exercise.points)
        for every in (True, False)
    )
    known = exercise.score is not None
    share, reached = round(share, 2), min(round(reached, 2), exercise.score or 0.0)  # which may be less: `given`
    return [
        _entry(exercise, public, ' (public tests)', share, reached if known else None, 'visible'),
        _entry(
            exercise,
            secret,
            ' (hidden tests)',
            round(exercise.points - share, 2),
            None if exercise.score is None else round(exercise.score - reached, 2),
            hidden,
        ),
    ]


def _entry(
    exercise: ExerciseResult, tests: list[TestResult], what: str, points: float, score: float | None, visibility: str
) -> dict:
    entry = {
        'number': line(exercise.id),
        'name': line(result_display.heading(exercise)) + what,
        'max_score': points,
        'output': _clip(_text(exercise, tests)),
        'output_format': 'text',
        'visibility': visibility,
    }
    if score is not None:
        passed = all(test.passed for test in tests) if tests else exercise.passed
        entry |= {'score': max(0.0, score), 'status': 'passed' if passed else 'failed'}
    return entry


def _text(exercise: ExerciseResult, tests: list[TestResult]) -> str:
    lines = [exercise.message] if exercise.message else []
    if exercise.verdict == verdicts.GRADER_ERROR:
        lines.append('This exercise must be graded again because of a fault of the grader.')
    again = result_display.repeated(
        ExerciseResult(exercise.id, exercise.title, exercise.points, exercise.verdict, None, tests=tests)
    )
    for test in tests:
        if test.expected:
            lines.append(f'{"passed" if test.passed else "FAILED"}: {result_display.expected(test)}')
        if test.test in again:
            lines.append('    The same as above.')
        elif not test.passed:
            lines += [f'    {text}' for text in result_display.happened(test)]
            if result_display.hint(test):
                lines.append(f'    {result_display.hint(test)}')
    if exercise.verdict == results.NOT_ATTEMPTED and not lines:
        lines.append('Not begun.')
    return '\n'.join(lines)


def _clip(text: str) -> str:
    return page.shorten(visible(text), LONGEST)
