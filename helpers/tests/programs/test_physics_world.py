"""The simulated robot in a kernel: in lock-step and by itself, and what it leaves."""

import threading

import pytest
from geometry_msgs.msg import Twist
from mobile_robot_description import path, urdf
from mujoco_world.world import Noise
from rclpy.node import Node
from rclpy.parameter import Parameter
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan

from helpers import CallbackError, PhysicsWorld, collect, spinning, wait_for
from helpers.kernel.ros import nodes
from helpers.kernel.settling import settle


class Approach(Node):
    """Drives towards what is ahead, and stops 2.5 m before it; a timer counts the seconds of simulated time."""

    def __init__(self):
        super().__init__('approach', parameter_overrides=[Parameter('use_sim_time', value=True)])
        self.ranges, self.ticks = [], []
        self.publisher = self.create_publisher(Twist, '/cmd_vel', 10)
        self.create_subscription(LaserScan, '/scan', self.on_scan, 10)
        self.create_timer(1.0, lambda: self.ticks.append(self.get_clock().now().nanoseconds / 1e9))

    def on_scan(self, scan):
        self.ranges.append(scan.ranges[180])
        twist = Twist()
        twist.linear.x = min(0.5, max(0.0, scan.ranges[180] - 2.5))
        self.publisher.publish(twist)


def approach():
    with PhysicsWorld(real_time_factor=None, seed=7) as world, spinning(node := Approach()):
        stopped = world.run(20.0, until=lambda: world.time > 3.0 and world.odometry.linear < 0.02)
        return stopped, world.time, world.pose, node.ranges, node.ticks


def test_in_lock_step_a_run_with_a_node_of_the_kernel_is_the_same_each_time(ros):
    stopped, seconds, pose, ranges, ticks = first = approach()
    assert first == approach()
    assert stopped and pose.x == pytest.approx(1.45, abs=0.1)
    # 10 scans a second, and every one is heard before time goes on; the timer at each second of it.
    assert len(ranges) == int(seconds * 10 + 1e-6)
    assert ticks == [float(second) for second in range(1, int(seconds) + 1)]
    assert [thread for thread in threading.enumerate() if 'world' in thread.name] == []


def test_time_stands_still_between_runs_and_a_mistake_in_a_callback_is_raised(ros):
    with PhysicsWorld(scene='empty', real_time_factor=None, noise=Noise(range=0.0)) as world:
        assert world.simulator.startswith('MuJoCo 3.') and 'time stands still' in repr(world)
        world.drive(0.4, 0.0)
        world.run(2.0)  # longer than a message on /cmd_vel would count
        assert world.time == 2.0 and world.pose.x == pytest.approx(0.72, abs=0.01)
        world.place(3.0, 1.0)
        assert (world.pose.x, round(world.odometry.x, 1)) == (pytest.approx(3.0), 0.7)
        world.reset()
        assert world.pose.x == pytest.approx(0.0) and world.odometry.x == 0.0
        listener = Node('listener')
        listener.create_subscription(LaserScan, '/scan', lambda scan: scan.no_such_field, 10)
        with pytest.raises(CallbackError), spinning(listener):
            world.run(1.0)
        assert world.time < 2.2
    with pytest.raises(RuntimeError, match='has been stopped'):
        world.run(1.0)
    assert repr(world).count('stopped') == 1


def test_by_itself_a_world_runs_with_the_wall_until_it_is_stopped_or_replaced(ros):
    first = PhysicsWorld(real_time_factor=20.0)
    wait_for(lambda: first.time > 2.0, timeout=30)
    second = PhysicsWorld(path(), scene='empty', real_time_factor=0, localization=False)
    assert 'stopped' in repr(first)
    wait_for(lambda: second.time > 1.0, timeout=30)
    second.pause()
    settle()
    before = second.time
    second.run(0.5)
    assert second.time == pytest.approx(before + 0.5)
    second.pause(False)
    assert len(collect('/scan', LaserScan, 2, timeout=30)) == 2
    names = {node.get_name() for node in nodes.living()}
    assert names == {'world', 'robot_state_publisher'}
    ros.stop()
    assert not nodes.living() and 'stopped' in repr(second)
    second.stop()


def test_a_robot_or_scene_that_cannot_be_is_an_error_of_the_call_and_leaves_the_old_world(ros):
    with PhysicsWorld(real_time_factor=None) as world:
        for wrong, message in (({'scene': 'attic'}, "no scene 'attic'"), ({'urdf': urdf()[:-10]}, 'line 119')):
            with pytest.raises(ValueError, match=message):
                PhysicsWorld(**wrong)
        world.run(0.1)
        assert world.time == pytest.approx(0.1)


def test_a_second_clock_in_the_domain_is_told(ros, capfd):
    other = Node('other')
    other.create_publisher(Clock, '/clock', 10)
    with PhysicsWorld(real_time_factor=None):
        assert '2 programs publish /clock' in capfd.readouterr().err
    nodes.destroy(other)
    with PhysicsWorld(real_time_factor=None):
        assert '/clock' not in capfd.readouterr().err


def test_a_view_shows_robot_scan_and_walls(ros):
    with PhysicsWorld(real_time_factor=None) as world, world.view(live=False) as view:
        world.run(0.3)
        wait_for(lambda: not view.problems and 'left_wheel' in view.frames, timeout=30)
        view.stop()
        svg = view.picture().svg
    assert 'kitchen' in svg and 'fixed frame: map' in svg


def test_without_ros_a_world_says_what_to_do():
    with pytest.raises(RuntimeError, match='run helpers.ros.start'):
        PhysicsWorld()
