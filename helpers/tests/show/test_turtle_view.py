"""The picture of turtlesim's world: what it follows, what it shows, what it leaves."""

import math
import sys
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest
from geometry_msgs.msg import Twist
from std_srvs.srv import Empty

from helpers import TurtleView, background, spinning, wait_for
from helpers.kernel.ros import nodes
from helpers.show import turtle_view
from helpers.show.turtle_pad import TurtlePad
from helpers.show.turtle_view import TurtlePicture, World
from helpers.show.widgets import VIEW

from turtlesim_nodes.world import PIXELS, to_pixels  # isort: skip  (its folder is found by turtle_view)

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
    drawing = ElementTree.fromstring(bundle[SVG])
    assert drawing.get('width') == '200'
    texts = [element.text for element in drawing.iter() if element.tag.endswith('}text')]
    assert bundle['text/plain'] in texts and {'0', '10', 'x [m]', 'y [m]'} <= set(texts)
    assert bundle['text/plain'] == 'ada: x 2.00 m, y 3.00 m, theta 90°'


def names_in(world: World) -> dict[str, tuple[float, float]]:
    """Where the names of turtles stand in the picture, in pixels."""
    return {
        element.text: (float(element.get('x')), float(element.get('y')))
        for element in ElementTree.fromstring(TurtlePicture(world).svg()).iter()
        if element.tag.endswith('}text') and element.text in world.turtles
    }


def test_several_turtles_have_their_names_beside_them_inside_of_the_world():
    world = World()
    world.spawn(5.0, 5.0, 0.0, 'ada')
    assert names_in(world) == {}
    world.spawn(0.0, 0.0, math.pi / 2, 'a_long_name')
    names = names_in(world)
    assert math.dist(names['ada'], to_pixels(5.0, 5.0)) < 60
    left, bottom = names['a_long_name']
    assert left > 60 and bottom < PIXELS


def test_where_a_turtle_looks_and_the_goal_are_drawn_at_their_places():
    world = World()
    world.spawn(2.0, 3.0, math.pi / 2, 'ada')
    without, drawing = (TurtlePicture(world, goal=goal).svg() for goal in (None, (4.0, 3.0)))
    x, y = to_pixels(2.0, 3.0)
    assert f'd="M {x:.1f} {y:.1f} l 0.0 -' in drawing, 'it looks up'
    x, y = to_pixels(4.0, 3.0)
    mark = f'cx="{x:.1f}" cy="{y:.1f}"'
    assert mark in drawing and mark not in without


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
        wait_for(lambda: view.pose().x > 6.5 and not view.pose().linear_velocity, timeout=30)  # it stands: no new trail
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


def test_an_arrow_drives_the_turtle_and_until_then_the_graph_has_no_publisher(simulator, ros):
    with TurtleView() as view:
        wait_for(view.pose, timeout=30)
        assert view._node.count_publishers('/turtle1/cmd_vel') == 0
        TurtlePad('', view._drive)._on_page(None, {'press': 'up'}, [])
        wait_for(lambda: view.pose().x > 6.0, timeout=30)
        assert view._node.count_publishers('/turtle1/cmd_vel') == 1


def test_what_a_page_says_and_is_no_arrow_is_ignored():
    sent = []
    pad = TurtlePad('', lambda *speeds: sent.append(speeds))
    for content in ({'press': 'left'}, {'press': 'home'}, {}, 'up', None):
        pad._on_page(None, content, [])
    assert sent == [(0.0, 2.0)]


def test_a_view_goes_on_for_a_person_and_not_for_a_test(ros, monkeypatch):
    asked = []
    monkeypatch.setattr(turtle_view, 'spin_for', asked.append)
    with TurtleView() as view:
        pad = TurtlePad('', lambda *speeds: None)
        view._output = SimpleNamespace(widget=pad, close=lambda picture: None)
        view.watch(60, at_least=0.5)
        assert asked == [0.5]
        pad._on_page(None, {'shown': True}, [])
        view.watch(60, at_least=0.5)
        assert len(asked) == 3 and 50 < asked[-1] <= 60


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
    state.x += 0.05 * (state.x < 9.0)
    publisher.publish(state)
node.create_timer(0.02, move)
with spinning(node):
    view = TurtleView(size=100)
    changes = []
    view._output.widget.observe(changes.append, 'picture')
    wait_for(lambda: len(changes) > 3, timeout=30)
ros.stop()
"""


def test_the_picture_of_a_cell_changes_while_the_cell_runs_and_a_still_is_left(kernel):
    outputs, pictures = [], []

    def note(message):
        content = message['content']
        if message['msg_type'] in ('display_data', 'update_display_data'):
            outputs.append((content['transient']['display_id'], content['data']))
        elif message['msg_type'].startswith('comm') and 'picture' in content['data'].get('state', {}):
            pictures.append(content['data']['state']['picture'])

    reply = kernel.client.execute_interactive(LIVE, output_hook=note, timeout=60, allow_stdin=False)
    assert reply['content']['status'] == 'ok', reply['content']
    (live_id, live), (still_id, still) = outputs
    assert live_id == still_id, 'one picture, not one after the other'
    assert VIEW in live and SVG in live, 'a front end without widgets shows a still'
    assert VIEW not in still and '<polyline' in still[SVG]
    assert len(set(pictures)) == len(pictures) > 3, 'only a changed picture is sent'
    assert '<polyline' in pictures[-1]
