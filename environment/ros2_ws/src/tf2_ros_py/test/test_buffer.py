"""The buffer of a node: waiting, futures, time jumps; registrations."""

import threading
from copy import deepcopy

import pytest
import tf2_geometry_msgs  # noqa: F401  (registers PointStamped)
import tf2_ros
from geometry_msgs.msg import Point, PointStamped
from rclpy.clock import ClockChange, TimeJump
from rclpy.duration import Duration
from rclpy.time import Time
from std_msgs.msg import Header

from environment.tests.tf2_messages import position, transform

LATEST = Time()
LONG = Duration(seconds=30)


@pytest.fixture
def buffer():
    return tf2_ros.Buffer()


def send(buffer, seconds=1.0):
    buffer.set_transform(transform('odom', 'base', seconds, (seconds, 0, 0)), 'test')


def test_answers_are_ints_and_debug_tuples(buffer):
    assert buffer.can_transform('odom', 'base', LATEST) == 0
    assert buffer.can_transform('odom', 'base', LATEST, return_debug_tuple=True) == (
        0,
        'Invalid frame ID "odom" passed to canTransform argument target_frame - frame does not exist',
    )
    send(buffer)
    answer = buffer.can_transform('odom', 'base', LATEST)
    assert (answer, type(answer)) == (1, int)
    assert buffer.can_transform_full('odom', LATEST, 'base', LATEST, 'odom', return_debug_tuple=True) == (1, '')


def test_waiting_ends_when_the_transform_comes(buffer):
    asked = threading.Event()
    ask = buffer.can_transform_core

    def noticing(*arguments):
        answer = ask(*arguments)
        asked.set()
        return answer

    buffer.can_transform_core = noticing
    found = []
    waiter = threading.Thread(target=lambda: found.append(buffer.lookup_transform('odom', 'base', LATEST, LONG)))
    waiter.start()
    assert asked.wait(30.0)
    send(buffer)
    waiter.join(30.0)
    assert [position(message) for message in found] == [(1.0, 0.0, 0.0)]


def test_waiting_is_bounded(buffer):
    with pytest.raises(tf2_ros.LookupException):
        buffer.lookup_transform('odom', 'base', LATEST, Duration(seconds=0.05))
    with pytest.raises(tf2_ros.LookupException):
        buffer.lookup_transform_full('odom', LATEST, 'base', LATEST, 'odom', Duration(seconds=0.05))
    assert buffer.can_transform('odom', 'base', LATEST, Duration(seconds=-1)) == 0


def test_futures(buffer):
    future = buffer.wait_for_transform_async('odom', 'base', Time(seconds=2))
    full = buffer.wait_for_transform_full_async('odom', Time(seconds=1), 'base', Time(seconds=1), 'odom')
    send(buffer, 1.0)
    assert full.done() and not future.done()
    send(buffer, 3.0)
    assert position(future.result()) == pytest.approx((2, 0, 0))
    at_once = buffer.wait_for_transform_async('odom', 'base', LATEST)
    assert position(at_once.result()) == (3, 0, 0)


def test_static_transforms_complete_futures(buffer):
    future = buffer.wait_for_transform_async('odom', 'base', Time(seconds=2))
    buffer.set_transform_static(transform('odom', 'base'), 'test')
    assert future.done()


def test_a_cancelled_future_is_left_alone(buffer):
    future = buffer.wait_for_transform_async('odom', 'base', LATEST)
    future.cancel()
    send(buffer)
    assert future.cancelled()


def test_a_future_that_begins_another_wait(buffer):
    later = []
    first = buffer.wait_for_transform_async('odom', 'base', LATEST)
    first.add_done_callback(lambda _: later.append(buffer.wait_for_transform_async('odom', 'base', Time(seconds=5))))
    send(buffer, 1.0)
    send(buffer, 5.0)
    assert position(later[0].result()) == (5, 0, 0)


@pytest.mark.parametrize('change', [ClockChange.ROS_TIME_NO_CHANGE, ClockChange.ROS_TIME_ACTIVATED])
def test_a_jump_back_clears(buffer, change, logged):
    send(buffer)
    buffer.set_transform_static(transform('base', 'laser'), 'test')
    buffer.time_jump_callback(TimeJump(change, Duration(seconds=-2)))
    assert buffer.can_transform('odom', 'base', LATEST) == 0
    assert buffer.can_transform('base', 'laser', LATEST) == 1
    assert logged() == '[WARN] [tf2_buffer]: Detected jump back in time. Clearing tf buffer.\n'


def test_transforms_stamped_objects(buffer):
    send(buffer)
    point = PointStamped(header=Header(frame_id='base', stamp=Time(seconds=1).to_msg()), point=Point(x=1.0))
    before = deepcopy(point)
    moved = buffer.transform(point, 'odom')
    assert (moved.point.x, moved.header.frame_id) == (2.0, 'odom')
    assert point == before
    again = buffer.transform_full(point, 'odom', Time(seconds=1), 'odom', new_type=PointStamped)
    assert again == moved and again is not moved
    with pytest.raises(tf2_ros.TypeException, match="Type <class 'str'> is not loaded or supported"):
        buffer.transform('base', 'odom')


def test_conversions():
    class Metres:
        def __init__(self, x):
            self.x = x

    registration = tf2_ros.ConvertRegistration()
    registration.add_to_msg(Metres, lambda metres: PointStamped(point=Point(x=metres.x)))
    registration.add_convert((Metres, float), lambda metres: metres.x)
    assert tf2_ros.convert(Metres(2.0), PointStamped).point.x == 2.0
    assert tf2_ros.convert(Metres(2.0), float) == 2.0
    original = Metres([1.0])
    copied = tf2_ros.convert(original, Metres)
    assert copied.x == [1.0] and copied.x is not original.x
    with pytest.raises(tf2_ros.TypeException):
        tf2_ros.convert(2.0, Metres)


def test_an_interface_without_an_implementation():
    interface = tf2_ros.BufferInterface()
    for method, arguments in (
        ('lookup_transform', 3),
        ('can_transform', 3),
        ('lookup_transform_full', 5),
        ('can_transform_full', 5),
    ):
        with pytest.raises(tf2_ros.NotImplementedException):
            getattr(interface, method)(*['x'] * arguments)


def test_stamped():
    point = tf2_ros.Stamped(PointStamped(), Time(seconds=3).to_msg(), 'base')
    assert (point.header.stamp.sec, point.header.frame_id) == (3, 'base')


def test_public_names():
    for name in (
        'Buffer',
        'BufferCore',
        'BufferInterface',
        'BufferClient',
        'TransformListener',
        'TransformBroadcaster',
        'StaticTransformBroadcaster',
        'TransformRegistration',
        'ConvertRegistration',
        'convert',
        'Stamped',
        'TypeException',
        'NotImplementedException',
        'TransformException',
        'ConnectivityException',
        'LookupException',
        'ExtrapolationException',
        'InvalidArgumentException',
        'TimeoutException',
        'Time',
        'Duration',
        'Node',
        'TransformStamped',
        'PointStamped',
        'TFMessage',
    ):
        assert hasattr(tf2_ros, name), name
