"""`gradescope/<learner>.json`: Gradescope's results.json."""

import json

from grading.record import Record
from helpers import display


def dumps(record: Record) -> str:
    """One entry per exercise: its score, and what the learner reads. A faulty run has no score at all."""
    tests = []
    for exercise in record.exercises:
        test = {'number': exercise.id, 'name': display.heading(exercise), 'max_score': exercise.points,
                'output': _text(exercise), 'output_format': 'text', 'visibility': 'visible'}
        if exercise.score is not None:
            test |= {'score': exercise.score, 'status': 'passed' if exercise.passed else 'failed'}
        tests.append(test)
    result = {'output': f'{_points(record.score)} of {_points(record.points)} points', 'tests': tests,
              'extra_data': {'sandbox': record.sandbox, 'key': record.key, 'status': record.status}}
    if record.score is not None:
        result['score'] = record.score
    return json.dumps(result, indent=1, ensure_ascii=False) + '\n'


def _text(exercise) -> str:
    lines = [exercise.message] if exercise.message else []
    for test in exercise.tests:
        if test.expected:
            lines.append(f'{"passed" if test.passed else "FAILED"}: {display.expected(test)}')
        if not test.passed:
            lines += [f'    {line}' for line in display.happened(test)]
            if display.hint(test):
                lines.append(f'    {display.hint(test)}')
    return '\n'.join(lines)


def _points(value: float | None) -> str:
    return 'unknown' if value is None else f'{value:g}'
