"""Hidden tests of exercise 1.3, prove it, and break it."""

from contextlib import ExitStack, contextmanager

import pytest
from std_msgs.msg import String

from helpers.domains import claim
from helpers.runner import expect
from helpers.runner.elsewhere import Elsewhere

pytestmark = pytest.mark.exercise('1.3')


@contextmanager
def domains(count):
    """So many domains that nobody else uses."""
    with ExitStack() as held:
        yield [held.enter_context(claim()) for _ in range(count)]


@pytest.mark.weight(2)
def test_it_speaks_in_the_domain(learner):
    """The speaker really speaks on roll_call, in its own domain, and only its own domain hears it.

    A node belongs to the domain of its context.
    """
    with domains(3) as (ours, *others), Elsewhere(ours) as here:
        heard = here.listen('/roll_call', String)
        asked = learner.random.sample([ours, *others], 3)
        got = learner.call('who_hears', ours, asked, 1.5)
        here.wait_until(lambda: heard, timeout=1)
        expect(here.met('/roll_call'), f'No speaker for /roll_call came into domain {ours}. Each context has its own '
                                       'domain: rclpy.init(context=…, domain_id=…).')
        expect(heard and got, f'A speaker was in domain {ours}, and who_hears({ours}, {asked}) gives {got!r}. '
                              'Discovery takes time: what is published before it is lost. Publish again and again.')
        expect(got == [ours], f'who_hears({ours}, {asked}) gives {got!r}, expected {[ours]}.')


@pytest.mark.weight(2)
def test_it_measures(learner):
    """Two domains that are bridged are found to be connected.

    Do not compare numbers: listen.
    """
    with domains(3) as (ours, second, third), Elsewhere(second) as there, Elsewhere(ours) as here:
        here.relay('/roll_call', String, to=there)
        asked = learner.random.sample([ours, second, third], 3)
        got = learner.call('who_hears', ours, asked, 2.0)
        expect(got != [ours], f'The tests have a bridge for roll_call from domain {ours} to {second}. Your function '
                              f'says that only {ours} hears: does it compare numbers, and not listen?')
        wanted = sorted([ours, second])
        expect(sorted(got) == wanted, f'With a bridge from {ours} to {second}, who_hears({ours}, {asked}) gives '
                                      f'{got!r}, expected {wanted}.')
        expect(got == wanted, f'The domains must be sorted; you return {got!r}.')


def test_nothing_stays_behind(learner):
    """After the call, no node and no context of it is left in the domains.

    Destroy each node and end its context, in the listeners' domains, too.
    """
    for _ in range(3):  # a goodbye may get lost on a busy machine; three in a row do not
        with domains(2) as (ours, other), Elsewhere(ours) as here:
            heard = here.listen('/roll_call', String)
            got = learner.call('who_hears', ours, [ours, other], 1.0)
            expect(here.wait_until(lambda: heard, timeout=2) and got == [ours],  # noqa: B023 - used at once
                   f'who_hears({ours}, {[ours, other]}) gives {got!r}, expected {[ours]}.')
            if here.wait_until(lambda: not here.nodes(), timeout=1):  # noqa: B023
                return
            left = here.nodes()
    expect(False, f'After the call these nodes are left in its domain: {", ".join(left)}. Destroy them, and shut their '
                  'contexts down.')


@pytest.mark.weight(3)
def test_bridge(learner):
    """The bridge carries every text, in order, once, to the other domain, and nothing back.

    Subscribe on this side, publish on the other one.
    """
    random = learner.random
    home = learner.context.get_domain_id()
    with domains(1) as (domain,), Elsewhere(domain) as there, Elsewhere(home) as here:
        heard = there.listen('/chatter', String)
        spoken = there.node.create_publisher(String, '/chatter', 100)
        at_home = here.listen('/chatter', String)
        talker = learner.talk('/chatter', String)
        node = learner.start('Bridge', domain)
        expect(node.name == '/bridge', f'The node is called {node.name}, expected /bridge.')

        def arrived():
            talker.send(String(data='first'))
            learner.settle()
            return bool(heard)

        expect(there.wait_until(arrived, timeout=6),
               f'Messages were published on /chatter in the domain of the program, and none came in domain {domain}.')
        texts = [f'{random.choice(["north", "south"])} {random.randint(0, 999)}' for _ in range(8)]
        talker.send(*[String(data=text) for text in texts])
        learner.settle()
        there.wait_until(lambda: heard[-1].data == texts[-1], timeout=3)
        got = [message.data for message in heard if message.data != 'first']
        expect(got == texts, f'{texts} was said here; in the other domain came {got}.')
        spoken.publish(String(data='echo?'))
        for _ in range(5):
            learner.settle()
            here.wait_until(lambda: any(message.data == 'echo?' for message in at_home), timeout=0.1)
        expect(not any(message.data == 'echo?' for message in at_home),
               'What is said in the other domain comes back. The bridge must carry in one direction only: two '
               'directions make an endless echo.')


def test_bridge_is_there(learner):
    """In the other domain the bridge is a node that only publishes chatter.

    join(other_domain, 'bridge') makes it.
    """
    with domains(1) as (domain,), Elsewhere(domain) as there:
        learner.start('Bridge', domain)
        expect(there.wait_until(lambda: there.nodes(), 5), f'No node of yours is in domain {domain}.')
        there.wait_until(lambda: there.node.count_publishers('/chatter') or there.node.count_subscribers('/chatter'), 5)
        expect(not there.node.count_subscribers('/chatter'),
               f'Your bridge listens on /chatter in domain {domain}: the wrong direction.')
        expect(there.node.count_publishers('/chatter'), f'Your node in domain {domain} does not publish on /chatter.')
        expect(learner.endpoints('/chatter').subscriptions,
               'Your bridge does not listen on /chatter in the domain of the program.')
