"""Visible tests of exercise 1.3, prove it, and break it."""

import pytest

from helpers.checks.chapter_01 import roll_calls

pytestmark = [pytest.mark.exercise('1.3'), pytest.mark.wiring(type='carries', qos='carries', namespace='carries')]


@pytest.mark.rules('measures', 'sorted', 'in-time', 'leaves')
def test_who_hears(learner):
    """A speaker is heard in its own domain, and through a bridge; the call ends in time, and leaves nothing behind.

    Make a context for each domain. Publish again and again, as discovery takes time.
    """
    roll_calls.check_roll_call(learner)
    roll_calls.check_bridged(learner)
    roll_calls.check_time(learner)
    roll_calls.check_left(learner)
    roll_calls.check_cut(learner)


@pytest.mark.rules('bridge', 'carries', 'one-way')
def test_bridge(learner):
    """What is said on chatter arrives in the other domain, unchanged, and nothing comes back.

    join(other_domain, 'bridge') makes a node there. Subscribe on this side, publish on the other one.
    """
    roll_calls.check_bridge(learner, 3)
