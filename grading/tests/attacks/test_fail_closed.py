"""Scores fail closed: whatever becomes of the tests' process, only explicit passes count, and no fault is a zero.

The score by itself is tested in helpers/tests/runner/test_results.py, errors of real tests in test_session.py there.
"""

import random
from pathlib import Path

import pytest

from grading.tests.attacks import fake_tests
from helpers.runner import session, verdicts
from helpers.tests import small

TESTS = {
    'checks/chapter_90/test_90_1::test_a': 1.0,
    'exercises/90_1/hidden::test_b': 3.0,
    'exercises/90_1/hidden::test_c': 1.0,
}


def collected(test, weight=1.0, exercise='90.1'):
    return {
        'event': 'collected',
        'test': test,
        'exercise': exercise,
        'weight': weight,
        'expected': '',
        'path': f'/{test.replace("::", ".py::")}',
        'rules': [],
        'given': False,
        'unseen': {},
    }


def running(test):
    return {'event': 'running', 'test': test, 'may_take': 0.0}


def result(test, verdict='passed'):
    return {
        'event': 'result',
        'test': test,
        'verdict': verdict,
        'message': '',
        'details': '',
        'output': '',
        'fault': '',
        'rule': '',
        'hint': False,
    }


def judged(tmp_path, *events, exit_status=0):
    """The result of exercise 90.1 if the tests' process says this, and says it again when it is asked again."""
    fake_tests.says(*events, exit_status=exit_status)
    options = session.Options(hidden=tmp_path, visible=tmp_path / 'checks', launcher=fake_tests.LAUNCHER, retries=0)
    found = session.run(small.cells(small.TALKER), [small.exercise()], options).exercises[0]
    return found


@pytest.fixture
def folders(monkeypatch):
    """The hidden tests are in /exercises."""
    return Path('/exercises')


def sound(order=TESTS):
    return (
        [event for test in order for event in (collected(test, TESTS[test]),)]
        + [event for test in order for event in (running(test), result(test))]
        + [{'event': 'end', 'status': 0}]
    )


def test_a_sound_run_is_full_marks(folders):
    """So the cases below do fail for their faults."""
    assert judged(folders, *sound()).score == 10


HIDDEN = 'exercises/90_1/hidden::test_b'
FAULTS = {
    'nothing': [],
    'nothing but the end': [{'event': 'end', 'status': 0}],
    'no result': [event for event in sound() if not (event['event'] == 'result' and event['test'] == HIDDEN)],
    'not begun': [event for event in sound() if not (event['event'] == 'running' and event['test'] == HIDDEN)],
    'cut off': sound()[:-3],
    'hidden tests are missing': sound(list(TESTS)[:1]),
    'collected twice': [collected(HIDDEN, 3.0), *sound()],
    'two results': [*sound()[:-1], running(HIDDEN), result(HIDDEN), {'event': 'end', 'status': 0}],
    'failed, then passed': [
        *(collected(test, weight) for test, weight in TESTS.items()),
        running(HIDDEN),
        result(HIDDEN, 'failed'),
        result(HIDDEN),
        *sound()[3:],
    ],
    'a result of a test that is not there': [
        *sound()[:-1],
        running('x'),
        result('x'),
        collected('x', exercise='90.2'),
        collected(f'{HIDDEN}x'),
    ],
    'a verdict of its own': [*sound()[:-3], running(list(TESTS)[-1]), result(list(TESTS)[-1], 'PASSED')],
    'weight nan': [collected(f'{HIDDEN}2', float('nan')), *sound()],
    'weight infinite': [collected(f'{HIDDEN}2', float('inf')), *sound()],
    'weight negative': [collected(f'{HIDDEN}2', -4.0), running(f'{HIDDEN}2'), result(f'{HIDDEN}2'), *sound()],
    'weight zero': [collected(f'{HIDDEN}2', 0), running(f'{HIDDEN}2'), result(f'{HIDDEN}2'), *sound()],
    'weight a text': [{**collected(f'{HIDDEN}2'), 'weight': '1'}, *sound()],
    'no JSON': [*sound()[:3], 'passed', *sound()[3:]],
    'no object': [*sound()[:3], '[1]', *sound()[3:]],
    'no kind': [*sound()[:3], '{}', *sound()[3:]],
    'deep': [*sound()[:3], '[' * 100_000, *sound()[3:]],
    'fields missing': [*sound()[:3], {'event': 'result'}, *sound()[3:]],
    'broken file': [{'event': 'broken', 'where': 'chapter_90/test_90_1.py', 'text': 'SyntaxError'}, *sound()],
    'grader_error': [*sound()[:-3], running(list(TESTS)[-1]), result(list(TESTS)[-1], verdicts.GRADER_ERROR)],
}


@pytest.mark.parametrize('events', FAULTS.values(), ids=FAULTS)
def test_a_fault_leaves_the_mark_open(folders, events):
    found = judged(folders, *events)
    assert (found.verdict, found.score) == (verdicts.GRADER_ERROR, None)


def test_an_exit_status_does_not_make_a_pass(folders):
    failed = [result(event['test'], 'failed') if event['event'] == 'result' else event for event in sound()]
    assert judged(folders, *failed, exit_status=0).score == 0


@pytest.mark.parametrize('seed', range(40))
def test_never_more_than_the_explicit_passes(folders, seed):
    """Any mixture of events, in any order."""
    draw = random.Random(seed)
    names = [*TESTS, 'exercises/90_1/hidden::extra']
    pool = [make(name) for name in names for make in (collected, running)]
    pool += [result(draw.choice(names), draw.choice([*verdicts.VERDICTS, 'ok', ''])) for _ in range(6)]
    events = draw.sample(pool, draw.randint(4, len(pool)))
    if draw.random() < 0.6:  # more often a run that is nearly sound
        events = [event for event in sound() if draw.random() < 0.9] + events[:2]
    end = {'event': 'end', 'status': 0}
    events = events[: events.index(end)] if end in events else events  # nothing is read behind it
    passes = {event['test'] for event in events if event.get('verdict') == 'passed'}
    weights = {event['test']: event['weight'] for event in reversed(events) if event['event'] == 'collected'}
    found = judged(folders, *events)
    if found.score is not None:
        explicit = sum(weights[test] for test in passes & weights.keys()) / sum(weights.values())
        assert found.score <= round(10 * explicit, 2)
