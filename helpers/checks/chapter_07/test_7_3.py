"""Visible tests of exercise 7.3, who does not hear whom."""

import pytest

from helpers.checks.chapter_07 import graphs
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('7.3')


@pytest.mark.rules('read', 'node-name', 'usual')
def test_read(learner):
    """read_topics sees publishers and subscriptions that run, with their six strings.

    get_publishers_info_by_topic and get_subscriptions_info_by_topic tell the QoS, too.
    """
    random = learner.random
    room, topic = random.choice(graphs.ROOMS), random.choice(graphs.TOPICS)
    common = {'type': random.choice(graphs.MESSAGES), 'reliability': 'RELIABLE', 'durability': 'TRANSIENT_LOCAL'}
    there = [
        {'role': 'publisher', 'node': '/mouth', 'name': f'/{topic}', **common},
        {'role': 'subscription', 'node': f'/{room}/ear', 'name': f'/{room}/{topic}', **common, **graphs.WEAK},
    ]
    other = next(kind for kind in graphs.MESSAGES if kind != common['type'])  # on one topic with the ear
    # In a namespace of a namespace, and with a policy of each kind.
    there.append({**there[1], 'node': f'/house/{room}/other_ear', 'type': other, 'durability': 'TRANSIENT_LOCAL'})
    there += graphs.publishers_beside(there[1], f'/{room}')
    there += graphs.like_usual_ones(f'/{room}/watch', common['type'])
    secret = {'role': 'subscription', 'node': '/_secret', 'name': f'/{topic}', **common}
    graphs.read(learner, there, secret)


@pytest.mark.rules('name', 'nobody', 'type', 'reliability', 'durability', 'fits', 'fault', 'all')
def test_diagnose(learner):
    """Each cause is found where it is alone, and whoever gets something is no finding.

    nearest(name, names) finds a name that was meant among the names of the same type.
    """
    for cause in graphs.CAUSES:
        for _ in range(3):
            with about(cause):
                graphs.diagnose(learner, cause)
    graphs.other_type(learner)
    graphs.two_deaf(learner)
    graphs.same_name(learner)
    graphs.neighbours(learner)
    for _ in range(4):
        with about('fits'):
            graphs.diagnose(learner, 'healthy', 'healthy', 'healthy', rule='fits')
    with about('durability'):
        graphs.diagnose(learner, 'both', rule='durability')
    faults = ('service name', 'service nobody', 'service type')
    for fault in (*faults, 'description name', 'description nobody', 'description durability'):
        with about('fault'):
            graphs.diagnose(learner, fault, rule='fault')
    graphs.other_description(learner)
    graphs.topic_and_service(learner)
    with about('all'):
        graphs.diagnose(learner, *graphs.CAUSES, 'service name', rule='all')


@pytest.mark.rules('remapping', 'override', 'no-repair')
def test_repair(learner):
    """A node that is started again with your arguments hears what is published.

    A remapping rule is -r FROM:=TO, a parameter -p NAME:=VALUE.
    """
    for fault, rule in (('name', 'remapping'), ('reliability', 'override'), ('durability', 'override')):
        with about(rule):
            graphs.started_again(learner, fault, 3.0, rule)
    with about('remapping'):
        graphs.started_again(learner, 'name', 3.0, 'remapping', apart=True)
    graphs.started_again(learner, 'description durability', 3.0, 'override')
    graphs.asks_again(learner, 3.0)
    for fault in ('type', 'nobody', 'service type', 'service nobody'):
        finding = graphs.draw(learner.random, fault)[1][0]
        with about('no-repair'):
            arguments = learner.call('repair_finding_of_graph', list(finding))
        expect(arguments == [], f'For {finding} repair_graph gave {arguments}, expected [].', 'no-repair')
