"""
The simulated world, without ROS.

::

    world = World()                 # the course's robot in the scene "rooms"
    world.drive(0.3, 0.0)           # m/s forward, rad/s to the left
    world.run(2.0)                  # two seconds of simulated time, as fast as the machine can
    world.pose, world.odometry, world.scan()

The same calls with the same seed give the same numbers.
"""

from dataclasses import dataclass, replace
from math import atan2, cos, hypot, inf, isfinite, sin
from pathlib import Path

import mujoco
import numpy

from mujoco_world import model as models
from mujoco_world.drive import Controller, Odometry
from mujoco_world.model import BODY, FLOOR, LOOKS, TIMESTEP, WALLS
from mujoco_world.pictures import NoPicturesError, Pictures
from mujoco_world.robot import Robot, UrdfError, read
from mujoco_world.scene import Pose2D, Scene, SceneError, load

__all__ = ['CONTROL_PERIOD', 'NoPicturesError', 'Noise', 'Pose', 'SceneError', 'UnstableError', 'UrdfError', 'World']

CONTROL_PERIOD = 0.01  # s: how often the drive's controller acts and reads its wheels; what `World.step` advances by
DEEP = 1000.0  # m below the floor: who is there has fallen for 14 s, and falls for ever
_STEPS = round(CONTROL_PERIOD / TIMESTEP)


class UnstableError(RuntimeError):
    """The robot has left the world: its masses are too small for the forces, or nothing of it touches the floor."""


@dataclass(frozen=True)
class Noise:
    """
    How far the sensors are from the truth.

    :param range: standard deviation of a laser range, in metres; None: as the URDF's sensor says.
    :param odometry: standard deviation of the way that a wheel reports after it has rolled one metre, in metres. The
        error grows with the square root of the way, as that of many small independent errors does.
    """

    range: float | None = None
    odometry: float = 0.0

    def __post_init__(self) -> None:
        for name in ('range', 'odometry'):
            value = getattr(self, name)
            if value is not None and not (isfinite(value) and value >= 0):
                raise ValueError(f'noise {name} is {value}; it must be a length of at least 0 m')


@dataclass(frozen=True)
class Pose:
    """Where a frame is in the frame map: metres, and roll, pitch, yaw in radians (about fixed x, then y, then z)."""

    x: float
    y: float
    z: float
    roll: float
    pitch: float
    yaw: float


class World:
    """
    A robot on a floor, among the walls of a scene.

    :param urdf: the text of a robot's description; None: the course's robot.
    :param scene: the name of a scene (``rooms``, ``empty``), the path of a YAML file, or a `Scene`.
    :param noise: of the sensors.
    :param seed: of the noise.
    :param start: x, y, yaw of the robot's root frame at the beginning; None: as the scene says.
    :param command_timeout: seconds after which a robot that gets no further command stops; None: it never does.
    :raises UrdfError: the description cannot be read or simulated.
    :raises SceneError: there is no such scene.

    `robot` is what has been read from the URDF, `scene` the scene, `model` and `data` are MuJoCo's own.
    """

    def __init__(
        self,
        urdf: str | None = None,
        scene: str | Path | Scene = 'rooms',
        noise: Noise = Noise(),
        seed: int = 0,
        start: Pose2D | None = None,
        command_timeout: float | None = None,
    ):
        if urdf is None:
            import mobile_robot_description

            urdf = mobile_robot_description.urdf()
        self.urdf = urdf
        self.robot: Robot = read(urdf)
        self.scene = load(scene) if start is None else replace(load(scene), start=tuple(start))
        self.noise = noise
        self.seed = seed
        self.command_timeout = command_timeout
        mujoco.set_mju_user_warning(_ignore)
        self.model = models.build(urdf, self.robot, self.scene)
        self.data = mujoco.MjData(self.model)
        self._root = self.model.joint('root').qposadr[0]
        self._controller = Controller(self.robot.drive) if self.robot.drive else None
        self._wheels = [self.model.joint(name).qposadr[0] for name in self._drive_joints]
        self._own = {geom for geom in range(self.model.ngeom) if self.model.geom_bodyid[geom] != 0}
        self._pictures: Pictures | None = None
        self._no_pictures: NoPicturesError | None = None
        self._rays = self._make_rays()
        self.reset()

    # Time

    @property
    def time(self) -> float:
        """Simulated seconds since the beginning; exact multiples of `CONTROL_PERIOD`. `reset` does not set it back."""
        return self.ticks * CONTROL_PERIOD

    ticks = 0  # control periods since the beginning
    _commanded: float = 0  # the tick of the last command

    def step(self) -> None:
        """Advance by one control period, `CONTROL_PERIOD` seconds.

        :raises UnstableError: the numbers have blown up, or the robot falls without end; `reset` begins anew.
        """
        if self._controller:
            if self.command_timeout and (self.ticks - self._commanded) * CONTROL_PERIOD >= self.command_timeout:
                self._controller.target = (0.0, 0.0)
            self.data.ctrl[:2] = self._controller.step(CONTROL_PERIOD)
        mujoco.mj_step(self.model, self.data, _STEPS)
        mujoco.mj_kinematics(self.model, self.data)  # else the frames are those of one physics step ago
        self.ticks += 1
        self._check()
        self._read_wheels()

    def _check(self) -> None:
        if not (numpy.isfinite(self.data.qpos).all() and abs(self.data.qpos[self._root : self._root + 3]).max() < 1e5):
            raise UnstableError(
                'the simulation has become unstable: is there an <inertial> for each link that moves, '
                'with a mass and an inertia that fit its size?'
            )
        if self.data.qpos[self._root + 2] < -DEEP:
            raise UnstableError(
                f'the robot has fallen {DEEP:g} m: is there a <collision> for each link that is to stand on the floor?'
            )

    def run(self, seconds: float) -> None:
        """Advance by so many seconds, to the nearest control period."""
        for _ in range(round(seconds / CONTROL_PERIOD)):
            self.step()

    def reset(self) -> None:
        """Put the robot back to its start, at rest, its odometry at zero. Time goes on."""
        mujoco.mj_resetData(self.model, self.data)
        self.data.time = self.time
        self._random = {
            name: numpy.random.default_rng([self.seed, number]) for number, name in enumerate(('scan', 'odometry'))
        }
        self.place(*self.scene.start)
        self._odometry = Odometry()
        if self._controller:
            self._controller.reset()
        self._turned = self._wheel_angles()

    def place(self, x: float, y: float, yaw: float = 0.0) -> None:
        """Lift the robot to another place of the floor and put it down at rest. Its odometry knows nothing of it.

        Its root frame is on the floor; what would be below the floor then lifts it.
        """
        self.data.qpos[self._root : self._root + 7] = [x, y, 0, cos(yaw / 2), 0, 0, sin(yaw / 2)]
        self.data.qvel[:] = 0
        mujoco.mj_kinematics(self.model, self.data)
        floor = self.model.geom(FLOOR).id
        self.data.qpos[self._root + 2] = -min(
            [
                0.0,
                *(
                    mujoco.mj_geomDistance(self.model, self.data, floor, geom, 1.0, None)
                    for geom in self._own
                    if self.model.geom_group[geom] == BODY
                ),
            ]
        )
        mujoco.mj_forward(self.model, self.data)

    # Drive

    def drive(self, linear: float, angular: float) -> None:
        """Command a velocity (m/s forward, rad/s to the left), which the robot then keeps; see `command_timeout`.

        :raises ValueError: a number is not finite, or the robot has no differential drive.
        """
        if not (isfinite(linear) and isfinite(angular)):
            raise ValueError(f'a velocity must be finite numbers, not {linear}, {angular}')
        if self._controller is None:
            raise ValueError('this robot cannot drive: its URDF has no <gazebo> plugin of a differential drive')
        self._controller.target = (float(linear), float(angular))
        self._commanded = self.ticks

    def keep_command(self) -> None:
        """Keep the velocity that was commanded last, whatever `command_timeout` says."""
        self._commanded = inf

    @property
    def _drive_joints(self) -> tuple[str, ...]:
        return (self.robot.drive.left, self.robot.drive.right) if self.robot.drive else ()

    def _wheel_angles(self) -> numpy.ndarray:
        return self.data.qpos[self._wheels].copy()

    def _read_wheels(self) -> None:
        if self._controller is None:
            return
        angles = self._wheel_angles()
        turned, self._turned = angles - self._turned, angles
        distance, angle = self._controller.motion(*turned.tolist())
        self._odometry.linear, self._odometry.angular = distance / CONTROL_PERIOD, angle / CONTROL_PERIOD
        if self.noise.odometry:
            way = abs(turned) * self.robot.drive.radius
            error = self.noise.odometry * numpy.sqrt(way) * self._random['odometry'].standard_normal(2)
            distance, angle = self._controller.motion(*(turned + error / self.robot.drive.radius).tolist())
        self._odometry.move(distance, angle)

    # State

    @property
    def joints(self) -> dict[str, tuple[float, float]]:
        """Position and velocity of each joint that moves, by name: radians (metres) and per second."""
        found = {}
        for name, joint in self.robot.description.joints.items():
            if joint.moves:
                one = self.data.joint(name)
                found[name] = (float(one.qpos[0]), float(one.qvel[0]))
        return found

    def transform(self, link: str) -> numpy.ndarray:
        """Return where a link's frame truly is in the frame map: a homogeneous matrix, 4x4. Raises KeyError."""
        body = self.data.body(link)
        matrix = numpy.eye(4)
        matrix[:3, :3], matrix[:3, 3] = body.xmat.reshape(3, 3), body.xpos
        return matrix

    @property
    def pose(self) -> Pose:
        """Where the robot's root frame (base_footprint) truly is in the frame map."""
        matrix = self.transform(self.robot.description.root)
        (xx, _, _), (yx, _, _), (zx, zy, zz) = matrix[:3, :3].tolist()
        return Pose(*matrix[:3, 3].tolist(), roll=atan2(zy, zz), pitch=atan2(-zx, hypot(xx, yx)), yaw=atan2(yx, xx))

    @property
    def odometry(self) -> Odometry:
        """Where the wheels say that the robot is, in the frame odom, and how fast it is."""
        return replace(self._odometry)

    @property
    def touching(self) -> set[str]:
        """The names of the walls that the robot touches now."""
        names = set()
        for contact in self.data.contact[: self.data.ncon]:
            first, second = contact.geom
            if (first in self._own) != (second in self._own):
                names.add(self.model.geom(int(second if first in self._own else first)).name)
        return names - {FLOOR}

    # Sensors

    def scan(self) -> numpy.ndarray:
        """
        Return the laser's ranges now, float32: `robot.lidar.samples` of them, in metres, from `min_angle` on.

        Nothing within range is inf, as ROS wants it (REP 117); closer than the smallest range is -inf.

        :raises ValueError: the robot has no laser.
        """
        lidar = self.robot.lidar
        if lidar is None:
            raise ValueError('this robot has no laser: its URDF has no <gazebo> sensor of type gpu_lidar')
        pose = self.transform(lidar.link)
        rays = (self._rays @ pose[:3, :3].T).ravel()
        ids, ranges = numpy.empty(lidar.samples, numpy.int32), numpy.empty(lidar.samples)
        groups = numpy.zeros(6, numpy.uint8)
        groups[[WALLS, BODY]] = 1
        mujoco.mj_multiRay(
            self.model,
            self.data,
            pose[:3, 3].copy(),
            rays,
            groups,
            True,
            self.model.body(lidar.link).id,
            ids,
            ranges,
            None,
            lidar.samples,
            lidar.max_range,
        )
        hit = ids >= 0
        deviation = lidar.noise if self.noise.range is None else self.noise.range
        if deviation:
            ranges = ranges + deviation * self._random['scan'].standard_normal(lidar.samples)
        ranges = numpy.where(ranges < lidar.min_range, -numpy.inf, ranges)
        return numpy.where(hit & (ranges <= lidar.max_range), ranges, numpy.inf).astype(numpy.float32)

    def _make_rays(self) -> numpy.ndarray:
        """Directions in the laser's frame, N x 3."""
        lidar = self.robot.lidar
        if lidar is None:
            return numpy.empty((0, 3))
        angles = lidar.min_angle + lidar.increment * numpy.arange(lidar.samples)
        return numpy.stack([numpy.cos(angles), numpy.sin(angles), numpy.zeros_like(angles)], axis=1)

    def image(self) -> numpy.ndarray:
        """
        Return what the camera sees now: height x width x 3, uint8, red green blue.

        :raises ValueError: the robot has no camera.
        :raises NoPicturesError: this machine cannot render; the text says what it lacks.
        """
        camera = self.robot.camera
        if camera is None:
            raise ValueError('this robot has no camera: its URDF has no <gazebo> sensor of type camera')
        if self._no_pictures:
            raise self._no_pictures
        if self._pictures is None:
            try:
                self._pictures = Pictures(self.model, camera.width, camera.height)
            except NoPicturesError as error:
                self._no_pictures = error
                raise
        mujoco.mj_camlight(self.model, self.data)
        return self._pictures.take(self.data, 'camera', (WALLS, LOOKS))

    def close(self) -> None:
        """Give back what the camera holds."""
        if self._pictures is not None:
            self._pictures.close()
            self._pictures = None


def _ignore(text: str) -> None:
    """Take MuJoCo's warnings, which it else writes to a file where the program runs. `World.step` says what counts."""
