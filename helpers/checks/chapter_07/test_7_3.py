"""Visible tests of exercise 7.3, who does not hear whom."""

import pytest

from helpers.checks.chapter_07 import graphs
from helpers.checks.chapter_07.findings import compare
from helpers.runner import expect

pytestmark = pytest.mark.exercise('7.3')


def test_read(learner):
    """read_topics sees a publisher that runs, with its six texts.

    get_publishers_info_by_topic and get_subscriptions_info_by_topic tell the QoS, too.
    """
    ear = {'role': 'subscription', 'node': '/ear', 'name': '/chatter', 'type': 'std_msgs/msg/String',
           'reliability': 'BEST_EFFORT', 'durability': 'VOLATILE'}
    with graphs.System(learner.context.get_domain_id()) as system:
        system.add(ear)
        seen = learner.call('endpoints_here', 1, 5.0)
    expect(seen == [ear], f'There is one endpoint, {ear}; read_topics and read_services gave {seen}.')


def test_name(learner):
    """A topic that nobody publishes, and a near name: cause `name`, and a remapping repairs it.

    nearest(name, names) finds it among the names that are published.
    """
    common = {'type': 'std_msgs/msg/String', 'reliability': 'RELIABLE', 'durability': 'VOLATILE'}
    endpoints = [{'role': 'publisher', 'node': '/mouth', 'name': '/chatter', **common},
                 {'role': 'subscription', 'node': '/ear', 'name': '/chater', **common}]
    compare(learner.call('diagnose_graph', endpoints), [('A7.6', '/ear /chater', 'name', '/chatter')], graphs.WHY)
    (_, arguments), = learner.call('graph_repairs', endpoints)
    expect(arguments in (['-r', '/chater:=/chatter'], ['--remap', '/chater:=/chatter']),
           f"repair_graph gave {arguments}, expected a remapping rule, ['-r', '/chater:=/chatter'].")
