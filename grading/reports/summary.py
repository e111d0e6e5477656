"""`summary.html` and `summary.json`: the class at a glance, for the instructor.

How each exercise went, which misconceptions are common, what took long, what came late, where the grader was at fault,
and which answers are alike. The page has the looks of the feedback page and, like it, loads and runs nothing.
"""

import json
import re
from collections import Counter, defaultdict
from collections.abc import Iterable
from statistics import mean, median, quantiles

from grading import similarity
from grading.record import Record
from grading.reports import feedback, page
from grading.reports.safe import line
from grading.similarity import Pair
from helpers.exercises import result_display
from helpers.exercises.manifest import Exercise
from helpers.runner import results, verdicts

SCHEMA = 1
BINS = 10  # of the histograms: tenths of the points
MOST = 25  # misconceptions, slow learners and alike pairs on the page; the JSON has all
VERDICTS = (
    verdicts.PASSED,
    verdicts.FAILED,
    verdicts.TIMEOUT,
    verdicts.LEARNER_CRASHED,
    verdicts.INVALID_SUBMISSION,
    verdicts.GRADER_ERROR,
    results.NOT_ATTEMPTED,
)
_NUMBER = re.compile(r'[-+]?\d+(\.\d+)?(e[-+]?\d+)?')  # also in names: tests draw some, such as /robot32
_QUOTED = re.compile(r"'[^']*'|\"[^\"]*\"")
_LIST = re.compile(r'\[[^\[\]]*\]')


def data(records: Iterable[Record], exercises: Iterable[Exercise], alike: Iterable[Pair] = ()) -> dict:
    """All that the summary tells, as JSON values (`grading/schemas/summary.schema.json`)."""
    records = sorted(records, key=lambda record: record.learner)
    return {
        'schema': SCHEMA,
        'learners': len(records),
        'status': dict(sorted(Counter(record.status for record in records).items())),
        'sandboxes': dict(sorted(Counter(record.sandbox for record in records).items())),
        'points': sum(exercise.points for exercise in exercises),
        'total': _spread([(record.score, record.points) for record in records]),
        'exercises': [_exercise(exercise, records) for exercise in exercises],
        'misconceptions': _misconceptions(records),
        'slowest': _slowest(records),
        'late': [
            {'learner': record.learner, 'days': record.late.days, 'percent': record.late.percent}
            for record in records
            if record.late is not None and record.late.days
        ],
        'adjusted': sum(bool(record.adjustments) for record in records),
        'notes': [{'learner': record.learner, 'text': note} for record in records for note in record.notes],
        'faults': _faults(records),
        'alike': similarity.as_rows(alike),
    }


def dumps(summary: dict) -> str:
    """The summary as JSON text."""
    return json.dumps(summary, indent=1, ensure_ascii=False) + '\n'


def html(summary: dict) -> str:
    """The summary as a page."""
    return page.render('summary.html.j2', s=summary, most=MOST, states=feedback.STATES, verdicts=VERDICTS, line=line)


def _spread(scores: list[tuple[float | None, float]]) -> dict:
    """Mean, quartiles and histogram of scores; unknown ones are left out and counted."""
    known = [score for score, _ in scores if score is not None]
    shares = [score / points for score, points in scores if score is not None and points > 0]
    bins = Counter(min(BINS - 1, max(0, int(share * BINS))) for share in shares)
    quarters = quantiles(known, n=4, method='inclusive') if len(known) > 1 else [*known, *known, *known]
    return {
        'known': len(known),
        'unknown': len(scores) - len(known),
        'mean': round(mean(known), 2) if known else None,
        'median': round(median(known), 2) if known else None,
        'lower': round(quarters[0], 2) if known else None,
        'upper': round(quarters[2], 2) if known else None,
        'histogram': [bins[number] for number in range(BINS)],
    }


def _exercise(exercise: Exercise, records: list[Record]) -> dict:
    mine = [result for record in records for result in record.exercises if result.id == exercise.id]
    tests: dict[str, dict] = {}
    for test in (test for result in mine for test in result.tests if test.expected):
        row = tests.setdefault(
            test.test,
            {
                'test': test.test,
                'hidden': test.hidden,
                'expected': result_display.expected(test),
                'ran': 0,
                'passed': 0,
            },
        )
        row['ran'] += 1
        row['passed'] += test.passed
    seconds = [sum(test.seconds for test in result.tests) for result in mine if result.tests]
    return {
        'id': exercise.id,
        'title': exercise.title,
        'points': exercise.points,
        'verdicts': {verdict: sum(result.verdict == verdict for result in mine) for verdict in VERDICTS},
        **_spread([(result.score, result.points) for result in mine]),
        'seconds': {'median': round(median(seconds), 2), 'most': round(max(seconds), 2)} if seconds else None,
        'tests': sorted(tests.values(), key=lambda row: (row['passed'] / row['ran'], row['test'])),
    }


def pattern(message: str) -> str:
    """A message without what differs from learner to learner: its first line, with N for numbers and … for texts."""
    text = message.partition('\n')[0]
    return _NUMBER.sub('N', _QUOTED.sub('…', _LIST.sub('[…]', text)))


def _misconceptions(records: list[Record]) -> list[dict]:
    """The messages of failed tests, those of one pattern together, the most common first."""
    who: dict[tuple[str, str], set[str]] = defaultdict(set)
    said: dict[tuple[str, str], Counter[str]] = defaultdict(Counter)
    tests: dict[tuple[str, str], Counter[str]] = defaultdict(Counter)
    for record in records:
        for result in record.exercises:
            for test in result.tests:
                if test.passed or test.verdict == verdicts.GRADER_ERROR:
                    continue
                text = test.message.partition('\n')[0] or result_display.expected(test)
                key = (result.id, pattern(text))
                who[key].add(record.learner)
                said[key][text] += 1
                tests[key][result_display.expected(test)] += 1
    rows = [
        {'exercise': key[0], 'message': _first(said[key]), 'expected': _first(tests[key]), 'learners': sorted(learners)}
        for key, learners in who.items()
    ]
    return sorted(rows, key=lambda row: (-len(row['learners']), row['exercise'], row['message']))


def _first(counted: Counter[str]) -> str:
    """The most common one; of several, the first in the alphabet, so that the same records give the same text."""
    return min(counted, key=lambda text: (-counted[text], text))


def _slowest(records: list[Record]) -> list[dict]:
    rows: list[dict] = [
        {
            'learner': record.learner,
            'exercise': result.id,
            'seconds': round(sum(test.seconds for test in result.tests), 2),
        }
        for record in records
        for result in record.exercises
        if result.tests
    ]
    return sorted(rows, key=lambda row: (-row['seconds'], row['learner'], row['exercise']))[:MOST]


def _faults(records: list[Record]) -> list[dict]:
    """The grader's own faults. A fault's text is for the instructor, who alone sees the summary."""
    return [
        {
            'learner': record.learner,
            'exercise': result.id,
            'text': next((_last(test.fault) for test in result.tests if test.fault), 'see run.log'),
        }
        for record in records
        for result in record.exercises
        if result.verdict == verdicts.GRADER_ERROR
    ]


def _last(text: str) -> str:
    lines = [text for text in text.splitlines() if text.strip()]
    return lines[-1].strip()[:300] if lines else 'see run.log'
