"""What a URDF describes. Lengths are in metres, angles in radians, masses in kilograms; quaternions are x, y, z, w."""

from dataclasses import dataclass
from functools import cached_property
from math import cos, hypot, sin

import numpy

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]


class UrdfError(ValueError):
    """A robot description that cannot be used; the text says where and why."""


@dataclass(frozen=True)
class Pose:
    """
    Where something is, relative to its parent.

    :param xyz: translation.
    :param rpy: roll, then pitch, then yaw, about the parent's fixed axes x, y, z.
    """

    xyz: Vector = (0.0, 0.0, 0.0)
    rpy: Vector = (0.0, 0.0, 0.0)

    @cached_property
    def quaternion(self) -> Quaternion:
        """The rotation as a quaternion."""
        (cr, sr), (cp, sp), (cy, sy) = ((cos(angle / 2), sin(angle / 2)) for angle in self.rpy)
        return (
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy,
        )

    @cached_property
    def matrix(self) -> numpy.ndarray:
        """The pose as a homogeneous matrix, 4x4: it takes points of the child to the parent."""
        x, y, z, w = self.quaternion
        matrix = numpy.eye(4)
        matrix[:3, :3] = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
        matrix[:3, 3] = self.xyz
        return matrix


@dataclass(frozen=True)
class Box:
    """A box about its centre."""

    size: Vector


@dataclass(frozen=True)
class Cylinder:
    """A cylinder about its centre; its axis is z."""

    radius: float
    length: float


@dataclass(frozen=True)
class Sphere:
    """A sphere about its centre."""

    radius: float


@dataclass(frozen=True)
class Mesh:
    """A file of triangles. `filename` is as written; :func:`urdf_reader.resolve` finds the file."""

    filename: str
    scale: Vector = (1.0, 1.0, 1.0)


Geometry = Box | Cylinder | Sphere | Mesh


@dataclass(frozen=True)
class Collision:
    """A shape that touches: `origin` is its pose in the link's frame."""

    geometry: Geometry
    origin: Pose = Pose()
    name: str = ''


@dataclass(frozen=True)
class Visual(Collision):
    """A shape that is seen. `colour` is red, green, blue, alpha from 0 to 1; None where the URDF gives none."""

    colour: tuple[float, float, float, float] | None = None


@dataclass(frozen=True)
class Inertial:
    """Mass and inertia about the centre of mass; `inertia` is ixx, ixy, ixz, iyy, iyz, izz in kg m²."""

    mass: float
    inertia: tuple[float, ...]
    origin: Pose = Pose()


@dataclass(frozen=True)
class Link:
    """A rigid body; its name is the name of its frame."""

    name: str
    visuals: tuple[Visual, ...] = ()
    collisions: tuple[Collision, ...] = ()
    inertial: Inertial | None = None


@dataclass(frozen=True)
class Limit:
    """How far a joint goes, and its largest effort (N or N m) and velocity (m/s or rad/s)."""

    lower: float = 0.0
    upper: float = 0.0
    effort: float = 0.0
    velocity: float = 0.0


@dataclass(frozen=True)
class Mimic:
    """A joint that follows another: its position is ``multiplier * position of joint + offset``."""

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True)
class Joint:
    """
    How the link `child` is fixed to, or moves against, the link `parent`.

    :param type: revolute, continuous, prismatic, fixed, floating or planar.
    :param origin: the child's frame in the parent's, at position 0.
    :param axis: unit vector in the joint's frame, of rotation or translation.
    :param soft_limits: lower and upper limit of the ``<safety_controller>``; None where it gives none.
    """

    name: str
    type: str
    parent: str
    child: str
    origin: Pose = Pose()
    axis: Vector = (1.0, 0.0, 0.0)
    limit: Limit | None = None
    mimic: Mimic | None = None
    soft_limits: tuple[float | None, float | None] = (None, None)

    @property
    def moves(self) -> bool:
        """Whether one number says where the joint is."""
        return self.type in ('revolute', 'continuous', 'prismatic')

    def transform(self, position: float) -> tuple[Vector, Quaternion]:
        """
        Return the translation and rotation from the child's frame to the parent's.

        :param position: of the joint, in radians or metres; without meaning for a joint that does not move.
        """
        if self.type == 'prismatic':
            x, y, z = self.origin.matrix[:3, :3] @ self.axis * position + self.origin.xyz
            return (float(x), float(y), float(z)), self.origin.quaternion
        if not self.moves:
            return self.origin.xyz, self.origin.quaternion
        ax, ay, az, aw = self.origin.quaternion
        half = position / 2
        bx, by, bz = (sin(half) * part for part in self.axis)
        bw = cos(half)
        return self.origin.xyz, (
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz,
        )


@dataclass(frozen=True)
class Robot:
    """A tree of links; `links` and `joints` are by name, in the order of the file. `root` is the first link's name."""

    name: str
    links: dict[str, Link]
    joints: dict[str, Joint]
    root: str


def unit(vector: Vector) -> Vector:
    """Return the vector with length 1. Raises ZeroDivisionError for the zero vector."""
    length = hypot(*vector)
    return tuple(part / length for part in vector)
