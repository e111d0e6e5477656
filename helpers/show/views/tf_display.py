"""The display of the frames themselves: axes, names, lines to the parents, trails."""

import math
from collections import deque
from time import monotonic

import numpy as np

from helpers.show.views.display import Display
from helpers.show.views.frame_tree import FrameListener, Tree
from helpers.show.views.scene import part
from helpers.show.views.shapes import DARK, Arrow, Axes, Label, Line

MOVES, STATIC = (0.85, 0.47, 0.02), (0.48, 0.53, 0.6)  # colours of the links
_STATIC_NAME = (0.33, 0.38, 0.46)
_TRAIL = ((0.56, 0.27, 0.68), (0.0, 0.52, 0.53), (0.75, 0.15, 0.35), (0.45, 0.5, 0.1))  # not the links' colours
_LOOK = 1.0  # s between two looks for a /clock
_TRAIL_STEP = 0.002  # m between two points of a trail


class TF(Display):
    """Every frame with its axes and name, and a line with an arrow head from it to its parent.

    Names of moving frames are bold and their lines solid; static ones are grey and dashed. A moving frame that is not
    broadcast any more fades after a third of `frame_timeout`, and is gone after all of it. Where somebody publishes
    /clock, it is simulated time that counts: while that stands still, nothing fades.

    :param frame_timeout: seconds.
    :param axis_length: in m; None: from the distances between the frames.
    :param trails: frames that leave a line behind.
    :param on_top: nothing hides the frames.
    """

    def __init__(self, frame_timeout: float = 10.0, axis_length: float | None = None, trails=(), on_top: bool = False):
        super().__init__()
        self.frame_timeout, self.axis_length, self.trails = frame_timeout, axis_length, tuple(trails)
        self.on_top = on_top
        self.tree = Tree({})
        self.poses: dict[str, np.ndarray] = {}
        self.listener: FrameListener | None = None
        self._drawn: dict[str, tuple] = {}  # frame -> how it is drawn
        self._lines: dict[bool, tuple] = {}
        self._paths: dict[str, deque] = {}
        self._length = 0.0
        self._simulated, self._looked = False, -math.inf  # whether there is a /clock, and when that was found out
        self._now = 0.0

    def on_start(self) -> None:
        self.listener = FrameListener(self.buffer, self.node)

    def stop(self) -> None:
        if self.node is not None:
            self.listener.unregister()
        super().stop()

    def look(self) -> None:
        """Find out which frames there are now."""
        now = monotonic()
        if now - self._looked > _LOOK:
            self._looked, self._simulated = now, self.node.count_publishers('/clock') > 0
        links = dict(self.listener.links)
        stamps = [link.stamp for link in links.values() if not link.static]
        self._now = max(stamps, default=0) if self._simulated else now
        alive = {child: link for child, link in links.items() if link.static or self._age(link) < self.frame_timeout}
        self.tree = Tree(alive)
        # Static frames below a frame that has disappeared disappear with it.
        for root, members in list(self.tree.trees.items()):
            if root in links and all(alive[frame].static for frame in members[1:]):
                alive = {child: link for child, link in alive.items() if child not in members}
        if len(alive) < len(self.tree.links):
            self.tree = Tree(alive)

    def _age(self, link) -> float:
        """Seconds since the last transform of a moving frame."""
        return (self._now - link.stamp) / 1e9 if self._simulated else self._now - link.arrival

    def update(self, fixed_frame, time) -> None:
        past = time.nanoseconds != 0
        self.poses = self.tree.poses_at(fixed_frame, self.buffer, time) if past else self.tree.poses(fixed_frame)
        problems = self.tree.problems(fixed_frame)
        members = self.tree.trees.get(self.tree.root_of(fixed_frame), ())
        missing = [frame for frame in members if frame not in self.poses]
        if missing:
            problems.append(f'not known at this time: {", ".join(missing[:4])}{" …" if len(missing) > 4 else ""}')
        self.problem = '\n'.join(problems)
        self._choose_length()
        for frame in self._drawn.keys() - self.poses.keys():
            del self._drawn[frame]
            self.scene.delete(f'frames/{part(frame)}')
            self.scene.delete(f'arrows/{part(frame)}')
        for frame, pose in self.poses.items():
            self._draw(frame, pose, past)
        self._draw_lines()
        if not past:
            self._draw_trails()

    def _choose_length(self) -> None:
        """Choose the length of the axes from the size of all and the lengths of the links; it changes in steps only."""
        if self.axis_length is not None:
            self._length = self.axis_length
            return
        if len(self.poses) < 2:
            self._length = self._length or 0.2
            return
        places = np.array([pose[:3, 3] for pose in self.poses.values()])
        extent = float(np.linalg.norm(places.max(axis=0) - places.min(axis=0)))
        distances = [
            float(np.linalg.norm(pose[:3, 3] - self.poses[self.tree.links[frame].parent][:3, 3]))
            for frame, pose in self.poses.items()
            if frame in self.tree.links and self.tree.links[frame].parent in self.poses
        ]
        apart = [distance for distance in distances if distance > 1e-6]
        if not apart:
            self._length = self._length or 0.2
            return
        wanted = min(max(0.45 * float(np.median(apart)), 0.04 * extent), 0.2 * extent)
        if not 0.6 < wanted / (self._length or math.inf) < 1.7:
            power = 10 ** math.floor(math.log10(wanted))
            self._length = min((step * power for step in (1, 1.5, 2, 3, 5, 7, 10)), key=lambda v: abs(v - wanted))

    def _draw(self, frame: str, pose, past: bool) -> None:
        link = self.tree.links.get(frame)
        static = link is not None and link.static
        path = f'frames/{part(frame)}'
        self.scene.pose(path, pose)
        look = (self._length, static)
        if self._drawn.get(frame) != look:
            self._drawn[frame] = look
            self.scene.set(f'{path}/axes', Axes(self._length, self.on_top))
            self.scene.set(f'{path}/name', Label(frame, None, _STATIC_NAME if static else DARK, not static))
        opacity = 1.0 if past or link is None or static else self._freshness(link)
        self.scene.appearance(path, opacity=opacity)
        if link is not None:
            self._draw_arrow(frame, pose, self.poses.get(link.parent), static, opacity)

    def _freshness(self, link) -> float:
        """1 for a frame that was just heard of, less for a stale one; in coarse steps, as each is sent."""
        third = self.frame_timeout / 3
        age = self._age(link)
        return 1.0 if age < third else round(max(0.15, 0.6 * (3 * third - age) / (2 * third)), 1)

    def _draw_arrow(self, frame, pose, parent, static, opacity) -> None:
        """The head on the line, which points to the parent."""
        path = f'arrows/{part(frame)}'
        way = None if parent is None else parent[:3, 3] - pose[:3, 3]
        distance = 0.0 if way is None else math.sqrt(way @ way)
        if distance < 0.3 * self._length:
            self.scene.delete(path)
            return
        size = round(min(0.3 * self._length, 0.3 * distance), 3 - math.floor(math.log10(self._length)))
        self.scene.set(path, Arrow(size, size / 5.5, STATIC if static else MOVES, head=size, on_top=self.on_top))
        x = way / distance
        helper = np.array((0.0, 0.0, 1.0)) if abs(x[2]) < 0.9 else np.array((0.0, 1.0, 0.0))
        y = _cross(helper, x)
        y /= math.sqrt(y @ y)
        matrix = np.eye(4)
        matrix[:3, 0], matrix[:3, 1], matrix[:3, 2] = x, y, _cross(x, y)
        matrix[:3, 3] = pose[:3, 3] + 0.5 * way - 0.5 * size * x
        self.scene.pose(path, matrix)
        self.scene.appearance(path, opacity=opacity)

    def _draw_lines(self) -> None:
        """All lines to the parents: one shape for those that move, one for the static ones."""
        for static, colour in ((False, MOVES), (True, STATIC)):
            ends = [
                place
                for frame, pose in self.poses.items()
                if (link := self.tree.links.get(frame)) is not None
                and link.static == static
                and link.parent in self.poses
                for place in (pose[:3, 3], self.poses[link.parent][:3, 3])
            ]
            points = np.array(ends, dtype=np.float32).reshape(-1, 3)
            if self._lines.get(static) != points.tobytes():
                self._lines[static] = points.tobytes()
                name = 'links/static' if static else 'links/moving'
                self.scene.set(
                    name, Line(points, colour, 2.0 if static else 2.5, pieces=True, dashed=static, on_top=self.on_top)
                )

    def _draw_trails(self) -> None:
        for number, frame in enumerate(self.trails):
            if frame not in self.poses:
                continue
            trail = self._paths.setdefault(frame, deque(maxlen=1000))
            place = self.poses[frame][:3, 3]
            if trail and np.abs(trail[-1] - place).max() < _TRAIL_STEP:
                continue
            trail.append(place.copy())
            self.scene.set(f'trails/{part(frame)}', Line(np.array(trail), _TRAIL[number % len(_TRAIL)], 2.0))

    def forget_trails(self) -> None:
        """Begin the trails anew, as after a change of the fixed frame."""
        self._paths.clear()
        self.scene.delete('trails')


def _cross(a, b):
    """`numpy.cross` for two vectors, which takes ten times as long."""
    return np.array((a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]))
