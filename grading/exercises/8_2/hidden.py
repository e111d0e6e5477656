"""Hidden tests of exercise 8.2, a governor."""

import pytest

from helpers.checks.chapter_08.governors import (
    RATES,
    Governed,
    command,
    judge_bad_start,
    judge_changes,
    judge_limit,
    judge_modes,
    judge_rhythm,
    judge_rules,
    judge_table,
)
from helpers.checks.chapter_08.node_options import check_options
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('8.2'), pytest.mark.wiring(type='names', qos='names', namespace='names')]


@pytest.mark.rules('limit', 'other-fields', 'rhythm')
@pytest.mark.weight(2)
def test_limit(learner):
    """linear.x is limited in both directions; smaller speeds and angular.z pass; the other fields are 0.

    max(-limit, min(limit, speed)), and a new Twist with two fields.
    """
    limit = learner.random.randint(60, 190) / 100
    with about('limit'):
        governed = Governed(learner, '/here', max_linear=limit)
    judge_limit(governed, limit, 0.1)


@pytest.mark.rules('rhythm', 'newest', 'before', 'limit')
@pytest.mark.weight(2)
def test_rhythm(learner):
    """The timer decides when a message goes out; of several commands the newest one counts.

    Note the command in the callback of the subscription, and publish in the timer.
    """
    rate = learner.random.choice(RATES)
    with about('rhythm'):
        governed = Governed(learner, '/here', rate=rate)
    judge_rhythm(governed, rate)


@pytest.mark.rules('at-once', 'newest', 'new-rate', 'refused', 'limit', 'pair', 'modes', 'before', 'rhythm')
@pytest.mark.weight(3)
def test_changes(learner):
    """Changes act from the next message on; a refused request changes nothing, neither parameters nor what it does.

    Read the parameters in the timer. While checking, change nothing. Make a new timer when the rate has been set.
    """
    limit, rate = learner.random.randint(60, 160) / 100, learner.random.choice([6.4, 16.0])
    with about('at-once'):
        governed = Governed(learner, '/there', max_linear=limit, rate=rate)
    judge_changes(governed, limit, rate)


@pytest.mark.rules('defaults', 'description', 'bounds')
@pytest.mark.weight(2)
def test_descriptors(learner):
    """Each parameter has its type, its default, its bounds and a description.

    declare_parameter(name, default, ParameterDescriptor(description=…, floating_point_range=[…])).
    """
    with about('defaults'):
        governed = Governed(learner, '/here')
    judge_table(governed)
    for name, value in (('rate', 20), ('mode', 1), ('max_linear', '0.3')):
        expect(
            not governed.parameters.set(**{name: value}).successful,
            f'{name} = {value!r} was accepted: another type than that of the default.',
            'defaults',
        )


@pytest.mark.rules('unknown-mode', 'pair', 'reason')
@pytest.mark.weight(2)
def test_rule(learner):
    """No request makes slow_linear larger than max_linear, and every other one is accepted.

    Judge the values as they would be after the request: those of the request, and the present ones for the rest.
    """
    with about('pair'):
        governed = Governed(learner, '/here')
    judge_rules(governed)


@pytest.mark.rules('modes', 'at-start')
@pytest.mark.weight(2)
def test_values_at_the_start(learner):
    """Values from the command line or a file are checked, too: with a bad one the node does not start.

    Add the callback that checks before you declare the parameters.
    """
    judge_bad_start(
        learner,
        {'max_linear': learner.random.randint(5, 19) / 100},
        {'mode': 'none'},
        {'slow_linear': 1.1, 'max_linear': 1.0},
    )
    judge_modes(learner, '/there')


@pytest.mark.rules('names')
def test_two_robots(learner):
    """Two governors in two namespaces do not disturb each other.

    Relative names, and state in the object.
    """
    first, second = (Governed(learner, f'/robot{number}') for number in (1, 2))
    first.send(command(0.3))
    second.send(command(0.4))
    for one, stranger in ((first, 0.4), (second, 0.3)):
        got = [message.linear.x for message in one.after(0.2)]
        expect(
            stranger not in got,
            f'Two governors got 0.3 and 0.4 m/s, each in its namespace, and on {one.heard.topic} came {got}: the '
            'command belongs to the object, not to the class.',
        )
    check_options(learner, 'Governor', 'names')
