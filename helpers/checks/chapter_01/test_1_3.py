"""Visible tests of exercise 1.3, prove it, and break it."""

import pytest
from std_msgs.msg import String

from helpers.domains import claim
from helpers.runner import expect
from helpers.runner.elsewhere import Elsewhere

pytestmark = pytest.mark.exercise('1.3')


def test_who_hears(learner):
    """A speaker is heard in its own domain, and in no other one.

    Make a context for each domain. Publish again and again, as discovery takes time.
    """
    with claim() as ours, claim() as theirs:
        got = learner.call('who_hears', ours, [theirs, ours], 1.5)
        expect(got == [ours], f'who_hears({ours}, {[theirs, ours]}) gives {got!r}, expected {[ours]}.')


def test_bridge(learner):
    """What is said on chatter arrives in the other domain.

    join(other_domain, 'bridge') makes a node there. Keep it in an attribute.
    """
    with claim() as domain, Elsewhere(domain) as there:
        heard = there.listen('/chatter', String)
        talker = learner.talk('/chatter', String)
        learner.start('Bridge', domain)

        def arrived():
            talker.send(String(data='hello'))
            learner.settle()
            return bool(heard)

        expect(there.wait_until(arrived, timeout=6),
               f'Messages were published on /chatter, and none came in domain {domain}.')
        expect(heard[0].data == 'hello', f'The text "hello" became {heard[0].data!r}.')
