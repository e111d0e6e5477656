"""tf for tests: what the learner's program broadcasts, and what it is told, at exact simulated stamps.

Matrices are 4x4 numpy arrays. They take points of the child (source) frame into the parent (target) frame, so
`matrix('map', 'laser') @ (1, 0, 0, 1)` is where a point 1 m ahead of the laser is in the map.
"""

import numpy as np
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_py import BufferCore, TransformException
from tf_transformations import compose_matrix, quaternion_from_matrix, quaternion_matrix

from helpers.runner.peers import SECOND, Peer

MOVING_QOS = QoSProfile(depth=100)
STATIC_QOS = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_HISTORY = Duration(seconds=10_000)  # a test never waits until something is forgotten


def pose(
    x: float = 0.0, y: float = 0.0, z: float = 0.0, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0
) -> np.ndarray:
    """The matrix of a frame at x, y, z (metres) in its parent, turned by roll, pitch and yaw (radians)."""
    return compose_matrix(translate=(x, y, z), angles=(roll, pitch, yaw))


def to_message(parent: str, child: str, matrix: np.ndarray, seconds: float = 0.0) -> TransformStamped:
    """The transform with this matrix and stamp (seconds)."""
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = Time(nanoseconds=round(seconds * SECOND)).to_msg()
    for name, value in zip('xyz', matrix[:3, 3], strict=True):
        setattr(message.transform.translation, name, float(value))
    for name, value in zip('xyzw', quaternion_from_matrix(matrix), strict=True):
        setattr(message.transform.rotation, name, float(value))
    return message


def to_matrix(message: TransformStamped) -> np.ndarray:
    """The matrix of a transform."""
    place, turn = message.transform.translation, message.transform.rotation
    matrix = quaternion_matrix((turn.x, turn.y, turn.z, turn.w))
    matrix[:3, 3] = place.x, place.y, place.z
    return matrix


class Broadcaster:
    """The test's side of `/tf` and `/tf_static`, for programs that listen: `learner.tf_broadcaster()`."""

    def __init__(self, learner):
        self._learner = learner
        self._moving = learner.talk('/tf', TFMessage, MOVING_QOS)
        self._static = learner.talk('/tf_static', TFMessage, STATIC_QOS)

    def send(self, parent: str, child: str, matrix: np.ndarray, seconds: float | None = None) -> None:
        """Send a transform on `/tf`; stamped now, or as given (simulated seconds)."""
        seconds = self._learner.now / SECOND if seconds is None else seconds
        self._moving.send(TFMessage(transforms=[to_message(parent, child, matrix, seconds)]))

    def fix(self, parent: str, child: str, matrix: np.ndarray) -> None:
        """Send a transform on `/tf_static`."""
        self._static.send(TFMessage(transforms=[to_message(parent, child, matrix)]))


class Listener(Peer):
    """Records what the learner's program broadcasts: `learner.tf_listener()`. One made late gets what is latched.

    `moving` and `static` are the recordings of `/tf` and `/tf_static`.
    """

    def __init__(self, learner):
        self._learner = learner
        self.moving = learner.listen('/tf', TFMessage, MOVING_QOS)
        self.static = learner.listen('/tf_static', TFMessage, STATIC_QOS)
        self.moving.optional = self.static.optional = True  # most programs publish on one of them only

    def hints(self) -> list[str]:
        """Whether the learner's program broadcasts at all."""
        topics = [topic for topic in ('/tf', '/tf_static') if self._learner.endpoints(topic).publishers]
        return [] if topics else ['Your program has no publisher on /tf or /tf_static.']

    @property
    def transforms(self) -> list[TransformStamped]:
        """All that came on `/tf`, in order."""
        return [transform for message in self.moving.messages for transform in message.transforms]

    @property
    def static_transforms(self) -> dict[str, TransformStamped]:
        """The newest of each child frame that came on `/tf_static`."""
        return {
            transform.child_frame_id: transform for message in self.static.messages for transform in message.transforms
        }

    @property
    def buffer(self) -> BufferCore:
        """A buffer with all that has come so far."""
        buffer = BufferCore(_HISTORY)
        for transform in self.transforms:
            buffer.set_transform(transform, 'learner')
        for transform in self.static_transforms.values():
            buffer.set_transform_static(transform, 'learner')
        return buffer

    def matrix(self, target: str, source: str, seconds: float = 0.0) -> np.ndarray | None:
        """Where `source` is in `target` at a time (simulated seconds; 0: the newest); None if tf2 cannot tell."""
        try:
            return to_matrix(
                self.buffer.lookup_transform_core(target, source, Time(nanoseconds=round(seconds * SECOND)))
            )
        except TransformException:
            return None
