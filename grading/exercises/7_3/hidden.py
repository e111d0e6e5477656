"""Hidden tests of exercise 7.3, who does not hear whom. Every graph is drawn."""

import pytest

from helpers.checks.chapter_07 import graphs
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('7.3')


def check(learner, *faults, rule='', times=4):
    for _ in range(times):
        with about(rule or faults[0]):
            graphs.diagnose(learner, *faults, rule=rule)


@pytest.mark.rules('read', 'node-name', 'usual')
@pytest.mark.weight(2)
def test_read_topics(learner):
    """read_topics sees every publisher and subscription with node, name, type and QoS, in a namespace, too.

    The node's name is its namespace and its name, with one `/` between. What `usual` is true for is left out.
    """
    endpoints = [
        end
        for end in graphs.draw(learner.random, 'both', 'healthy', 'durability')[0]
        if end['role'] in ('publisher', 'subscription')
    ]
    strange = next(kind for kind in graphs.MESSAGES if kind != endpoints[0]['type'])  # two types on one topic
    endpoints.append({**endpoints[0], 'node': '/house/hall/stranger', 'role': 'subscription', 'type': strange})
    endpoints += graphs.publishers_beside(next(end for end in endpoints if end['role'] == 'subscription'), '/house')
    endpoints += graphs.like_usual_ones('/house/watch', strange)
    secret = {**endpoints[0], 'node': '/_secret', 'role': 'subscription'}
    graphs.read(learner, endpoints, secret)


@pytest.mark.rules('fits')
def test_healthy_graph(learner):
    """What fits gives no finding: an offer that is better than what is asked for, and whoever is alone as a sender.

    Compare what is asked for with what is offered, not for being equal.
    """
    check(learner, 'healthy', 'healthy', 'healthy', rule='fits')
    endpoints, _ = graphs.draw(learner.random, 'type', 'reliability', 'nobody')
    expect(
        learner.call('diagnose_graph', endpoints) != [],
        'A graph with two types under one name, an offer that is too weak, and a topic without a sender gives no '
        'finding, either.',
        'fits',
    )


@pytest.mark.rules('name', 'nobody', 'type', 'fits')
def test_names(learner):
    """A misspelt name and a name in another namespace are found; a name that nobody has is `nobody`.

    Only names of the same type can be meant.
    """
    check(learner, 'name')
    check(learner, 'nobody')
    graphs.other_type(learner)
    graphs.two_deaf(learner)
    graphs.neighbours(learner)


@pytest.mark.rules('type')
def test_types(learner):
    """Two types under one name are found.

    The evidence is the type of the publisher or server.
    """
    check(learner, 'type')


@pytest.mark.rules('reliability', 'durability')
@pytest.mark.weight(2)
def test_policies(learner):
    """Each policy that does not fit is a finding; if both do not fit, there are two.

    Who asks for less than is offered gets it.
    """
    check(learner, 'reliability')
    check(learner, 'durability')
    check(learner, 'both', rule='durability')


@pytest.mark.rules('fault', 'nobody')
def test_description(learner):
    """The topic /robot_description has a fault of its own, `no_model`, and services have theirs.

    By the name that the subscription uses.
    """
    descriptions = ('description name', 'description nobody', 'description durability')
    for fault in (*descriptions, 'service name', 'service nobody', 'service type'):
        check(learner, fault, rule='fault', times=2)
    graphs.other_description(learner)
    graphs.topic_and_service(learner)


@pytest.mark.rules('all')
def test_several(learner):
    """Several faults in one graph are several findings.

    Look at every subscription and every client.
    """
    check(learner, *learner.random.sample(graphs.CAUSES, 3), 'service name', rule='all')
    graphs.same_name(learner)


@pytest.mark.rules('remapping', 'override')
@pytest.mark.weight(2)
@pytest.mark.parametrize('fault', ['name', 'reliability', 'durability', 'description durability'])
def test_it_hears(learner, fault):
    """A node that is started again with your arguments hears what is published.

    A remapping rule is -r FROM:=TO, a parameter -p NAME:=VALUE.
    """
    rule = 'remapping' if fault == 'name' else 'override'
    with about(rule):
        graphs.started_again(learner, fault, 10.0, rule)
        if fault == 'name':
            graphs.started_again(learner, fault, 10.0, rule, apart=True)
            graphs.asks_again(learner, 10.0)


@pytest.mark.rules('no-repair')
def test_no_repair(learner):
    """A wrong type, or nobody there, cannot be repaired by arguments: the repair is an empty list.

    Somebody must change a program, or start one.
    """
    for fault in ('type', 'nobody', 'service type', 'service nobody'):
        finding = graphs.draw(learner.random, fault)[1][0]
        with about('no-repair'):
            arguments = learner.call('repair_finding_of_graph', list(finding))
        expect(arguments == [], f'For {finding} repair_graph gave {arguments}, expected [].', 'no-repair')
    findings = [graphs.draw(learner.random, fault)[1][0] for fault in ('name', 'durability')]
    with about('no-repair'):
        repaired = [learner.call('repair_finding_of_graph', list(finding)) for finding in findings]
    expect(
        any(repaired), f'repair_graph gives {repaired} for {findings}, too, which arguments can repair.', 'no-repair'
    )
