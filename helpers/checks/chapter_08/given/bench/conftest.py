"""A test bench for the robot: the node, in a time of its own.

There is no world around it. The test says where the robot is, and lets time pass.
"""

import gc
import threading
import time
from math import cos, sin

import pytest
import rclpy
from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation
from geometry_msgs.msg import TransformStamped, Twist
from rclpy.action import ActionClient
from rclpy.clock import ClockType
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.time import Time
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String
from tf2_ros import TransformBroadcaster

STEP = 0.1  # s of simulated time
PACE = 0.01  # s of wall time that a step takes at least
PATIENCE = 2.0  # s of wall time; a robot that drives and does not sleep so long keeps time in another way


class Bench:
    """The node `robot`, and a tester that hears its `status` and its `commands` (`geometry_msgs/msg/Twist`)."""

    robot_sleeps = True  # with the node's clock, in the rounds of a drive

    def __init__(self):
        from delivery_robot.robot import DeliveryRobot

        self.seconds = 1.0
        self.place = 0.0, 0.0, 0.0  # x, y in m and yaw in rad in the frame map; None: nobody tells
        self.status, self.commands = [], []
        self.robot = DeliveryRobot(parameter_overrides=[Parameter('use_sim_time', value=True)])
        self.tester = rclpy.create_node('tester', start_parameter_services=False, enable_rosout=False)
        self.clock = self.tester.create_publisher(Clock, 'clock', 10)
        self.localizer = TransformBroadcaster(self.tester)
        self.tester.create_subscription(String, 'status', lambda msg: self.status.append(msg.data), 10)
        self.tester.create_subscription(Twist, 'cmd_vel', self.commands.append, 10)
        self.client = self.tester.create_client(SetStation, 'set_station')
        self.action = ActionClient(self.tester, GoToStation, 'go_to_station')
        self.asleep = []  # until when
        self._watch(self.robot.get_clock())
        self.executor = MultiThreadedExecutor(6)
        self.executor.add_node(self.robot)
        self.executor.add_node(self.tester)
        self.spinner = threading.Thread(target=self._spin, daemon=True)
        self.spinner.start()
        self._wait(lambda: self.clock.get_subscription_count(), 'a subscription to /clock')
        self.run(0.2)

    def run(self, seconds):
        """Let simulated time pass."""
        for _ in range(round(seconds / STEP)):
            self._step()

    def until(self, condition, seconds=3.0):
        """Let simulated time pass until `condition()` is true. An AssertionError, if it is not in that time."""
        for _ in range(round(seconds / STEP)):
            if condition():
                return
            self._step()
        assert condition(), f'it did not come in {seconds:g} simulated seconds'

    def set_station(self, name, x, y):
        """Call set_station; returns the response."""
        assert self.client.wait_for_service(5.0), 'there is no service set_station'
        return self._answer(self.client.call_async(SetStation.Request(name=name, x=float(x), y=float(y))))

    def set_parameter(self, name, value):
        """Try to set a parameter of the robot; True if it was accepted."""
        return self.robot.set_parameters([Parameter(name, value=value)])[0].successful

    def go(self, station):
        """Send a goal; returns its handle, which has `accepted`."""
        assert self.action.wait_for_server(5.0), 'there is no action go_to_station'
        return self._answer(self.action.send_goal_async(GoToStation.Goal(station=station)))

    def cancel(self, goal):
        """Ask the robot to cancel a goal. How the goal ends is in `result`."""
        self._answer(goal.cancel_goal_async())

    def result(self, goal, seconds=10.0):
        """Let simulated time pass until a goal has ended; returns what came: `status` and `result`.

        An AssertionError, if it has not ended in that time.
        """
        future = goal.get_result_async()
        self.until(future.done, seconds)
        return future.result()

    def close(self):
        """End it, also in the middle of a drive. No thread and no node is left for the next test."""
        if self.robot.state != 'idle':
            self.place = None
            self.run(0.8)
        rclpy.try_shutdown()  # wakes a drive that sleeps
        self.executor.shutdown(timeout_sec=2.0)
        self.executor._executor.shutdown(wait=False)  # rclpy 7.1 leaves the threads of its pool
        self.spinner.join(2.0)
        self.action.destroy()
        for node in (self.robot, self.tester):
            node.destroy_node()

    def _spin(self):
        try:
            self.executor.spin()
        except ExternalShutdownException:
            pass

    def _step(self):
        begin, self.seconds = time.monotonic(), self.seconds + STEP
        now = Time(seconds=self.seconds, clock_type=ClockType.ROS_TIME)
        if self.place is not None:
            self.localizer.sendTransform(self._transform(now))
        self.clock.publish(Clock(clock=now.to_msg()))
        # Time goes on when the robot has seen it: a busy machine makes a test slow, and not wrong.
        self._wait(lambda: self.robot.get_clock().now() >= now, "the robot's clock")
        while self.robot_sleeps and self.robot.state != 'idle' and not any(due > now for due in self.asleep):
            time.sleep(0.0005)
            Bench.robot_sleeps = time.monotonic() < begin + PATIENCE
        time.sleep(max(0.0, begin + PACE - time.monotonic()))

    def _watch(self, clock):
        """Note until when the robot sleeps: a drive that works is not asleep, and time waits for it."""
        sleep_until = clock.sleep_until

        def noted(until, context=None):
            self.asleep.append(until)
            try:
                return sleep_until(until, context)
            finally:
                self.asleep.remove(until)

        clock.sleep_until = noted

    def _transform(self, now):
        x, y, yaw = self.place
        message = TransformStamped(child_frame_id='base_footprint')
        message.header.stamp, message.header.frame_id = now.to_msg(), 'map'
        message.transform.translation.x, message.transform.translation.y = float(x), float(y)
        message.transform.rotation.z, message.transform.rotation.w = sin(yaw / 2), cos(yaw / 2)
        return message

    def _answer(self, future):
        self._wait(future.done, 'an answer of the robot')
        return future.result()

    @staticmethod
    def _wait(condition, what):
        deadline = time.monotonic() + 10.0
        while not condition():
            assert time.monotonic() < deadline, f'{what} did not come in 10 s'
            time.sleep(0.001)


@pytest.fixture
def bench():
    rclpy.init()
    bench = Bench()
    yield bench
    bench.close()
    del bench
    gc.collect()  # the threads of its DDS participant end with the last object that knows it
