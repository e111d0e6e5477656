"""A simulated robot in this kernel: `PhysicsWorld` runs the node of the package mujoco_world."""

import math
import sys
from pathlib import Path

from helpers.kernel.callback_errors import say
from helpers.kernel.executors import refuse_in_callback
from helpers.kernel.handles import raise_pending
from helpers.kernel.settling import settle
from helpers.kernel.spinning import spinning
from helpers.paths import ROOT

_worlds: list['PhysicsWorld'] = []


class PhysicsWorld:
    """A robot in a world with gravity, contact and friction, on ROS topics.

    ::

        world = PhysicsWorld()                  # runs in the background, in real time
        with world.view(): …                    # seen in 3-D
        world.stop()

        with PhysicsWorld(real_time_factor=None) as world:      # time passes in run() only, step by step
            world.drive(0.3, 0.0)
            world.run(2.0)

    It is the same node as ``ros2 run mujoco_world world`` (``/world``; see `mujoco_world.node.WorldNode` for its topics
    and services), and a ``/robot_state_publisher`` beside it. Both spin in the background until `stop` or
    ``helpers.ros.stop()``. A second world, in another cell, replaces the first one.

    Nodes that want the world's time need the parameter ``use_sim_time``.

    :param urdf: the text of a robot's description, or the path of its file; None: the course's robot.
    :param scene: ``'rooms'``, ``'empty'``, or the path of a scene's YAML file.
    :param real_time_factor: simulated seconds in a second; 0: as many as possible; None: time stands still until `run`.
    :param noise: a `mujoco_world.world.Noise`; None: the laser's as the URDF says, none of the odometry.
    :param seed: of the noise.
    :param localization: publish map -> odom, as a perfect localiser would.
    :raises RuntimeError: ROS is not started.
    :raises ValueError: the robot or the scene cannot be used (`UrdfError`, `SceneError`); the text says why.
    """

    def __init__(
        self,
        urdf: str | Path | None = None,
        scene: str | Path = 'rooms',
        real_time_factor: float | None = 1.0,
        noise=None,
        seed: int = 0,
        localization: bool = True,
    ):
        import rclpy
        from rclpy.logging import LoggingSeverity, set_logger_level
        from rclpy.parameter import Parameter

        if not rclpy.ok():
            raise RuntimeError('ROS is not started: run helpers.ros.start() first')
        from mujoco_world.node import WorldNode
        from mujoco_world.world import World

        values = {
            'robot_description': _text(urdf),
            'scene': str(scene),
            'seed': seed,
            'localization': localization,
            'real_time_factor': float(real_time_factor or 0.0),
        }
        if noise is not None:
            values |= {'odometry_noise': float(noise.odometry)}
            values |= {} if noise.range is None else {'range_noise': float(noise.range)}
        # What is wrong with robot or scene is raised here; the node would only log it.
        World(values['robot_description'] or None, values['scene']).close()
        for other in _worlds.copy():
            other.stop()
        for name in ('world', 'robot_state_publisher'):
            set_logger_level(name, LoggingSeverity.WARN)
        self._clocked = real_time_factor is not None
        self._node = WorldNode(
            clocked=self._clocked, parameter_overrides=[Parameter(name, value=value) for name, value in values.items()]
        )
        self._frames = _robot_state_publisher()(
            parameter_overrides=[
                Parameter('robot_description', value=self._node.world.urdf),
                Parameter('use_sim_time', value=True),
                Parameter('publish_frequency', value=50.0),
            ]
        )
        self._spinning = spinning(self._node, self._frames)
        _worlds.append(self)
        if (clocks := self._node.count_publishers('/clock')) > 1:
            say(
                f'{clocks} programs publish /clock in this domain. With two worlds, time and robot jump to and fro: '
                'stop one of them. "ros2 topic info /clock --verbose" names them.\n'
            )

    @property
    def simulator(self) -> str:
        """Which simulator this is, and its version, such as ``MuJoCo 3.17.0``."""
        import mujoco

        return f'MuJoCo {mujoco.__version__}'

    @property
    def world(self):
        """The `mujoco_world.world.World` itself."""
        return self._node.world

    @property
    def time(self) -> float:
        """Simulated seconds since the beginning."""
        return self.world.time

    @property
    def pose(self):
        """Where the robot truly is, in the frame map: x, y, z in metres, roll, pitch, yaw in radians."""
        with self._node.lock:
            return self.world.pose

    @property
    def odometry(self):
        """Where the robot's wheels say that it is, in the frame odom: x, y, yaw, and velocities linear, angular."""
        with self._node.lock:
            return self.world.odometry

    @property
    def touching(self) -> set[str]:
        """The names of the walls that the robot touches now."""
        with self._node.lock:
            return self.world.touching

    @property
    def stations(self) -> dict[str, tuple[float, float, float]]:
        """The scene's stations: x, y in metres and yaw in radians, in the frame map, by name."""
        return dict(self.world.scene.stations)

    def drive(self, linear: float, angular: float) -> None:
        """Command a velocity, as a message on ``/cmd_vel`` does: m/s forward, rad/s to the left.

        The robot keeps it until the next command, also longer than the node's ``command_timeout``.

        :raises ValueError: no finite numbers, or the robot has no drive.
        """
        with self._node.lock:
            self.world.drive(linear, angular)
            self.world.keep_command()

    def run(self, seconds: float, until=None) -> bool:
        """Let simulated time pass in lock-step with the nodes of this kernel: the same in every run.

        After each 0.02 s of simulated time it waits until the callbacks of all nodes that spin in the background have
        run, and what they have published has come. Programs in other processes are not waited for. A world that runs
        by itself pauses meanwhile, and goes on afterwards.

        :param seconds: of simulated time.
        :param until: a function; time stops when it returns true.
        :returns: whether `until` did.
        :raises CallbackError: a callback raised.
        :raises RuntimeError: the world has been stopped, or a callback has called this.
        """
        __tracebackhide__ = True
        from mujoco_world.topics import PERIOD

        refuse_in_callback('run()')
        if self not in _worlds:
            raise RuntimeError('this world has been stopped: make a new PhysicsWorld()')
        paused, self._node.paused = self._node.paused, True
        done = False
        try:
            settle()
            for _ in range(round(seconds / PERIOD)):
                self._node.step()
                settle()
                if until is not None and until():
                    done = True
                    break
            settle(views=True)
        finally:
            self._node.paused = paused
        raise_pending()
        return done

    def pause(self, pause: bool = True) -> None:
        """Hold simulated time, or let it go on (``pause(False)``)."""
        self._node.paused = pause

    def reset(self) -> None:
        """Put the robot back to its start, at rest, its odometry at zero. Time goes on."""
        with self._node.lock:
            self.world.reset()

    def place(self, x: float, y: float, yaw: float = 0.0) -> None:
        """Put the robot at another place. Its odometry does not change."""
        with self._node.lock:
            self.world.place(x, y, yaw)

    def image(self):
        """What the camera sees now, as an array: height x width x 3, uint8, red green blue.

        :raises NoPicturesError: this machine cannot render; the text says what it lacks.
        """
        with self._node.lock:
            return self.world.image()

    def view(self, *displays, **options):
        """Return a running `helpers.TfView` of this world: robot, scan and walls.

        :param displays: more of them.
        :param options: of TfView, such as ``frames=True``; the fixed frame is map.
        """
        from mujoco_world.topics import LATCHED

        from helpers.show.views import LaserScan, MarkerArray, RobotModel, TfView

        options = {'fixed_frame': 'map', 'frames': False, **options}
        return TfView(RobotModel(), LaserScan('/scan'), MarkerArray('/walls', qos=LATCHED), *displays, **options)

    def stop(self) -> None:
        """End the world: its nodes leave the graph. Idempotent."""
        if self in _worlds:
            _worlds.remove(self)
        self._spinning.stop()

    def __enter__(self) -> 'PhysicsWorld':
        return self

    def __exit__(self, kind, error, tb) -> None:
        __tracebackhide__ = True
        self.stop()
        if error is None:
            self._spinning.check()

    def __repr__(self) -> str:
        pose, state = self.pose, 'running'
        if not self._spinning.running:
            state = 'stopped'
        elif self._node.paused or not self._clocked:
            state = 'time stands still'
        where = f'robot at x {_short(pose.x)} m, y {_short(pose.y)} m, yaw {round(math.degrees(pose.yaw))}°'
        return f'<{self.simulator}, scene {self.world.scene.name}, {self.time:.2f} s, {state}; {where}>'


def _short(value: float) -> str:
    return f'{round(value, 2) + 0.0:.2f}'  # no "-0.00"


def _text(urdf: str | Path | None) -> str:
    """The text of a description that is given as such or as a file; '' for none."""
    if urdf is None:
        return ''
    if isinstance(urdf, Path) or '<' not in urdf:
        return Path(urdf).read_text()
    return urdf


def _robot_state_publisher() -> type:
    try:
        from robot_state_publisher.node import RobotStatePublisher
    except ModuleNotFoundError:  # stock's is a C++ program: the kernel needs a node, so it comes from our source
        sys.path.append(str(ROOT / 'environment' / 'ros2_ws' / 'src' / 'robot_state_publisher'))
        from robot_state_publisher.node import RobotStatePublisher
    return RobotStatePublisher
