"""Visible tests of exercise 8.2, a governor."""

import pytest

from helpers.checks.chapter_08 import governors
from helpers.checks.chapter_08.node_options import check_options
from helpers.runner import about

pytestmark = [pytest.mark.exercise('8.2'), pytest.mark.wiring(type='names', qos='names', namespace='names')]


@pytest.mark.rules('defaults', 'description', 'bounds', 'unknown-mode', 'pair', 'reason')
def test_parameters(learner):
    """The parameters have their defaults, descriptions and bounds; what does not fit is refused with a reason.

    Bounds stand in the descriptor; the mode and the pair need a callback that checks.
    """
    with about('defaults'):
        governed = governors.Governed(learner, f'/robot{learner.random.randint(2, 99)}')
    governors.judge_table(governed)
    governors.judge_rules(governed)


@pytest.mark.rules('names', 'rhythm', 'newest', 'before', 'limit', 'other-fields')
def test_commands(learner):
    """The newest command comes out, limited, rate times a second.

    A timer with the period 1 / rate publishes the newest command.
    """
    limit, rate = learner.random.randint(192, 200) / 100, learner.random.choice(governors.RATES)
    with about('names'):
        governed = governors.Governed(learner, f'/robot{learner.random.randint(2, 99)}', max_linear=limit, rate=rate)
    governors.judge_rhythm(governed, rate)
    governors.judge_limit(governed, limit, 1 / rate)
    with about('names'):
        check_options(learner, 'Governor', 'names')


@pytest.mark.rules('at-once', 'newest', 'new-rate', 'refused', 'limit', 'pair', 'modes', 'before', 'rhythm')
def test_changes(learner):
    """A change acts from the next message on, and a refused one not at all.

    Read the parameters in the timer; make a new timer when the rate has been set.
    """
    with about('at-once'):
        governed = governors.Governed(learner, f'/robot{learner.random.randint(2, 99)}')
    governors.judge_changes(governed, 0.5, 10.0)


@pytest.mark.rules('modes', 'at-start')
def test_start(learner):
    """The node starts in the modes slow and stop with the values that it is given; with bad ones it does not start.

    Add the callback that checks before you declare the parameters.
    """
    high = learner.random.randint(55, 190) / 100
    governors.judge_bad_start(learner, {'mode': learner.random.choice(['fast', 'SLOW'])}, {'slow_linear': high})
    governors.judge_modes(learner, f'/robot{learner.random.randint(2, 99)}')
