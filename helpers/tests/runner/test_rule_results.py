"""Rules of a card: what a session says of each, from the marks and expectations of the tests."""

import dataclasses

import pytest

from helpers.exercises.manifest import Rule
from helpers.runner import results, session
from helpers.tests import small

RULES = tuple(Rule(name, f'The {name} is right.') for name in ('texts', 'rate', 'depth', 'topic', 'latency'))
TESTS = '''
pytestmark = [pytestmark, pytest.mark.not_looked_at(rule='latency', why='this machine is too slow'),
              pytest.mark.wiring(type='topic', qos='topic')]


@pytest.mark.rules('texts', 'rate')
def test_run(learner):
    """The talker counts.

    Look at the counter.
    """
    heard = learner.listen('/chatter', String)
    learner.start('Talker')
    learner.run(2.0)
    expect(heard.data == ['0', '1', '2', '3'][:len(heard)], f'The texts are {heard.data}.', 'texts', hint=True)
    expect(len(heard) == 4, f'{len(heard)} messages came in 2 s.', 'rate')


@pytest.mark.rules('depth')
def test_depth(learner):
    """The depth is 10."""
    learner.start('Talker')
    expect(learner.endpoints('/chatter').publishers, 'There is no publisher.')
'''


def judge(folder, source, test=TESTS):
    exercise = dataclasses.replace(small.exercise(), rules=RULES)
    options = session.Options(visible=small.write_tests(folder, test))
    report = session.run(small.cells(source), [exercise], options)
    assert not report.log
    return report.exercises[0]


def states(result):
    return {rule.name: rule.state for rule in result.rules}


def test_all_kept(tmp_path):
    result = judge(tmp_path, small.TALKER)
    assert result.passed
    assert states(result) == {
        'texts': 'kept',
        'rate': 'kept',
        'depth': 'kept',
        'topic': 'not_looked_at',
        'latency': 'not_looked_at',
    }
    assert [rule.why for rule in result.rules[3:]] == ['no test has run', 'this machine is too slow']


@pytest.mark.parametrize(
    ('old', 'new', 'wanted', 'why', 'hint'),
    [
        ('str(self.count)', "'x'", {'texts': 'broken', 'rate': 'not_looked_at'}, 'what breaks “texts” hides it', True),
        ('0.5', '1.0', {'texts': 'not_looked_at', 'rate': 'broken'}, 'nothing wrong so far', False),
        ("String, 'chatter'", "Bool, 'chatter'", {'topic': 'broken', 'texts': 'not_looked_at'}, '', False),
        (
            "self.create_publisher(String, 'chatter', 10)",
            'None',
            {'texts': 'not_looked_at', 'depth': 'broken'},
            'the program did not come so far',
            False,
        ),
    ],
)
def test_what_breaks_a_rule(tmp_path, old, new, wanted, why, hint):
    """An expectation names its rule; a test of one rule needs no name; wiring and crashes have their own ways."""
    result = judge(tmp_path, small.TALKER.replace(old, new))
    assert wanted.items() <= states(result).items(), states(result)
    assert why in [rule.why for rule in result.rules] or not why
    assert any(test.hint for test in result.tests) is hint


def test_a_result_can_be_read_again(tmp_path):
    result = judge(tmp_path, small.TALKER)
    assert results.ExerciseResult.from_dict(result.as_dict()) == result
