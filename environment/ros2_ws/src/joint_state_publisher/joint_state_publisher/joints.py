"""Which joints a robot has, where each one is, and how they move: without ROS."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi

from urdf_reader import Joint, Mimic, Robot


@dataclass
class FreeJoint:
    """A joint that goes where it is told: position in radians or metres, None where none is published."""

    lower: float
    upper: float
    continuous: bool
    position: float | None = None
    velocity: float | None = None
    effort: float | None = None
    forward: bool = True

    def move(self, step: float) -> None:
        """Move on by a step; turn round at a limit, or begin again if there is none."""
        if self.position is None:
            return
        self.position += step if self.forward else -step
        if self.position > self.upper and self.continuous:
            self.position = self.lower
        elif not self.lower <= self.position <= self.upper:
            self.position = min(max(self.position, self.lower), self.upper)
            self.forward = not self.forward


@dataclass(frozen=True)
class Options:
    """What the node's parameters say; see :class:`joint_state_publisher.node.JointStatePublisher`."""

    positions: bool = True
    velocities: bool = False
    efforts: bool = False
    mimic_tags: bool = True
    smallest_limits: bool = True
    zeros: Mapping[str, float] | None = None
    dependent: Mapping[str, Mimic] | None = None


class Joints:
    """
    The joints of a robot that move, in the order of its description.

    :raises ValueError: joints that follow each other in a circle, or one that follows a joint that does not move.
    """

    def __init__(self, robot: Robot, options: Options):
        self.names: list[str] = []
        self.free: dict[str, FreeJoint] = {}
        self._followers: dict[str, Mimic] = dict(options.dependent or {})
        for name, joint in robot.joints.items():
            if not joint.moves:
                continue
            self.names.append(name)
            if options.mimic_tags and joint.mimic:
                self._followers[name] = joint.mimic
            elif name not in self._followers:
                self.free[name] = _free(joint, options)
        self._leaders = {name: self._leader(name) for name in self.names}

    def _leader(self, name: str) -> tuple[FreeJoint, float, float]:
        """The free joint that a joint follows, through others if need be, with factor and offset."""
        seen, factor, offset = [name], 1.0, 0.0
        while name in self._followers:
            mimic = self._followers[name]
            offset += factor * mimic.offset
            factor *= mimic.multiplier
            name = mimic.joint
            if name in seen:
                raise ValueError(f'these joints mimic each other in a circle: {", ".join([*seen, name])}')
            seen.append(name)
        if name not in self.free:
            raise ValueError(f'the joint {seen[0]!r} mimics {name!r}, which does not move')
        return self.free[name], factor, offset

    def move(self, step: float) -> None:
        """Move all free joints on by a step."""
        for joint in self.free.values():
            joint.move(step)

    def state(self) -> tuple[list[float], list[float], list[float]]:
        """Return positions, velocities and efforts by :attr:`names`; a list is empty if no joint has such a value."""
        leaders = [self._leaders[name] for name in self.names]
        return (
            _values([None if j.position is None else j.position * factor + offset for j, factor, offset in leaders]),
            _values([None if j.velocity is None else j.velocity * factor for j, factor, _ in leaders]),
            _values([j.effort for j, _, _ in leaders]),
        )


def _values(values: list[float | None]) -> list[float]:
    return [float(value or 0.0) for value in values] if any(value is not None for value in values) else []


def _free(joint: Joint, options: Options) -> FreeJoint:
    lower, upper = (-pi, pi) if joint.type == 'continuous' else (joint.limit.lower, joint.limit.upper)
    if options.smallest_limits:
        soft_lower, soft_upper = joint.soft_limits
        lower = lower if soft_lower is None else max(lower, soft_lower)
        upper = upper if soft_upper is None else min(upper, soft_upper)
    middle = (lower + upper) / 2 if lower > 0 or upper < 0 else 0.0
    return FreeJoint(
        lower,
        upper,
        joint.type == 'continuous',
        position=(options.zeros or {}).get(joint.name, middle) if options.positions else None,
        velocity=0.0 if options.velocities else None,
        effort=0.0 if options.efforts else None,
    )
