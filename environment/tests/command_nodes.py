"""The nodes that the tests look at: python command_nodes.py NAME."""

import sys
import time

import rclpy
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy


def robot():
    """Has one of everything: topics, a service, parameters."""
    from geometry_msgs.msg import TwistStamped
    from sensor_msgs.msg import JointState
    from std_msgs.msg import String
    from std_srvs.srv import SetBool

    node = Node('robot')
    chatter = node.create_publisher(String, 'chatter', 10)
    twist = node.create_publisher(TwistStamped, 'twist', 10)
    joints = node.create_publisher(JointState, 'joints', 10)
    node.create_publisher(String, '_hidden', 10)
    node.create_subscription(String, 'heard', lambda message: print('heard', message.data, flush=True), 10)
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.latched = node.create_publisher(String, 'latched', latched)
    node.latched.publish(String(data='kept'))
    sensor = node.create_publisher(String, 'sensor', QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))

    def tick():
        chatter.publish(String(data='hello'))
        sensor.publish(String(data='measured'))
        moved = TwistStamped()
        moved.header.stamp = node.get_clock().now().to_msg()
        moved.twist.linear.x = 1.0
        twist.publish(moved)
        joints.publish(JointState(name=['left', 'right'], position=[0.5, 1.5]))

    def switch(request, response):
        response.success = request.data
        response.message = 'switched'
        return response

    node.create_timer(0.05, tick)
    node.create_service(SetBool, 'switch', switch)
    node.declare_parameter(
        'rate',
        5,
        ParameterDescriptor(description='How often', integer_range=[IntegerRange(from_value=1, to_value=10, step=1)]),
    )
    node.declare_parameter('name', 'bob')
    node.declare_parameter('arm.joints', [1.0, 2.0])
    node.declare_parameter('fixed', True, ParameterDescriptor(read_only=True))
    node.declare_parameter('free', 1, ParameterDescriptor(dynamic_typing=True))
    return [node]


def worker():
    """Has an action server that counts slowly."""
    from example_interfaces.action import Fibonacci

    node = Node('worker')

    def execute(goal):
        sequence = [0, 1]
        while len(sequence) <= goal.request.order:
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=sequence)
            sequence.append(sequence[-1] + sequence[-2])
            goal.publish_feedback(Fibonacci.Feedback(sequence=sequence))
            time.sleep(0.05)
        goal.succeed()
        return Fibonacci.Result(sequence=sequence)

    node.server = ActionServer(
        node,
        Fibonacci,
        'fibonacci',
        execute,
        callback_group=ReentrantCallbackGroup(),
        goal_callback=lambda goal: GoalResponse.ACCEPT if goal.order <= 40 else GoalResponse.REJECT,
        cancel_callback=lambda _: CancelResponse.ACCEPT,
    )
    return [node]


def managed():
    """Has a lifecycle."""
    return [LifecycleNode('managed'), Node('plain')]


def adder():
    """Adds, for the article's command line."""
    from example_interfaces.srv import AddTwoInts

    node = Node('adder')

    def add(request, response):
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, 'add_two_ints', add)
    return [node]


def introspected():
    """Publishes the events of its service."""
    from rclpy.qos import qos_profile_system_default
    from rclpy.service_introspection import ServiceIntrospectionState
    from std_srvs.srv import SetBool

    node = Node('introspected')

    def switch(request, response):
        response.success, response.message = request.data, 'done'
        return response

    service = node.create_service(SetBool, 'watched', switch)
    service.configure_introspection(node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS)
    return [node]


def deaf():
    """Offers a topic with less than it asks for elsewhere, and so hears nothing."""
    from std_msgs.msg import String

    node = Node('deaf')
    node.create_publisher(String, 'mismatch', QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))
    node.create_subscription(
        String, 'mismatch', lambda message: None, QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE)
    )
    return [node]


def main():
    """Spin the nodes that the command line names until a signal comes."""
    rclpy.init()
    kinds = {
        'robot': robot,
        'worker': worker,
        'managed': managed,
        'adder': adder,
        'deaf': deaf,
        'introspected': introspected,
    }
    nodes = kinds[sys.argv[1]]()
    executor = MultiThreadedExecutor(4)
    for node in nodes:
        executor.add_node(node)
    print('ready', flush=True)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    executor.shutdown()
    rclpy.try_shutdown()


if __name__ == '__main__':
    main()
