"""The graph as rclpy tells it, live."""

import pytest
import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient, ActionServer
from std_msgs.msg import String

from helpers import GraphView, show_graph, spinning, wait_for
from helpers.kernel.ros import nodes
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
    a.create_subscription(String, '/chatter', print, 10)
    a.create_service(AddTwoInts, 'add', lambda request, response: response)
    b.create_client(AddTwoInts, 'robot/add')
    ends = ActionServer(a, Fibonacci, 'count', print), ActionClient(b, Fibonacci, 'robot/count')
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
