"""`feedback/<learner>.html`: one page for the learner: what was expected, what happened, where to look and read on.

It shows never an assertion, a test's code or the grader's own faults. The page works without scripts, by keyboard and
by screen reader, on paper, on a small screen, in light and in dark; it loads nothing.
"""

from grading.record import Record
from grading.reports import page, where_to_read
from grading.reports.safe import line
from helpers.exercises import result_display
from helpers.runner import results, verdicts
from helpers.runner.results import ExerciseResult, TestResult

STATES = {
    verdicts.PASSED: 'solved',
    verdicts.FAILED: 'not there yet',
    verdicts.TIMEOUT: 'does not come to an end',
    verdicts.LEARNER_CRASHED: 'stops with an error',
    verdicts.INVALID_SUBMISSION: 'cannot be run',
    verdicts.GRADER_ERROR: 'to be graded again',
    results.NOT_ATTEMPTED: 'not begun',
}
_TESTS = {
    verdicts.PASSED: 'Passed',
    verdicts.FAILED: 'Not passed',
    verdicts.TIMEOUT: 'Not passed, it did not come to an end',
    verdicts.LEARNER_CRASHED: 'Not passed, your program stopped with an error',
    verdicts.INVALID_SUBMISSION: 'Not passed, it could not be run',
    verdicts.GRADER_ERROR: 'Not known',
}


def dumps(record: Record) -> str:
    """The page."""
    return page.render('feedback.html.j2', view=view(record))


def view(record: Record) -> dict:
    """All that the page shows, as plain values."""
    return {
        'learner': line(record.learner, 80),
        'score': record.score,
        'points': record.points,
        'share': _share(record.score, record.points),
        'tone': 'open' if record.score is None else 'good',
        'sentence': _sentence(record),
        'advice': _advice(record),
        'notes': _notes(record),
        'chapters': _chapters(record),
        'facts': _facts(record),
    }


def _share(score: float | None, points: float) -> float:
    return 0.0 if score is None or points <= 0 else min(1.0, max(0.0, score / points))


def _sentence(record: Record) -> str:
    if record.status == 'incomplete':
        return 'Only a part of your work has been graded so far.'
    if record.score is None:
        return (
            'A part of your work must be graded again because of a fault on our side. Nothing is lost, and there '
            'is nothing that you must do.'
        )
    solved = sum(exercise.passed for exercise in record.exercises)
    if solved == len(record.exercises):
        return 'All exercises are solved. Well done!'
    begun = sum(exercise.verdict != results.NOT_ATTEMPTED for exercise in record.exercises)
    if not begun:
        return 'None of the exercises has been begun yet.'
    return f'{solved} of {page.plural(len(record.exercises), "exercise")} {"is" if solved == 1 else "are"} solved.'


def _advice(record: Record) -> str:
    """What to do first: an exercise that was begun comes before one that was not."""
    open_ones = [
        exercise for exercise in record.exercises if not exercise.passed and exercise.verdict != verdicts.GRADER_ERROR
    ]
    begun = [exercise for exercise in open_ones if exercise.verdict != results.NOT_ATTEMPTED]
    first = next(iter(begun or open_ones), None)
    return f'Go on with exercise {first.id}, {line(first.title)}.' if first else ''


def _notes(record: Record) -> list[str]:
    """What the mark depends on besides the tests."""
    notes = []
    if record.late is not None and record.late.days:
        days = page.plural(record.late.days, 'day')
        notes.append(
            f'Handed in {_when(record.late.handed_in)}, {days} after the due time, {_when(record.late.due)}: '
            f'{page.points(record.late.percent)} % of the points are deducted.'
        )
    if record.ungraded:
        notes.append(f'Not graded yet: {", ".join(map(line, record.ungraded))}.')
    return notes


def _facts(record: Record) -> list[tuple[str, str]]:
    facts = [
        ('Handed in', line(record.source) + (f', {_when(record.handed_in)}' if record.handed_in else '')),
        ('SHA-256', record.sha256[:16]),
        ('Graded as', record.key[:16]),
        ('Sandbox', line(record.sandbox)),
        (
            'Earlier',
            f'{page.plural(len(record.attempts), "submission")}; the latest one counts' if record.attempts else '',
        ),
    ]
    return [(name, value) for name, value in facts if value]


def _when(stamp: str) -> str:
    """An ISO 8601 time in UTC, for a reader."""
    return line(stamp).replace('T', ' ').replace('Z', ' UTC')


def _chapters(record: Record) -> list[dict]:
    marks = record.marks
    chapters: dict[str, dict] = {}
    for exercise in record.exercises:
        shown = _exercise(exercise, marks[exercise.id]) | {'how': _how(record, exercise)}
        chapter = chapters.setdefault(exercise.id.partition('.')[0], {'title': '', 'exercises': []})
        chapter['exercises'].append(shown)
        if shown['place']:
            chapter['title'] = shown['place'].chapter
    return list(chapters.values())


def _how(record: Record, exercise: ExerciseResult) -> list[str]:
    """How the mark comes about, where it is not the tests' alone."""
    late, steps = record.late, []
    if late is not None and late.percent and exercise.score:
        steps = [
            f'By the tests: {page.points(exercise.score)} points.',
            f'Late, less {page.points(late.percent)} %: {page.points(late.applied(exercise.score))} points.',
        ]
    for adjustment in record.adjustments:
        if adjustment.exercise == exercise.id:
            change = (
                f'set to {page.points(adjustment.points)} points'
                if adjustment.points is not None
                else f'{adjustment.delta:+g} points'
            )
            steps.append(f'By your instructor: {change}. {line(adjustment.reason, 1000)}')
    return steps


def _exercise(exercise: ExerciseResult, mark: float | None) -> dict:
    again = result_display.repeated(exercise)
    weight = sum(test.weight for test in exercise.tests)
    return {
        'id': line(exercise.id),
        'title': line(exercise.title),
        'anchor': 'exercise-' + ''.join(sign if sign.isalnum() and sign.isascii() else '-' for sign in exercise.id),
        'score': mark,
        'points': exercise.points,
        'share': _share(mark, exercise.points),
        'tone': tone(exercise.verdict),
        'state': STATES[exercise.verdict],
        'summary': _summary(exercise),
        'message': '' if exercise.verdict == results.NOT_ATTEMPTED else exercise.message,
        'tests': [
            _test(exercise, test, test.test in again, exercise.points * test.weight / weight if weight else 0.0)
            for test in exercise.tests
            if test.expected
        ],
        'place': where_to_read.place(exercise.id),
    }


def _summary(exercise: ExerciseResult) -> str:
    if exercise.verdict == results.NOT_ATTEMPTED:
        return exercise.message or 'The cell is still as it was given.'
    if exercise.verdict == verdicts.GRADER_ERROR:
        return (
            'This exercise could not be graded because of a fault on our side. It will be graded again, and your '
            'mark stays open until then.'
        )
    if not exercise.tests:
        return ''
    if exercise.rules:
        return f'{exercise.count_rules(results.KEPT)} of {page.plural(len(exercise.rules), "rule")} kept.'
    passed = sum(test.passed for test in exercise.tests)
    if passed == len(exercise.tests):
        return {1: 'The test passed.', 2: 'Both tests passed.'}.get(passed, f'All {passed} tests passed.')
    return f'{passed} of {page.plural(len(exercise.tests), "test")} passed.'


def _test(exercise: ExerciseResult, test: TestResult, same: bool, points: float) -> dict:
    return {
        'rule': result_display.broken(exercise, test) if test.rule and not test.passed else '',
        'tone': tone(test.verdict),
        'state': _TESTS[test.verdict],
        'expected': result_display.expected(test),
        'kind': f'{"hidden" if test.hidden else "check"} · {page.points(points)} point{"" if points == 1 else "s"}',
        'same': same and not test.passed,
        'happened': [] if test.passed else result_display.happened(test),
        'hint': '' if test.passed else result_display.hint(test),
        'details': '' if same or test.passed else test.details,
        'output': '' if same or test.passed else test.output,
    }


def tone(verdict: str) -> str:
    """good, bad, open (our fault) or none (not begun): the colours of a page."""
    return {verdicts.PASSED: 'good', verdicts.GRADER_ERROR: 'open', results.NOT_ATTEMPTED: 'none'}.get(verdict, 'bad')
