"""Hidden tests of exercise 1.3, prove it, and break it."""

import pytest
from std_msgs.msg import String

from helpers.checks.chapter_01 import roll_calls
from helpers.runner import about, expect
from helpers.runner.elsewhere import Elsewhere

pytestmark = [pytest.mark.exercise('1.3'), pytest.mark.wiring(type='carries', qos='carries', namespace='carries')]


@pytest.mark.weight(2)
@pytest.mark.rules('measures')
def test_it_speaks_in_the_domain(learner):
    """The speaker really speaks on roll_call, in its own domain, and only its own domain hears it.

    A node belongs to the domain of its context.
    """
    roll_calls.check_roll_call(learner)


@pytest.mark.weight(2)
@pytest.mark.rules('measures', 'sorted')
def test_it_measures(learner):
    """Two domains that are bridged are found to be connected.

    Do not compare numbers: listen.
    """
    roll_calls.check_bridged(learner)
    roll_calls.check_cut(learner)


@pytest.mark.rules('in-time')
def test_it_ends_in_time(learner):
    """The call ends as soon as all have heard, or after the time that is given.

    A loop with two conditions.
    """
    roll_calls.check_time(learner)


@pytest.mark.rules('leaves')
def test_nothing_stays_behind(learner):
    """After the call, no node and no context of it is left in the domains.

    Destroy each node and end its context, in the listeners' domains, too.
    """
    roll_calls.check_left(learner)


@pytest.mark.weight(3)
@pytest.mark.rules('bridge', 'carries', 'one-way')
def test_bridge(learner):
    """The bridge carries every text, in order, once, to the other domain, and nothing back.

    Subscribe on this side, publish on the other one.
    """
    roll_calls.check_bridge(learner, 6)


@pytest.mark.rules('one-way', 'bridge', 'carries')
def test_bridge_is_there(learner):
    """In the other domain the bridge is a node that only publishes chatter.

    join(other_domain, 'bridge') makes it.
    """
    with roll_calls.domains(1) as (domain,), Elsewhere(domain) as there:
        with about('bridge'):
            learner.start('Bridge', domain)
        expect(there.wait_until(there.nodes, 5), f'No node of yours is in domain {domain}.', 'bridge')
        there.wait_until(lambda: there.node.count_publishers('/chatter') or there.node.count_subscribers('/chatter'), 5)
        expect(
            there.node.count_publishers('/chatter'),
            f'Your node in domain {domain} does not publish on /chatter.',
            'carries',
        )
        expect(
            not there.node.count_subscribers('/chatter'),
            f'Your bridge listens on /chatter in domain {domain}: the wrong direction.',
            'one-way',
        )
        learner.talk('/chatter', String)
        expect(
            learner.endpoints('/chatter').subscriptions,
            'Your bridge does not listen on /chatter in the domain of the program.',
            'carries',
        )
