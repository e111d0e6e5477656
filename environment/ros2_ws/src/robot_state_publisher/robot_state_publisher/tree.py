"""The transforms of a robot's links, without ROS: from positions of joints to poses of links."""

from collections.abc import Mapping
from dataclasses import dataclass

from urdf_reader import Joint, Robot
from urdf_reader.model import Quaternion, Vector


@dataclass(frozen=True)
class Transform:
    """A link's pose in its parent's frame: metres, and a quaternion x, y, z, w with w >= 0."""

    parent: str
    child: str
    translation: Vector
    rotation: Quaternion


class Tree:
    """
    The joints of a robot, told apart as stock does.

    Joints of one number move. A fixed joint, and a planar one, for which stock has no position either, are fixed.
    A floating joint has no transform at all: somebody else must publish it.
    """

    def __init__(self, robot: Robot):
        self._moving = {name: joint for name, joint in robot.joints.items() if joint.moves}
        self._fixed = [joint for joint in robot.joints.values() if joint.type in ('fixed', 'planar')]
        self._mimics = {name: joint.mimic for name, joint in sorted(robot.joints.items()) if joint.mimic}

    def fixed(self) -> list[Transform]:
        """Return the transforms that never change."""
        return [_transform(joint, 0.0) for joint in self._fixed]

    def moving(self, positions: Mapping[str, float]) -> list[Transform]:
        """
        Return the transforms of the joints that are named, and of those that mimic them.

        :param positions: of joints by name, in radians or metres; names that the robot does not have are ignored.
        """
        known = dict(positions)
        for name, mimic in self._mimics.items():
            if mimic.joint in known:  # a position that was given for the mimic itself stands
                known.setdefault(name, known[mimic.joint] * mimic.multiplier + mimic.offset)
        return [_transform(self._moving[name], known[name]) for name in sorted(known) if name in self._moving]


def _transform(joint: Joint, position: float) -> Transform:
    translation, rotation = joint.transform(position)
    if rotation[3] < 0:
        rotation = tuple(-part for part in rotation)
    return Transform(joint.parent, joint.child, translation, rotation)
