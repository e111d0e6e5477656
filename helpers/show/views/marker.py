"""The displays of markers: shapes that programs send to be seen."""

import time
from dataclasses import dataclass

import numpy as np

from helpers.show.views import meshes, poses
from helpers.show.views.display import no_transform
from helpers.show.views.scene import part
from helpers.show.views.shapes import LIGHT, Arrow, Box, Cylinder, Label, Line, Mesh, Points, Shape, Sphere
from helpers.show.views.topic_display import TopicDisplay

_SINGLE = 200  # cubes or spheres of a list that are drawn as such; more of them are drawn as points


@dataclass
class _Shown:
    """One marker on the screen."""

    message: object
    ends: float | None  # `time.monotonic()`
    problem: str
    pieces: int  # nodes below the marker's
    placed: str | None = None  # the fixed frame that its pose is in


class Marker(TopicDisplay):
    """Markers of one topic (visualization_msgs/Marker): each stays until it is replaced, deleted, or its lifetime ends.

    All types of Jazzy but ARROW_STRIP. Widths of lines are only about those in the message. A marker is placed by the
    transform at its stamp (zero: the latest) when it comes; one with ``frame_locked`` moves with its frame.

    :param topic: name of the topic.
    :param qos: QoS or depth; None: as in RViz, the last 10, reliable.
    """

    def __init__(self, topic: str = '/visualization_marker', qos=None):
        super().__init__(topic, qos)
        self._shown: dict[str, _Shown] = {}

    def message_type(self):
        from visualization_msgs.msg import Marker

        return Marker

    @staticmethod
    def default_qos():
        from rclpy.qos import QoSProfile

        return QoSProfile(depth=10)

    def on_start(self) -> None:
        super().on_start()
        self._shown.clear()

    @property
    def markers(self) -> list[tuple[str, int]]:
        """Namespace and id of the markers that are there."""
        return [(shown.message.ns, shown.message.id) for shown in self._shown.values()]

    def take(self, message) -> None:
        """Do what one message says: add, modify, delete, delete all."""
        path = f'{part(message.ns)}/{message.id}'
        if message.action == message.DELETEALL:
            for other, shown in list(self._shown.items()):
                if message.ns in ('', shown.message.ns):
                    self._delete(other)
        elif message.action == message.DELETE:
            self._delete(path)
        else:
            lifetime = message.lifetime.sec + message.lifetime.nanosec / 1e9
            problem, pieces = self._draw(path, message)
            old = self._shown.get(path)
            for number in range(pieces, old.pieces if old else 0):
                self.scene.delete(f'{path}/{number}')
            self._shown[path] = _Shown(message, time.monotonic() + lifetime if lifetime > 0 else None, problem, pieces)

    def _delete(self, path: str) -> None:
        if self._shown.pop(path, None) is not None:
            self.scene.delete(path)

    def _draw(self, path: str, message) -> tuple[str, int]:
        """Set the shapes of a marker; return what is wrong with it, and the number of its pieces."""
        name = f'marker [{message.ns}/{message.id}]'
        try:
            pieces = list(_pieces(message))
        except ValueError as error:  # of a mesh's file, too
            return f'{name}: {error}', 0
        for number, (shape, pose) in enumerate(pieces):
            self.scene.set(f'{path}/{number}', shape)
            self.scene.pose(f'{path}/{number}', pose)
        alpha = max([message.color.a, *(colour.a for colour in message.colors)])
        self.scene.appearance(path, opacity=message.color.a if message.color.a > 0 else alpha)
        problem = f'{name}: its color has alpha 0, so nobody sees it; set color.a to 1' if alpha <= 0 else ''
        return problem, len(pieces)

    def update(self, fixed_frame, time_) -> None:
        problems = {}
        now = time.monotonic()
        for path, shown in list(self._shown.items()):
            if shown.ends is not None and now >= shown.ends:
                self._delete(path)
                continue
            if shown.problem:
                problems[shown.problem] = None
            if shown.placed != fixed_frame or shown.message.frame_locked:
                problem = self._place(path, shown, fixed_frame, time_)
                if problem:
                    problems[problem] = None
        if not self._shown:
            problems[self.silence()] = None
        self.problem = '\n'.join(filter(None, problems))

    def _place(self, path: str, shown: _Shown, fixed_frame: str, moment) -> str:
        from rclpy.time import Time
        from tf2_ros import TransformException

        message = shown.message
        frame = message.header.frame_id.removeprefix('/')
        when = moment if message.frame_locked else Time.from_msg(message.header.stamp)
        try:
            base = poses.from_transform(self.buffer.lookup_transform_core(fixed_frame, frame, when))
        except TransformException as error:
            self.scene.appearance(path, visible=False)
            shown.placed = None
            late = ' at the time of the marker' if 'extrapolation' in str(error) else ''
            return no_transform(f'[{frame}]', fixed_frame) + late
        self.scene.pose(path, base @ poses.from_pose(message.pose))
        self.scene.appearance(path, visible=True)
        shown.placed = fixed_frame
        return ''


class MarkerArray(Marker):
    """The same for messages with many markers (visualization_msgs/MarkerArray)."""

    def __init__(self, topic: str = '/visualization_marker_array', qos=None):
        super().__init__(topic, qos)

    def message_type(self):
        from visualization_msgs.msg import MarkerArray

        return MarkerArray

    def take(self, message) -> None:
        """Do what each marker of the array says."""
        for marker in message.markers:
            super().take(marker)


_IDENTITY = np.eye(4)


def _pieces(message):
    """Yield the shapes of a marker, each with its pose in the marker's own.

    :raises ValueError: the marker makes no sense; one line.
    """
    colour = (message.color.r, message.color.g, message.color.b)
    scale = (message.scale.x, message.scale.y, message.scale.z)
    points = np.array([(point.x, point.y, point.z) for point in message.points], dtype=np.float32).reshape(-1, 3)
    colours = np.array([(c.r, c.g, c.b) for c in message.colors] or [colour], dtype=np.float32)
    if len(colours) not in (1, len(points)):
        raise ValueError(f'it has {len(points)} points, but {len(colours)} colors')
    if not np.isfinite([*scale, *points.flat]).all():
        raise ValueError('a scale or a point of it is not a finite number')
    kind = message.type
    if kind == message.ARROW:
        yield _arrow(message, points, scale, colour)
    elif kind in (message.CUBE, message.SPHERE, message.CYLINDER):
        _check_scale(scale)
        yield _SOLIDS[kind](colour), np.diag((*scale, 1.0))
    elif kind in (message.LINE_STRIP, message.LINE_LIST):
        _check_scale(scale[:1])
        pieces = kind == message.LINE_LIST
        if pieces and len(points) % 2:
            raise ValueError(f'a LINE_LIST needs an even number of points, not {len(points)}')
        yield Line(points, colours, width=float(np.clip(60 * scale[0], 1.5, 8)), pieces=pieces), _IDENTITY
    elif kind in (message.CUBE_LIST, message.SPHERE_LIST):
        _check_scale(scale)
        if len(points) > _SINGLE:
            yield Points(points, colours, size=float(max(scale))), _IDENTITY
        else:
            solid = _SOLIDS[message.CUBE if kind == message.CUBE_LIST else message.SPHERE]
            for number, point in enumerate(points):
                own = tuple(map(float, colours[number if len(colours) > 1 else 0]))
                yield solid(own), poses.matrix(point) @ np.diag((*scale, 1.0))
    elif kind == message.POINTS:
        _check_scale(scale[:2])
        yield Points(points, colours, size=float(max(scale[:2]))), _IDENTITY
    elif kind == message.TEXT_VIEW_FACING:
        _check_scale(scale[2:])
        yield Label(message.text, height=scale[2], colour=colour), _IDENTITY
    elif kind == message.TRIANGLE_LIST:
        if len(points) % 3 or len(points) == 0:
            raise ValueError(f'a TRIANGLE_LIST needs three points for each triangle, not {len(points)}')
        faces = np.arange(len(points)).reshape(-1, 3)
        yield Mesh(points, faces, tuple(map(float, colours.mean(axis=0)))), np.diag((*scale, 1.0))
    elif kind == message.MESH_RESOURCE:
        _check_scale(scale)
        if not message.mesh_resource:
            raise ValueError('its mesh_resource is empty; it must name a file')
        vertices, faces, own = meshes.load(message.mesh_resource)
        if message.mesh_use_embedded_materials:
            colour = own or LIGHT
        yield Mesh(vertices, faces, colour), np.diag((*scale, 1.0))
    else:
        raise ValueError(f'type {kind} is not shown here')


def _arrow(message, points: np.ndarray, scale, colour) -> tuple[Shape, np.ndarray]:
    """By two points (scale: diameters of shaft and head), or along x (scale: length and diameter)."""
    if len(points) == 0:
        _check_scale(scale[:1])
        return Arrow(scale[0], scale[1] / 2 or None, colour), _IDENTITY
    if len(points) != 2:
        raise ValueError(f'an ARROW has two points or none, not {len(points)}')
    way = (points[1] - points[0]).astype(float)
    length = float(np.linalg.norm(way))
    if length == 0:
        raise ValueError('its two points are the same')
    x = way / length
    y = np.cross((0.0, 0.0, 1.0) if abs(x[2]) < 0.9 else (1.0, 0.0, 0.0), x)
    y /= np.linalg.norm(y)
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = np.column_stack((x, y, np.cross(x, y))), points[0]
    return Arrow(length, scale[0] / 2 or None, colour), pose


def _check_scale(scale) -> None:
    if not all(part > 0 for part in scale):
        raise ValueError(f'its scale is {", ".join(f"{part:g}" for part in scale)}; it must be above 0')


_SOLIDS = {  # by the numbers of visualization_msgs/Marker, of unit size
    1: lambda colour: Box((1.0, 1.0, 1.0), colour),
    2: lambda colour: Sphere(0.5, colour),
    3: lambda colour: Cylinder(0.5, 1.0, colour),
}
