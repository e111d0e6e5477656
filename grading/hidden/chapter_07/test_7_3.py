"""Hidden tests of exercise 7.3, who does not hear whom. Every graph is drawn."""

import pytest

from helpers.checks.chapter_07 import graphs
from helpers.checks.chapter_07.findings import compare
from helpers.runner import expect

pytestmark = pytest.mark.exercise('7.3')


def check(learner, *faults, times=4):
    for _ in range(times):
        endpoints, expected = graphs.draw(learner.random, *faults)
        compare(learner.call('diagnose_graph', endpoints), expected, graphs.WHY)


@pytest.mark.weight(2)
def test_read_topics(learner):
    """read_topics sees every publisher and subscription with node, name, type and QoS, in a namespace, too.

    The node's name is its namespace and its name, with one `/` between. What `usual` is true for is left out.
    """
    endpoints = [end for end in graphs.draw(learner.random, 'both', 'healthy', 'durability')[0]
                 if end['role'] in ('publisher', 'subscription')]
    secret = {**endpoints[0], 'node': '/_hidden', 'role': 'subscription'}
    with graphs.System(learner.context.get_domain_id()) as system:
        for endpoint in [secret, *endpoints]:
            system.add(endpoint)
        seen = learner.call('endpoints_here', len(endpoints), 5.0)
    expect(isinstance(seen, list) and all(isinstance(end, dict) for end in seen), f'You return {seen!r}.')
    for endpoint in endpoints:
        twin = [end for end in seen if (end.get('role'), end.get('name')) == (endpoint['role'], endpoint['name'])]
        expect(endpoint in seen, f'There is {endpoint}; ' + (f'you have {twin[0]}.' if twin else 'you have it not.'))
    for end in seen:
        expect(end in endpoints, f'You have {end}, which is not there, or is left out by `usual`.')


def test_healthy_graph(learner):
    """What fits gives no finding: an offer that is better than what is asked for, and whoever is alone as a sender.

    Compare what is asked for with what is offered, not for being equal.
    """
    check(learner, 'healthy', 'healthy', 'healthy')


def test_names(learner):
    """A misspelt name and a name in another namespace are found; a name that nobody has is `nobody`.

    Only names of the same type can be meant.
    """
    for fault in ('name', 'nobody', 'service name', 'service nobody'):
        check(learner, fault)


def test_types(learner):
    """Two types under one name are found, for topics and services.

    The evidence is the type of the publisher or server.
    """
    check(learner, 'type')
    check(learner, 'service type')


@pytest.mark.weight(2)
def test_policies(learner):
    """Each policy that does not fit is a finding; if both do not fit, there are two.

    Who asks for less than is offered gets it.
    """
    for fault in ('reliability', 'durability', 'both'):
        check(learner, fault)


def test_description(learner):
    """The topic /robot_description has its own row, A7.10.

    By the name that the subscription uses.
    """
    check(learner, 'description nobody')
    check(learner, 'description durability')


def test_several(learner):
    """Several faults in one graph are several findings.

    Look at every subscription and every client.
    """
    check(learner, *learner.random.sample(graphs.CAUSES, 3), 'service name')


@pytest.mark.weight(2)
@pytest.mark.parametrize('fault', ['name', 'reliability', 'durability'])
def test_it_hears(learner, fault):
    """A node that is started again with your arguments hears what is published.

    A remapping rule is -r FROM:=TO, a parameter -p NAME:=VALUE.
    """
    endpoints, expected = graphs.draw(learner.random, fault)
    deaf = expected[0][1].split()
    mine = next(end for end in endpoints if [end['node'], end['name']] == deaf)
    other = next(end for end in endpoints if end['node'].endswith('/sender_0'))
    found = learner.call('graph_repairs', endpoints)
    arguments = [pair[1] for pair in found if pair and pair[0] == list(expected[0])]
    expect(arguments, f'graph_repairs has no repair for {expected[0]}.')
    with graphs.System(learner.context.get_domain_id()) as system:
        publisher, heard = system.add(other), graphs.restart(system, mine, arguments[0])
        expect(heard.hears(publisher, 10.0), f'Started again with {" ".join(arguments[0])}, {deaf[0]} still hears '
                                            'nothing.')


def test_no_repair(learner):
    """A wrong type, or nobody there, cannot be repaired by arguments: the repair is an empty list.

    Somebody must change a program, or start one.
    """
    for fault in ('type', 'nobody', 'service type', 'service nobody'):
        for finding, arguments in learner.call('graph_repairs', graphs.draw(learner.random, fault)[0]):
            expect(arguments == [], f'For {finding} repair_graph gave {arguments}, expected [].')
