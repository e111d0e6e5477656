"""When what a learner's process sends can arrive at its own nodes: only then a step of simulated time waits for it."""

import pytest
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.client import Client
from rclpy.node import Node
from rclpy.publisher import Publisher
from std_msgs.msg import String
from std_srvs.srv import Trigger

from helpers.runner.rclpy_changes import Outgoing


@pytest.fixture
def nodes(domain, monkeypatch):
    """Two nodes, and an Outgoing that has seen all that was made since."""
    for kind in (Publisher, Client, ActionClient):
        monkeypatch.setattr(kind, '__init__', kind.__init__)  # put back after the test
    context = rclpy.Context()
    context.init(domain_id=domain)
    outgoing = Outgoing()
    outgoing.watch()
    yield outgoing, Node('left', context=context), Node('right', context=context)
    context.try_shutdown()


def test_a_node_that_only_says_and_hears_different_topics_hears_nothing_of_its_own(nodes):
    outgoing, left, right = nodes
    left.create_publisher(String, 'said', 10)
    left.create_subscription(String, 'heard', lambda message: None, 10)
    right.create_service(Trigger, 'served', lambda request, response: response)
    assert not outgoing.reaches([left, right])


def test_a_topic_of_another_node_of_the_same_process_arrives(nodes):
    outgoing, left, right = nodes
    left.create_publisher(String, 'said', 10)
    right.create_subscription(String, '/said', lambda message: None, 10)
    assert outgoing.reaches([left, right])
    assert outgoing.reaches([right]), 'who says it need not be a node that runs'
    assert not outgoing.reaches([left])


def test_what_a_publisher_has_said_may_be_on_its_way_when_it_has_gone(nodes):
    outgoing, left, right = nodes
    left.destroy_publisher(left.create_publisher(String, 'said', 10))
    right.create_subscription(String, 'said', lambda message: None, 10)
    assert outgoing.reaches([right])


@pytest.mark.parametrize(
    'make',
    [
        lambda node: node.create_client(Trigger, 'asked'),
        lambda node: ActionClient(node, Fibonacci, 'counted'),
        lambda node: node.create_subscription(String, 'counted/_action/status', lambda message: None, 10),
    ],
    ids=['client', 'action client', 'status of an action'],
)
def test_requests_answers_and_goals_may_arrive(nodes, make):
    outgoing, left, right = nodes
    assert not outgoing.reaches([left, right])
    make(left)
    assert outgoing.reaches([left, right])


def test_a_destroyed_subscription_harms_nobody(nodes):
    outgoing, left, _ = nodes
    left.create_publisher(String, 'said', 10)
    subscription = left.create_subscription(String, 'said', lambda message: None, 10)
    subscription.destroy()  # not by its node, which keeps it in its list
    assert not outgoing.reaches([left])
