"""The graph as rclpy tells it, live."""

import itertools
import sys
from typing import NamedTuple

import pytest
import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient, ActionServer
from std_msgs.msg import String

from helpers import GraphView, background, show_graph, spinning, wait_for
from helpers.kernel import domains
from helpers.kernel.ros import nodes
from helpers.show.graph import view
from helpers.show.graph.model import Graph
from helpers.show.graph.participants import all_heard
from helpers.show.graph.reading import read

LINKS = {
    ('/b', 'publisher', '/chatter'),
    ('/robot/a', 'subscription', '/chatter'),
    ('/robot/a', 'server', '/robot/add'),
    ('/b', 'client', '/robot/add'),
    ('/robot/a', 'action server', '/robot/count'),
    ('/b', 'action client', '/robot/count'),
}


@pytest.fixture
def system(ros):
    """Two nodes with a topic, a service and an action between them."""
    a, b = rclpy.create_node('a', namespace='robot'), rclpy.create_node('b')
    b.create_publisher(String, 'chatter', 10)
    a.create_subscription(String, '/chatter', lambda message: None, 10)
    a.create_service(AddTwoInts, 'add', lambda request, response: response)
    b.create_client(AddTwoInts, 'robot/add')
    ends = ActionServer(a, Fibonacci, 'count', lambda goal: None), ActionClient(b, Fibonacci, 'robot/count')
    with spinning(a, b):
        yield ends


def links(view):
    return {(link.node, link.role, link.name) for link in view.graph.links}


def test_a_view_follows_what_comes_and_goes_and_leaves_nothing(system, domain):
    with GraphView() as view:
        wait_for(lambda: links(view) == LINKS, timeout=10)
        assert view.graph.domain_id == domain and view.graph.nodes == ('/b', '/robot/a') and view.problems == []
        late = rclpy.create_node('late')
        late.create_publisher(String, 'chater', 10)
        wait_for(lambda: view.problems, timeout=10)
        assert '/late publishes on /chater' in view.problems[0]
        late.destroy_node()
        wait_for(lambda: not view.problems, timeout=10)
        node = view._node
    assert not nodes.is_alive(node)
    view.stop()
    assert repr(view).startswith(f'Domain {domain}: 2 nodes, 1 topic, 1 service, 1 action, no problem found')


def test_what_is_hidden_can_be_shown_and_a_second_view_replaces_the_first(system, ros):
    first = GraphView(namespace='/other')
    wait_for(lambda: '/robot/a' not in first.graph.nodes)
    view = GraphView(namespace='robot', parameters=True, hidden=True)
    assert not nodes.is_alive(first._node)
    wait_for(lambda: '/robot/a/set_parameters' in view.graph.names('service'), timeout=10)
    assert '/robot/count/_action/send_goal' in view.graph.names('service')
    assert '/b' in view.graph.nodes and '/b/set_parameters' not in view.graph.names('service')
    ros.stop()
    assert not nodes.is_alive(view._node)
    view.stop()


def test_a_still_picture(system, capsys):
    show_graph()
    shown = capsys.readouterr().out
    assert '/robot/a' in shown and 'subscribes to /chatter [std_msgs/msg/String]' in shown
    assert '_show_graph' not in shown


def test_a_node_that_has_just_gone_has_nothing(ros):
    node = rclpy.create_node('watcher')
    node.get_node_names_and_namespaces = lambda: [('ghost', '/')]
    graph = read(node)
    assert graph.nodes == ('/ghost',) and graph.links == ()


@pytest.mark.parametrize('show', [show_graph, GraphView])
def test_ros_must_be_started(show, domain):
    with pytest.raises(RuntimeError, match='helpers.ros.start'):
        show()


def test_a_program_that_has_just_started_is_in_the_picture(ros, capsys):
    code = 'import rclpy; rclpy.init(); node = rclpy.create_node("other"); print("ready", flush=True); rclpy.spin(node)'
    with background([sys.executable, '-c', code]) as child:
        child.wait_for_output('ready', timeout=60)
        show_graph(timeout=30)
    assert '/other' in capsys.readouterr().out


class Endpoint(NamedTuple):
    participant: int
    node_name: str

    @property
    def endpoint_gid(self):
        return [self.participant] * 12 + [0] * 4


class Seen:
    """A node that has heard of some participants, and of the nodes of some of them."""

    def __init__(self, announced, named):
        self._heard = {
            'ros_discovery_info': [Endpoint(number, '_NODE_NAME_UNKNOWN_') for number in announced],
            '/parameter_events': [Endpoint(number, f'node_{number}') for number in named],
            '/rosout': [Endpoint(number, '_NODE_NAME_UNKNOWN_') for number in announced],
        }
        self.context = rclpy.Context()
        self.context.get_domain_id = lambda: 7

    def get_publishers_info_by_topic(self, topic, no_mangle=False):
        return self._heard[topic]


@pytest.mark.parametrize(
    'announced, named, listening, complete',
    [
        ([1], [1], 1, True),
        ([1], [1], 2, False),  # one that listens has not been heard
        ([1, 2], [1], 2, False),  # its nodes have not been heard
        ([1, 2], [1, 2], 2, True),
        ([1, 2], [1, 2], 0, True),  # no ports are listed; or one of the two is on another machine
    ],
)
def test_all_are_heard_when_each_that_listens_has_named_a_node(monkeypatch, announced, named, listening, complete):
    monkeypatch.setattr(domains, 'participants', lambda domain_id: {7: listening}[domain_id])
    assert all_heard(Seen(announced, named)) is complete


def graph(*names):
    return Graph(7, names, (), '/')


def test_a_graph_in_which_somebody_is_missing_is_not_settled(monkeypatch):
    """Not even if one look at the ports overlooks the missing one."""
    monkeypatch.setattr(view, '_STILL', 0.1)
    answers = iter([False, True, False, *[False] * 10])
    looks = itertools.count()
    fresh = view._settled(
        lambda: graph('/other') if next(looks) > 12 else graph(), lambda: next(answers, True), timeout=30
    )
    assert fresh.nodes == ('/other',)


def test_after_the_timeout_the_picture_is_taken_in_any_case():
    assert view._settled(lambda: graph(), lambda: False, timeout=0.2).nodes == ()
