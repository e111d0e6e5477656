"""What a reader of the tf2 tutorials sees: a turtle that follows, frames, and points."""

import math
import os
import signal

import pytest
from geometry_msgs.msg import PointStamped
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener
from turtlesim.msg import Pose

from environment.tests.running import PATIENCE, ROS2, ended, program

pytestmark = pytest.mark.usefixtures('domain')


@pytest.fixture
def place(peer):
    """Return a frame's place (x, y) in metres and its yaw in radians in another one, or None while it is unknown."""
    buffer = Buffer()
    listener = TransformListener(buffer, peer.node)

    def look(target, source):
        try:
            transform = buffer.lookup_transform(target, source, Time()).transform
        except TransformException:
            return None
        turn = transform.rotation
        return transform.translation.x, transform.translation.y, 2 * math.atan2(turn.z, turn.w)

    yield look
    listener.unregister()


def test_one_turtle_follows_the_other(start, peer, place):
    launched = start(ROS2, 'launch', 'turtle_tf2_py', 'turtle_tf2_demo.launch.py')
    launched.wait_for_output('[listener]: Successfully spawned turtle2', PATIENCE)
    near = peer.until(lambda: (there := place('turtle2', 'turtle1')) and math.hypot(*there[:2]) < 1.0 and there, 'near')
    assert abs(near[1]) < 0.5  # it looks at turtle1
    names = {'sim', 'broadcaster1', 'broadcaster2', 'listener'}
    assert names <= {name for name, _ in peer.node.get_node_names_and_namespaces()}


def test_a_turtle_follows_a_carrot(start, peer, place):
    launched = start(ROS2, 'launch', 'turtle_tf2_py', 'turtle_tf2_fixed_frame_demo.launch.py')
    launched.wait_for_output('Successfully spawned turtle2', PATIENCE)
    peer.until(lambda: (there := place('turtle2', 'carrot1')) and math.hypot(*there[:2]) < 1.0, 'near the carrot')
    assert place('turtle1', 'carrot1')[:2] == (0.0, 2.0)


def test_a_frame_that_jumps(start, peer, place):
    start(program('turtle_tf2_py', 'dynamic_frame_tf2_broadcaster'))
    seen = set()

    def look():
        if there := place('turtle1', 'carrot1'):
            seen.add(tuple(round(number) for number in there[:2]))
        return len(seen) == 2

    peer.until(look, 'both places')
    assert seen == {(0, 10), (0, -10)}


def test_a_frame_that_stands_still(start, peer, place):
    start(program('turtle_tf2_py', 'static_turtle_tf2_broadcaster'), 'mystaticturtle', '0', '1', '0', '0', '0', '0.5')
    peer.until(lambda: place('world', 'mystaticturtle'), 'the frame')
    assert place('world', 'mystaticturtle') == pytest.approx((0.0, 1.0, 0.5))


@pytest.mark.parametrize(
    'arguments, status, said',
    [
        (['mystaticturtle', '0'], 1, 'Invalid number of parameters'),
        (['world', *'001000'], 2, 'Your static turtle name cannot be "world"'),
        (['mystaticturtle', *'00100', 'left'], 1, "could not convert string to float: 'left'"),
    ],
)
def test_a_command_line_that_cannot_be_read(start, arguments, status, said):
    process = start(program('turtle_tf2_py', 'static_turtle_tf2_broadcaster'), *arguments)
    assert ended(process)[0] == status
    assert said in process.output
    assert 'Traceback' not in process.output


def test_ros_arguments_that_cannot_be_read_are_no_success(start):
    process = start(program('turtle_tf2_py', 'turtle_tf2_listener'), '--ros-args', '--no-such-option')
    assert ended(process)[0] == 1
    assert '--no-such-option' in process.output


def test_points_of_the_third_turtle(start, peer):
    launched = start(ROS2, 'launch', 'turtle_tf2_py', 'turtle_tf2_sensor_message.launch.py')
    points, poses = peer.listen(PointStamped, '/turtle3/turtle_point_stamped'), peer.listen(Pose, '/turtle3/pose')
    launched.wait_for_output('Successfully spawned turtle3', PATIENCE)
    peer.until(lambda: points and points[-1].point.y > 2.1, 'a turtle that drives in a circle')
    assert points[-1].header.frame_id == 'world'
    assert points[-1].header.stamp.sec > 0
    peer.until(
        lambda: (points[-1].point.x, points[-1].point.y) in {(each.x, each.y) for each in poses}, 'the same place'
    )


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_program_quietly(start, number):
    listener = start(program('turtle_tf2_py', 'turtle_tf2_listener'))
    listener.wait_for_output('Service is not ready', PATIENCE)
    os.kill(listener.pid, number)
    assert ended(listener)[0] == 0
    assert 'Traceback' not in listener.output
