"""The simulated robot for tests: the real physics, in the test's process and in the test's simulated time.

`MobileRobot` stands in for the node ``world`` and for robot_state_publisher: the learner's program drives it through
``/cmd_vel`` and sees through ``/odom``, ``/scan``, ``/joint_states``, ``/tf`` and ``/tf_static``. ::

    robot = MobileRobot(learner, scene='rooms')
    learner.start('Driver')
    learner.run(20.0, until=lambda: robot.distance(2.0, 0.0) < 0.1)
    expect(robot.distance(2.0, 0.0) < 0.1, f'After 20 s the robot is at {robot.pose.x:.1f}, {robot.pose.y:.1f}.')
    expect(not robot.bumps, 'The robot ran into a wall.')

It moves while `learner.run` lets time pass, beside whatever else the test has (clients, goals). A command counts from
the moment at which it comes. So a run is exactly repeatable.
"""

import math

from geometry_msgs.msg import TransformStamped, Twist
from mujoco_world.topics import LATCHED, Topics
from mujoco_world.world import CONTROL_PERIOD, Noise, World
from tf2_msgs.msg import TFMessage

from helpers.runner.peers import SECOND, Peer

_TICK = round(CONTROL_PERIOD * SECOND)  # ns


class MobileRobot(Peer):
    """A robot in a scene of mujoco_world.

    :param scene: ``rooms``, ``empty``, the path of a YAML file, or a `mujoco_world.scene.Scene`.
    :param start: x, y in metres and yaw in radians, in the frame map; None: as the scene says.
    :param noise: of the sensors; None: they are exact.
    :param seed: of the noise.
    :param period: seconds from one message to the next on each topic. The node's is 0.02 s (scan: 0.1 s); fewer
        messages save time.
    :param localization: publish map -> odom.
    :param command_timeout: seconds without a command after which the robot stops, as the node's parameter.
    :param urdf: another robot's description.

    `world` is the `World`, `commands` what the learner's program has sent on ``/cmd_vel``, `path` the poses (seconds,
    x, y, yaw) at each message, `bumps` the names of the walls that it ran into, in order.
    """

    def __init__(
        self,
        learner,
        scene='rooms',
        start: tuple[float, float, float] | None = None,
        *,
        noise: Noise | None = None,
        seed: int = 0,
        period: float = 0.1,
        localization: bool = True,
        command_timeout: float = 0.5,
        urdf: str | None = None,
    ):
        self._learner = learner
        self.world = World(urdf, scene, noise or Noise(range=0.0), seed, start, command_timeout)
        self.world.ticks = -(-learner.now // _TICK)
        self.bumps: list[str] = []
        self.path: list[tuple[float, float, float, float]] = []
        self._period = round(period * SECOND)
        self._next = learner.now
        self._seen = 0
        self._topics = Topics(self.world, localization)
        self.commands = learner.listen('/cmd_vel', Twist)
        self._talkers = [
            (topic, learner.talk(f'/{topic.name.lstrip("/")}', topic.type, topic.qos))
            for topic in self._topics.topics
            if topic.name not in ('/clock', 'image', 'camera_info')
        ]
        fixed = learner.talk('/tf_static', TFMessage, LATCHED)
        fixed.publisher.publish(TFMessage(transforms=self._frames(fixed=True)))
        for talker in (fixed, *(talker for _, talker in self._talkers)):
            talker.optional = True
        learner.add(self)

    @property
    def pose(self):
        """Where the robot truly is, in the frame map: x, y, z in metres, roll, pitch, yaw in radians."""
        return self.world.pose

    @property
    def stations(self) -> dict[str, tuple[float, float, float]]:
        """The scene's stations: x, y, yaw in the frame map, by name."""
        return dict(self.world.scene.stations)

    @property
    def localization(self) -> bool:
        """Whether map -> odom is published; a test may switch it off and on again."""
        return self._topics.localization

    @localization.setter
    def localization(self, on: bool) -> None:
        self._topics.localization = on

    def distance(self, x: float, y: float) -> float:
        """Metres from the robot to a place in the frame map."""
        return math.dist((self.pose.x, self.pose.y), (x, y))

    def moving(self, least: float = 0.01) -> bool:
        """Whether the robot drives or turns, faster than `least` (m/s, rad/s)."""
        odometry = self.world.odometry
        return abs(odometry.linear) > least or abs(odometry.angular) > least

    # As a peer of the learner's program

    def due(self) -> int:
        return self._next

    def act(self) -> None:
        self._advance()
        if self._learner.now < self._next:
            return
        self._next = self._learner.now + self._period
        pose = self.pose
        self.path.append((self.world.time, pose.x, pose.y, pose.yaw))
        for topic, talker in self._talkers:
            message = topic.make()
            if topic.name == '/tf':
                message.transforms += self._frames(fixed=False)
            talker.publisher.publish(message)

    def _advance(self) -> None:
        """Bring the world to the present, each command from its moment on."""
        recording = self.commands
        self._seen = min(self._seen, len(recording))  # a test may have cleared it
        for command, stamp in zip(recording.messages[self._seen :], recording.stamps[self._seen :], strict=True):
            self._run_to(round(stamp * SECOND))
            if math.isfinite(command.linear.x) and math.isfinite(command.angular.z):  # as the node does
                self.world.drive(command.linear.x, command.angular.z)
        self._seen = len(recording)
        self._run_to(self._learner.now)

    def _run_to(self, now: int) -> None:
        while (self.world.ticks + 1) * _TICK <= now:
            self.world.step()
            self.bumps += sorted(self.world.touching - set(self.bumps[-1:]))

    def _frames(self, fixed: bool) -> list[TransformStamped]:
        """The robot's own frames, as robot_state_publisher gives them."""
        found = []
        joints = self.world.joints
        for name, joint in self.world.robot.description.joints.items():
            if joint.moves == fixed:
                continue
            translation, rotation = joint.transform(0.0 if fixed else joints[name][0])
            message = TransformStamped(child_frame_id=joint.child)
            message.header.frame_id, message.header.stamp = joint.parent, self._topics.now()
            part = message.transform
            part.translation.x, part.translation.y, part.translation.z = translation
            part.rotation.x, part.rotation.y, part.rotation.z, part.rotation.w = rotation
            found.append(message)
        return found
