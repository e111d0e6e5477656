"""The frames that are broadcast: a listener that fills a tf2 buffer, and notes what a buffer does not report.

That is: who is whose parent now, when each transform last arrived, which ones are static, and what is wrong with the
tree (two parents, a loop, separate trees).
"""

from collections import deque
from dataclasses import dataclass, field
from time import monotonic

import numpy as np
from rclpy.time import Time
from tf2_ros import TransformException, TransformListener

from helpers.show.views import poses

_RIVALS = 1.0  # s: a frame that had two parents within this time has two broadcasters
_HELD = 20_000  # messages that are kept for the buffer during time travel
_JUMP = 1_000_000_000  # ns: stamps that go back by more mean that a simulation was started again


@dataclass
class FrameLink:
    """The latest transform of one child frame."""

    child: str
    parent: str
    static: bool
    stamp: int = 0  #: of the message, ns
    arrival: float = 0.0  #: `time.monotonic()`
    count: int = 0  #: messages so far
    values: tuple = ()  #: translation, quaternion
    parents: dict[str, float] = field(default_factory=dict)  #: all parents so far -> last arrival
    _matrix: np.ndarray | None = None

    @property
    def matrix(self) -> np.ndarray:
        """The pose of the child in the parent, 4 x 4."""
        if self._matrix is None:
            self._matrix = poses.matrix(*self.values)
        return self._matrix

    @property
    def rivals(self) -> list[str]:
        """The parents that it has at the same time, if there are several."""
        recent = [parent for parent, at in self.parents.items() if self.arrival - at < _RIVALS]
        return sorted(recent) if len(recent) > 1 else []


class FrameListener(TransformListener):
    """A TransformListener that also keeps `links`. For time travel it can keep new messages out of the buffer."""

    def __init__(self, buffer, node, **options):
        self.links: dict[str, FrameLink] = {}
        self._held: deque | None = None
        super().__init__(buffer, node, **options)

    def callback(self, data) -> None:
        """Take what came on /tf."""
        self._note(data, False)
        if self._held is None:
            super().callback(data)
        else:
            self._held.append((data, False))

    def static_callback(self, data) -> None:
        """Take what came on /tf_static."""
        self._note(data, True)
        if self._held is None:
            super().static_callback(data)
        else:
            self._held.append((data, True))

    def hold(self, still: bool) -> None:
        """Keep what comes away from the buffer, so that the past in it stays; or let it all in."""
        if still and self._held is None:
            self._held = deque(maxlen=_HELD)
        elif not still and self._held is not None:
            held, self._held = self._held, None
            for data, static in held:
                super().static_callback(data) if static else super().callback(data)

    def _jumped_back(self, data) -> bool:
        for message in data.transforms:
            link = self.links.get(message.child_frame_id)
            stamp = message.header.stamp
            if (
                link is not None
                and not link.static
                and not link.rivals
                and stamp.sec > 0
                and stamp.sec * 1_000_000_000 + stamp.nanosec < link.stamp - _JUMP
            ):
                return True
        return False

    @property
    def latest(self) -> int:
        """The latest stamp of all moving frames in the buffer, in ns; 0 if nothing moves."""
        links = [link for link in self.links.values() if not link.static]
        if self._held is None:
            return max((link.stamp for link in links), default=0)
        return self._latest_in_buffer(links)

    def _latest_in_buffer(self, links) -> int:
        stamps = [0]
        for link in links:
            try:
                stamps.append(self.buffer.get_latest_common_time(link.parent, link.child).nanoseconds)
            except TransformException:
                pass
        return max(stamps)

    def _note(self, data, static: bool) -> None:
        now = monotonic()
        if not static and self._jumped_back(data):
            self.buffer.clear()
        for message in data.transforms:
            header, transform = message.header, message.transform
            child, parent = message.child_frame_id.removeprefix('/'), header.frame_id.removeprefix('/')
            if not child or not parent or child == parent:
                continue  # the buffer refuses it, and logs that
            t, q = transform.translation, transform.rotation
            values = ((t.x, t.y, t.z), (q.x, q.y, q.z, q.w))
            link = self.links.get(child)
            if link is None:
                link = self.links[child] = FrameLink(child, parent, static)
            if link.values != values:
                link.values, link._matrix = values, None
            link.parent, link.static, link.arrival = parent, static, now
            link.stamp = header.stamp.sec * 1_000_000_000 + header.stamp.nanosec
            link.parents[parent] = now
            link.count += 1


class Tree:
    """How the frames hang together at one moment.

    :param links: child -> FrameLink; those that are to count.
    """

    def __init__(self, links: dict[str, FrameLink]):
        self.links = links
        children: dict[str, list[str]] = {}
        for child, link in links.items():
            children.setdefault(link.parent, []).append(child)
        self.roots = [parent for parent in children if parent not in links]
        self.trees: dict[str, list[str]] = {}  #: root -> all its frames, parents before children
        for root in self.roots:
            members = [root]
            for frame in members:
                members += children.get(frame, ())
            self.trees[root] = members
        placed = {frame for members in self.trees.values() for frame in members}
        self.looped = [child for child in links if child not in placed]  #: frames in a loop, or below one

    @property
    def frames(self) -> list[str]:
        """All frames."""
        return [*(frame for members in self.trees.values() for frame in members), *self.looped]

    def root_of(self, frame: str) -> str | None:
        """Return the root of the frame's tree; None if it is unknown or in a loop."""
        return next((root for root, members in self.trees.items() if frame in members), None)

    def best_root(self) -> str:
        """Return the root of the largest tree; '' without a tree. Of equal ones map, odom and world come first."""
        usual = ('map', 'odom', 'world')
        return max(self.roots, default='', key=lambda root: (len(self.trees[root]), root in usual))

    def poses(self, fixed_frame: str) -> dict[str, np.ndarray]:
        """Return the pose of each frame of the fixed frame's tree in the fixed frame, by the latest transforms."""
        root = self.root_of(fixed_frame)
        if root is None:
            return {}
        found = {root: np.eye(4)}
        for frame in self.trees[root][1:]:
            link = self.links[frame]
            found[frame] = found[link.parent] @ link.matrix
        if fixed_frame != root:
            back = np.linalg.inv(found[fixed_frame])
            found = {frame: back @ pose for frame, pose in found.items()}
        return found

    def poses_at(self, fixed_frame: str, buffer, when: Time) -> dict[str, np.ndarray]:
        """Return the poses at a time in the past; without those that the buffer does not know at that time."""
        found = {}
        for frame in self.trees.get(self.root_of(fixed_frame), ()):
            try:
                found[frame] = poses.from_transform(buffer.lookup_transform_core(fixed_frame, frame, when))
            except TransformException:
                pass
        return found

    def problems(self, fixed_frame: str) -> list[str]:
        """Say what is wrong with the tree, seen from the fixed frame."""
        found = [
            f'[{link.child}] has several parents: {_names(link.rivals)}' for link in self.links.values() if link.rivals
        ]
        if self.looped:
            found.append(f'a loop: {" → ".join(self._loop())}')
        if fixed_frame and fixed_frame not in self.frames:
            found.append(f'tf2 knows no frame [{fixed_frame}]: only what stands in it can be shown')
        elif self.root_of(fixed_frame) is not None:
            found += [
                f'no transform from {_names(members)} to [{fixed_frame}]: separate trees'
                for root, members in self.trees.items()
                if root != self.root_of(fixed_frame)
            ]
        return found

    def _loop(self) -> list[str]:
        way, frame = [], self.looped[0]
        while frame not in way:
            way.append(frame)
            frame = self.links[frame].parent
        return [*way[way.index(frame) :], frame]


def _names(frames) -> str:
    most = 4
    rest = len(frames) - most
    return ', '.join(f'[{frame}]' for frame in frames[:most]) + (f' and {rest} more' if rest > 0 else '')
