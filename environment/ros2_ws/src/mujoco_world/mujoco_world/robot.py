"""What a URDF says to a simulator besides its links and joints: the ``<gazebo>`` elements that Gazebo reads, too.

Of these, this reads: friction (``<mu1>``), one sensor of type ``gpu_lidar`` or ``lidar``, one of type ``camera``, and
the plugin of the differential drive. The rest is left to Gazebo.
"""

from dataclasses import dataclass
from math import inf, isfinite, pi
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import urdf_reader
from urdf_reader import UrdfError

DRIVE = 'gz::sim::systems::DiffDrive'


@dataclass(frozen=True)
class Drive:
    """A differential drive: two joints, and what its controller believes about the wheels (metres; m/s², rad/s²).

    `linear_velocity` and `angular_velocity` are the least and the largest velocity that it tries (m/s, rad/s).
    """

    left: str
    right: str
    separation: float
    radius: float
    linear_acceleration: float = inf
    angular_acceleration: float = inf
    linear_velocity: tuple[float, float] = (-inf, inf)
    angular_velocity: tuple[float, float] = (-inf, inf)
    odom_frame: str = 'odom'
    base_frame: str = 'base_footprint'


@dataclass(frozen=True)
class Lidar:
    """A scanner that looks around in the plane z = 0 of its link; angles in radians, ranges in metres, rate in Hz.

    :param noise: standard deviation of a range, in metres.
    """

    link: str
    frame: str
    rate: float
    samples: int
    min_angle: float
    max_angle: float
    min_range: float
    max_range: float
    noise: float

    @property
    def increment(self) -> float:
        """Angle from one ray to the next; the last ray is at `max_angle`."""
        return (self.max_angle - self.min_angle) / max(1, self.samples - 1)


@dataclass(frozen=True)
class Camera:
    """A pinhole camera that looks along x of its link; `fov` is the horizontal angle of view in radians."""

    link: str
    frame: str
    rate: float
    width: int
    height: int
    fov: float
    near: float
    far: float


@dataclass(frozen=True)
class Robot:
    """A robot for the simulation. `friction` is by link; a link without it has 1."""

    description: urdf_reader.Robot
    friction: dict[str, float]
    drive: Drive | None = None
    lidar: Lidar | None = None
    camera: Camera | None = None


def read(text: str) -> Robot:
    """Return the robot that a URDF describes. Raises UrdfError, one line that says what is wrong."""
    description = urdf_reader.read(text)
    friction: dict[str, float] = {}
    parts: dict[str, object] = {}
    for element in ElementTree.fromstring(text).iter('gazebo'):
        link = element.get('reference', '')
        for plugin in element.iter('plugin'):
            if plugin.get('name') == DRIVE:
                parts['drive'] = _drive(plugin, description)
        if not link:
            continue
        known = description.links.keys() | description.joints.keys()  # Gazebo has such elements for joints, too
        if link not in known:
            raise UrdfError(f'<gazebo reference="{link}">: there is no such link')
        if element.find('mu1') is not None:
            friction[link] = _number(element, 'mu1', at_least=0.0)
        for sensor in element.iter('sensor'):
            if sensor.get('type') in ('gpu_lidar', 'lidar'):
                parts['lidar'] = _lidar(sensor, link)
            elif sensor.get('type') == 'camera':
                parts['camera'] = _camera(sensor, link)
    return Robot(description, friction, **parts)


def _drive(plugin: Element, description: urdf_reader.Robot) -> Drive:
    wheels = [(plugin.findtext(f'{side}_joint') or '').strip() for side in ('left', 'right')]
    for name in wheels:
        joint = description.joints.get(name)
        if joint is None or joint.type != 'continuous':
            raise UrdfError(f"the differential drive's joint {name!r} is no continuous joint of the robot")
    return Drive(
        *wheels,
        separation=_number(plugin, 'wheel_separation', at_least=1e-3),
        radius=_number(plugin, 'wheel_radius', at_least=1e-3),
        linear_acceleration=_number(plugin, 'max_linear_acceleration', inf, at_least=1e-3),
        angular_acceleration=_number(plugin, 'max_angular_acceleration', inf, at_least=1e-3),
        linear_velocity=_velocities(plugin, 'linear'),
        angular_velocity=_velocities(plugin, 'angular'),
        odom_frame=plugin.findtext('frame_id', 'odom').strip(),
        base_frame=plugin.findtext('child_frame_id', 'base_footprint').strip(),
    )


def _velocities(plugin: Element, kind: str) -> tuple[float, float]:
    """The least and the largest velocity; <min_velocity> and <max_velocity> stand for both kinds, as in Gazebo."""
    least = _number(plugin, f'min_{kind}_velocity', _number(plugin, 'min_velocity', -inf))
    most = _number(plugin, f'max_{kind}_velocity', _number(plugin, 'max_velocity', inf))
    if least > most:
        raise UrdfError(
            f'the differential drive: the {kind} velocity has the minimum {least:g} above the maximum {most:g}'
        )
    return least, most


def _lidar(sensor: Element, link: str) -> Lidar:
    lidar = sensor.find('lidar') if sensor.find('lidar') is not None else sensor.find('ray')
    if lidar is None:
        raise UrdfError(f'the sensor of {link} has no <lidar>')
    scan = 'scan/horizontal'
    one = Lidar(
        link,
        sensor.findtext('gz_frame_id', link).strip(),
        _number(sensor, 'update_rate', 10.0, at_least=0.1),
        samples=int(_number(lidar, f'{scan}/samples', at_least=1)),
        min_angle=_number(lidar, f'{scan}/min_angle', -pi),
        max_angle=_number(lidar, f'{scan}/max_angle', pi),
        min_range=_number(lidar, 'range/min', 0.0, at_least=0.0),
        max_range=_number(lidar, 'range/max', at_least=1e-3),
        noise=_number(lidar, 'noise/stddev', 0.0, at_least=0.0),
    )
    if one.min_angle > one.max_angle or one.min_range >= one.max_range:
        raise UrdfError(f'the <lidar> of {link}: a minimum is above its maximum')
    return one


def _camera(sensor: Element, link: str) -> Camera:
    camera = sensor.find('camera')
    if camera is None:
        raise UrdfError(f'the sensor of {link} has no <camera>')
    return Camera(
        link,
        sensor.findtext('gz_frame_id', link).strip(),
        _number(sensor, 'update_rate', 5.0, at_least=0.1),
        width=int(_number(camera, 'image/width', 320, at_least=1)),
        height=int(_number(camera, 'image/height', 240, at_least=1)),
        fov=_number(camera, 'horizontal_fov', 1.047, at_least=0.01),
        near=_number(camera, 'clip/near', 0.1, at_least=1e-3),
        far=_number(camera, 'clip/far', 100.0, at_least=0.1),
    )


def _number(element: Element, path: str, default: float | None = None, at_least: float = -inf) -> float:
    text = element.findtext(path)
    if text is None:
        if default is None:
            raise UrdfError(f'<{element.tag}> has no <{path.rpartition("/")[2]}>')
        return default
    try:
        value = float(text)
    except ValueError:
        value = float('nan')
    if not isfinite(value) or value < at_least:
        raise UrdfError(
            f'<{path.rpartition("/")[2]}>{text}</…> must be a number'
            + (f' of at least {at_least:g}' if at_least > -inf else '')
        )
    return value
