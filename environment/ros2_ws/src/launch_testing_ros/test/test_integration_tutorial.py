"""The test of the integration testing tutorial, as a test of its own: turtlesim runs while its cases do."""

import threading
import unittest

import launch
import launch_ros.actions
import launch_testing
import launch_testing.actions
import launch_testing.asserts
import pytest
import rclpy
from launch_testing_ros import DataRepublisher, MessagePump, WaitForTopics
from turtlesim.msg import Pose


@pytest.mark.launch_test
@launch_testing.ready_to_test_action_timeout(60.0)
def generate_test_description():
    node = launch_ros.actions.Node(
        package='turtlesim', executable='turtlesim_node', name='turtle1', additional_env={'DISPLAY': ''}
    )
    ready = launch.actions.TimerAction(period=0.5, actions=[launch_testing.actions.ReadyToTest()])
    return launch.LaunchDescription([node, ready]), {'turtlesim': node}


class TestTurtleSim(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.context = rclpy.Context()
        rclpy.init(context=cls.context)

    @classmethod
    def tearDownClass(cls):
        cls.context.try_shutdown()

    def setUp(self):
        self.node = rclpy.create_node('test_turtlesim', context=self.context)

    def tearDown(self):
        self.node.destroy_node()

    def test_publishes_pose(self):
        received = []
        self.node.create_subscription(Pose, 'turtle1/pose', received.append, 100)
        executor = rclpy.executors.SingleThreadedExecutor(context=self.context)
        executor.add_node(self.node)
        end = self.node.get_clock().now() + rclpy.duration.Duration(seconds=60)
        while len(received) < 20 and self.node.get_clock().now() < end:
            executor.spin_once(timeout_sec=1)
        executor.shutdown()
        self.assertGreaterEqual(len(received), 20)

    def test_a_pump_runs_the_callbacks(self):
        heard = threading.Event()
        self.node.create_subscription(Pose, 'turtle1/pose', lambda _: heard.set(), 10)
        pump = MessagePump(self.node, context=self.context)
        pump.start()
        self.assertTrue(heard.wait(60))
        self.assertRaises(RuntimeError, pump.start)
        pump.stop()
        heard.clear()
        self.assertFalse(heard.wait(0.2))
        pump.start()
        self.assertTrue(heard.wait(60))
        pump.stop()
        pump.stop()

    def test_logs_spawning(self, proc_output):
        proc_output.assertWaitFor('Spawning turtle [turtle1] at x=', timeout=60, stream='stderr')

    def test_waits_for_topics(self):
        with WaitForTopics([('turtle1/pose', Pose)], timeout=60.0) as topics:
            self.assertEqual(topics.topics_received(), {'turtle1/pose'})
            self.assertEqual(topics.topics_not_received(), set())
            self.assertIsInstance(topics.received_messages('turtle1/pose')[-1], Pose)

    def test_messages_are_changed_on_their_way(self):
        executor = rclpy.executors.SingleThreadedExecutor(context=self.context)
        executor.add_node(self.node)
        heard = []
        self.node.create_subscription(Pose, 'moved', heard.append, 10)

        def moved(pose):
            pose.x += 100
            return pose if republisher.get_num_received() % 2 else None

        republisher = DataRepublisher(self.node, 'turtle1/pose', 'moved', Pose, moved)
        end = self.node.get_clock().now() + rclpy.duration.Duration(seconds=60)
        while len(heard) < 3 and self.node.get_clock().now() < end:
            executor.spin_once(timeout_sec=1)
        republisher.shutdown()
        executor.shutdown()
        self.assertTrue(len(heard) >= 3 and all(pose.x > 100 for pose in heard))
        self.assertEqual(republisher.get_num_republished(), len(republisher.get_republished()))
        self.assertEqual(republisher.get_num_republished(), (republisher.get_num_received() + 1) // 2)

    def test_a_topic_without_messages_is_named(self):
        called = []
        topics = WaitForTopics([('turtle1/pose', Pose), ('nothing', Pose)], timeout=0.5, trigger=called.append)
        self.assertFalse(topics.wait())
        self.assertIn('nothing', topics.topics_not_received())
        self.assertEqual([node.get_name() for node in called], ['wait_for_topics'])
        topics.shutdown()
        with self.assertRaisesRegex(RuntimeError, 'Did not receive messages on these topics'):
            with WaitForTopics([('nothing', Pose)], timeout=0.1):
                pass


@launch_testing.post_shutdown_test()
class TestTurtleSimShutdown(unittest.TestCase):
    def test_exit_codes(self, proc_info, turtlesim):
        launch_testing.asserts.assertExitCodes(proc_info)
        self.assertEqual(proc_info[turtlesim].returncode, 0)
