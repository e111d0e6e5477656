"""The picture of turtlesim's world: what it follows, what it shows, what it leaves."""

import math
import sys
from xml.etree import ElementTree

import pytest
from geometry_msgs.msg import Twist
from std_srvs.srv import Empty

from helpers import TurtleView, background, spinning, wait_for
from helpers.kernel.ros import nodes
from helpers.show.turtle_view import TurtlePicture, World

SVG = 'image/svg+xml'


@pytest.fixture
def simulator(ros):
    """turtlesim as a process of its own, without a window."""
    pytest.importorskip('turtlesim_nodes.simulator')
    code = 'from turtlesim_nodes.simulator import main; main()'
    with background([sys.executable, '-c', code], env={'DISPLAY': '', 'WAYLAND_DISPLAY': ''}) as process:
        process.wait_for_output('Spawning turtle', 30)
        yield process


def test_a_world_is_shown_as_a_picture_and_as_text():
    world = World()
    assert str(TurtlePicture(world, 200)) == 'no turtle'
    world.spawn(2.0, 3.0, math.pi / 2, 'ada')
    bundle = TurtlePicture(world, 200)._repr_mimebundle_()
    assert ElementTree.fromstring(bundle[SVG]).get('width') == '200'
    assert bundle['text/plain'] == 'ada: x 2.00 m, y 3.00 m, theta 90°'


def test_a_view_follows_the_simulator_of_another_process_and_leaves_nothing(simulator, ros):
    import rclpy

    with TurtleView() as view:
        wait_for(view.pose, timeout=30)
        assert view.turtles == ['turtle1'] and view.pose().x == pytest.approx(5.544, abs=0.01)
        driver = rclpy.create_node('driver')
        publisher = driver.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        wait_for(publisher.get_subscription_count, timeout=30)
        twist = Twist()
        twist.linear.x = 2.0
        publisher.publish(twist)
        wait_for(lambda: view.pose().x > 6.5, timeout=30)
        assert '<polyline' in TurtlePicture(view._world, 100)._repr_mimebundle_()[SVG], 'the trail is drawn'
        with spinning(driver):
            clear = driver.create_client(Empty, 'clear')
            assert clear.wait_for_service(30)
        view.clear()
        assert '<polyline' not in TurtlePicture(view._world, 100)._repr_mimebundle_()[SVG]
        node = view._node
    assert not nodes.is_alive(node)
    view.stop()
    assert repr(view).startswith('turtle1: x ')


def test_a_second_view_replaces_the_first(ros):
    first = TurtleView()
    second = TurtleView()
    assert not nodes.is_alive(first._node) and nodes.is_alive(second._node)
    assert second.pose() is None and second.turtles == [] and repr(second) == 'no turtle'
    ros.stop()
    assert not nodes.is_alive(second._node)
    second.stop()


def test_a_new_simulator_begins_a_new_turtle(ros):
    import rclpy
    from turtlesim.msg import Pose

    def simulator(x):
        node = rclpy.create_node('fake')
        publisher = node.create_publisher(Pose, 'turtle1/pose', 10)
        node.create_timer(0.02, lambda: publisher.publish(Pose(x=x, y=1.0)))
        return node

    with TurtleView() as view:
        with spinning(simulator(1.0)):
            wait_for(view.pose, timeout=30)
        wait_for(lambda: view.pose() is None, timeout=30)
        assert 'x 1.00' in repr(view), 'the last picture stays'
        with spinning(simulator(9.0)):
            wait_for(lambda: 'x 9.00' in repr(view), timeout=30)
        assert '<polyline' not in TurtlePicture(view._world, 100)._repr_mimebundle_()[SVG], 'no line between the two'


def test_without_ros_it_says_what_to_do():
    from helpers import ros

    ros.stop()
    with pytest.raises(RuntimeError, match='helpers.ros.start'):
        TurtleView()


LIVE = """
import rclpy
from helpers import ros, spinning, wait_for
from helpers.show.turtle_view import TurtleView
from turtlesim.msg import Pose

ros.start()
node = rclpy.create_node('fake')
publisher = node.create_publisher(Pose, 'turtle1/pose', 10)
state = Pose(x=1.0, y=1.0)
def move():
    state.x += 0.05
    publisher.publish(state)
node.create_timer(0.02, move)
with spinning(node), TurtleView(size=100) as view:
    wait_for(lambda: view.pose() and view.pose().x > 3.0, timeout=30)
ros.stop()
"""


def test_the_picture_of_a_cell_changes_while_the_cell_runs(kernel):
    shown = []

    def note(message):
        if message['msg_type'] in ('display_data', 'update_display_data'):
            content = message['content']
            shown.append((message['msg_type'], content['transient']['display_id'], content['data'][SVG]))

    reply = kernel.client.execute_interactive(LIVE, output_hook=note, timeout=60, allow_stdin=False)
    assert reply['content']['status'] == 'ok', reply['content']
    kinds, ids, pictures = zip(*shown, strict=True)
    assert kinds[0] == 'display_data' and set(kinds[1:]) == {'update_display_data'}
    assert len(set(ids)) == 1, 'one picture, not one after the other'
    assert len(set(pictures)) == len(pictures) > 3, 'only a changed picture is sent'
    assert '<polyline' in pictures[-1]
