"""Listeners, broadcasters and waiting on real topics, under every executor."""

import sys
import threading
from pathlib import Path

import pytest
import tf2_ros
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from rosgraph_msgs.msg import Clock
from std_srvs.srv import Trigger
from tf2_broadcaster import DEPTH, where
from tf2_msgs.msg import TFMessage
from tf2_msgs.srv import FrameGraph
from tf2_py import BufferCore

from environment.tests.tf2_domain import TIMEOUT
from environment.tests.tf2_messages import position, transform
from helpers.kernel.waiting import wait_for

LATEST = Time()
LONG = Duration(seconds=TIMEOUT)


def matched(publisher, count=1):
    """Wait until the publisher has subscriptions; only what a volatile publisher sends after that arrives."""
    wait_for(lambda: publisher.get_subscription_count() >= count, TIMEOUT, message='subscriptions')


def test_listener_and_broadcaster_in_two_processes_agree(domain):
    domain.start([sys.executable, Path(__file__).with_name('tf2_broadcaster.py')])
    node = domain.node()
    buffer = tf2_ros.Buffer(node=node)
    tf2_ros.TransformListener(buffer, node)
    domain.spin(node)
    tip = f'link{DEPTH}'
    # A stamp that was sent is looked up exactly.
    sent = buffer.lookup_transform('link0', 'link1', LATEST, LONG).header.stamp
    expected = BufferCore()
    xyz, xyzw = where(sent.sec * 10**9 + sent.nanosec)
    for link in range(DEPTH):
        expected.set_transform_static(transform(f'link{link}', f'link{link + 1}', xyz=xyz, xyzw=xyzw), 'test')
    found = buffer.lookup_transform('link0', tip, Time.from_msg(sent), LONG)
    ours = expected.lookup_transform_core('link0', tip, LATEST)
    assert position(found) == pytest.approx(position(ours), abs=1e-6)
    assert found.transform.rotation.z == pytest.approx(ours.transform.rotation.z, abs=1e-6)
    # The future is waited for, and a static transform holds then as well.
    later = Time.from_msg(sent) + Duration(seconds=0.3)
    assert position(buffer.lookup_transform('link5', 'camera', later, LONG)) == (0, 0, 1)
    assert position(buffer.lookup_transform('link5', 'laser', later, LONG)) == (0, 0, 2)
    between = buffer.lookup_transform('link0', 'link1', later, LONG)
    assert between.header.stamp == later.to_msg()
    assert between.transform.translation.x == pytest.approx(where(later.nanoseconds)[0][0], abs=1e-3)


def test_quality_of_service(domain):
    node = domain.node()
    listener = tf2_ros.TransformListener(tf2_ros.Buffer(), node)
    tf2_ros.TransformBroadcaster(node)
    tf2_ros.StaticTransformBroadcaster(node)

    def durability(infos):
        assert len(infos) == 1
        return infos[0].qos_profile.durability

    assert durability(node.get_subscriptions_info_by_topic('/tf')) == DurabilityPolicy.VOLATILE
    assert durability(node.get_subscriptions_info_by_topic('/tf_static')) == DurabilityPolicy.TRANSIENT_LOCAL
    assert durability(node.get_publishers_info_by_topic('/tf_static')) == DurabilityPolicy.TRANSIENT_LOCAL
    listener.unregister()
    assert not node.get_subscriptions_info_by_topic('/tf') and not node.get_subscriptions_info_by_topic('/tf_static')


def test_static_transforms_reach_late_listeners_and_can_be_replaced(domain):
    sender = domain.node('sender')
    broadcaster = tf2_ros.StaticTransformBroadcaster(sender)
    broadcaster.sendTransform(transform('a', 'b', xyz=(1, 0, 0)))
    broadcaster.sendTransform(transform('a', name, xyz=(2, 0, 0)) for name in ('b', 'c'))
    receiver = domain.node('receiver')
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, receiver)
    domain.spin(receiver)
    assert position(buffer.lookup_transform('a', 'c', LATEST, LONG)) == (2, 0, 0)
    assert position(buffer.lookup_transform('a', 'b', LATEST)) == (2, 0, 0)


def asking(domain, executor, answer):
    """
    Have a service callback ask a buffer for a transform that is sent only after it has begun to ask.

    :param answer: the callback's body, `answer(buffer) -> bool`, or a coroutine function.
    """
    node = domain.node('asking')
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, node)
    begun = threading.Event()
    ask = buffer.can_transform_core

    def noticing(*arguments):
        begun.set()
        return ask(*arguments)

    buffer.can_transform_core = noticing
    node.create_service(Trigger, 'ask', answer(buffer))
    domain.spin(node, executor=executor)
    sender = domain.node('sender')
    broadcaster = tf2_ros.TransformBroadcaster(sender)
    client = sender.create_client(Trigger, 'ask')
    domain.spin(sender)
    assert client.wait_for_service(TIMEOUT)
    matched(broadcaster.pub_tf)
    done = threading.Event()
    future = client.call_async(Trigger.Request())
    future.add_done_callback(lambda _: done.set())
    assert begun.wait(TIMEOUT)
    broadcaster.sendTransform(transform('odom', 'base', 5.0, (5, 0, 0)))
    assert done.wait(TIMEOUT)
    return future.result()


def blocking(timeout):
    def make(buffer):
        def callback(request, response):
            try:
                response.message = str(position(buffer.lookup_transform('odom', 'base', LATEST, timeout)))
                response.success = True
            except tf2_ros.TransformException as error:
                response.message = str(error)
            return response

        return callback

    return make


def awaiting(buffer):
    async def callback(request, response):
        response.message = str(position(await buffer.lookup_transform_async('odom', 'base', LATEST)))
        response.success = True
        return response

    return callback


def test_a_listener_to_static_transforms_hears_no_others(domain):
    node = domain.node()
    static, both = tf2_ros.Buffer(), tf2_ros.Buffer()
    listeners = [
        tf2_ros.StaticTransformListener(static, node, tf_static_topic='/fixed'),
        tf2_ros.TransformListener(both, node, tf_topic='/moving', tf_static_topic='/fixed'),
    ]
    moving = node.create_publisher(TFMessage, '/moving', 10)
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    fixed = node.create_publisher(TFMessage, '/fixed', latched)
    domain.spin(node)
    matched(moving)
    moving.publish(TFMessage(transforms=[transform('world', 'robot')]))
    fixed.publish(TFMessage(transforms=[transform('robot', 'camera')]))
    both.lookup_transform('world', 'camera', LATEST, LONG)
    static.lookup_transform('robot', 'camera', LATEST, LONG)
    assert not static.can_transform('world', 'robot', LATEST)
    assert node.count_subscribers('/moving') == 1 and node.count_subscribers('/fixed') == len(listeners)


def test_blocking_wait_in_a_callback_under_a_multi_threaded_executor(domain):
    answer = asking(domain, MultiThreadedExecutor, blocking(LONG))
    assert (answer.success, answer.message) == (True, '(5.0, 0.0, 0.0)')


def test_blocking_wait_in_a_callback_under_a_single_threaded_executor_times_out(domain):
    # Nobody can receive while the only thread waits. That is stock's behaviour and a lesson of the course.
    answer = asking(domain, SingleThreadedExecutor, blocking(Duration(seconds=0.3)))
    assert not answer.success and 'does not exist' in answer.message


@pytest.mark.parametrize('executor', [SingleThreadedExecutor, MultiThreadedExecutor])
def test_awaiting_in_a_callback(domain, executor):
    answer = asking(domain, executor, awaiting)
    assert (answer.success, answer.message) == (True, '(5.0, 0.0, 0.0)')


def test_listener_with_a_thread_of_its_own(domain):
    node = domain.node()
    buffer = tf2_ros.Buffer()
    listener = tf2_ros.TransformListener(buffer, node, spin_thread=True)
    broadcaster = tf2_ros.TransformBroadcaster(domain.node('sender'))
    matched(broadcaster.pub_tf)
    broadcaster.sendTransform([transform('odom', 'base', 5.0), transform('base', 'laser', 5.0)])
    assert buffer.can_transform('odom', 'laser', LATEST, LONG)
    thread = listener.dedicated_listener_thread
    listener.__del__()
    assert not thread.is_alive()
    assert not node.get_subscriptions_info_by_topic('/tf')


def test_bad_transforms_do_not_stop_the_listener(domain):
    node = domain.node()
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, node)
    domain.spin(node)
    broadcaster = tf2_ros.TransformBroadcaster(domain.node('sender'))
    matched(broadcaster.pub_tf)
    broadcaster.sendTransform(
        [
            transform('a', 'a'),
            transform('', 'b'),
            transform('a', 'b', xyz=(float('nan'), 0, 0)),
            transform('a', 'b', xyzw=(0, 0, 0, 0)),
            transform('odom', 'base', 1.0),
        ]
    )
    assert buffer.can_transform('odom', 'base', LATEST, LONG)
    assert buffer._getFrameStrings() == ['base', 'odom']


def test_simulated_time_that_jumps_back_clears_the_buffer(domain):
    node = domain.node(parameter_overrides=[Parameter('use_sim_time', value=True)])
    buffer = tf2_ros.Buffer(node=node)
    cleared = threading.Event()
    clear = buffer.clear
    buffer.clear = lambda: (clear(), cleared.set())
    domain.spin(node)
    publisher = domain.node('clock').create_publisher(Clock, '/clock', 10)
    matched(publisher)

    def set_time(seconds):
        publisher.publish(Clock(clock=Time(seconds=seconds).to_msg()))
        wait_for(lambda: node.get_clock().now().nanoseconds == seconds * 10**9, TIMEOUT)

    set_time(100)
    cleared.clear()
    buffer.set_transform(transform('odom', 'base', 100.0), 'test')
    set_time(101)
    assert not cleared.is_set() and buffer.can_transform('odom', 'base', LATEST)
    set_time(50)
    assert cleared.wait(TIMEOUT)
    assert not buffer.can_transform('odom', 'base', LATEST)


def test_service_tells_the_frames(domain):
    node = domain.node()
    buffer = tf2_ros.Buffer(node=node)
    buffer.set_transform(transform('odom', 'base', 1.0), 'test')
    domain.spin(node)
    other = domain.node('other')
    client = other.create_client(FrameGraph, 'tf2_frames')
    domain.spin(other)
    assert client.wait_for_service(TIMEOUT)
    done = threading.Event()
    future = client.call_async(FrameGraph.Request())
    future.add_done_callback(lambda _: done.set())
    assert done.wait(TIMEOUT)
    assert future.result().frame_yaml == buffer.all_frames_as_yaml()


def test_messages_carry_all_that_was_sent(domain):
    node = domain.node()
    received = []
    node.create_subscription(TFMessage, '/tf', received.append, 10)
    broadcaster = tf2_ros.TransformBroadcaster(node)
    event = threading.Event()
    node.create_subscription(TFMessage, '/tf', lambda _: event.set(), 10)
    matched(broadcaster.pub_tf, 2)
    broadcaster.sendTransform(iter([transform('a', 'b'), transform('b', 'c')]))
    domain.spin(node)
    assert event.wait(TIMEOUT)
    assert [message.child_frame_id for message in received[0].transforms] == ['b', 'c']


def test_a_destroyed_buffer_client_leaves_the_node(domain):
    node = domain.node()
    before = list(node.waitables)
    client = tf2_ros.BufferClient(node, 'server')
    assert client.action_client in node.waitables
    client.destroy()
    assert list(node.waitables) == before
