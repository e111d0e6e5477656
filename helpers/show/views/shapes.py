"""What a scene can show. Each shape is drawn in the coordinates of its node; `Scene.pose` places the node.

Colours are (red, green, blue), 0 to 1. Arrays are anything that numpy takes; they are kept as float32. Do not change
an array after it has been given: set a new shape. Two shapes without arrays that have equal fields are equal, and to
set an equal shape again costs nothing.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

Colour = tuple[float, float, float]

RED, GREEN, BLUE = (0.86, 0.15, 0.18), (0.13, 0.62, 0.22), (0.13, 0.36, 0.86)  # of the x, y and z axis
DARK, GREY, LIGHT = (0.13, 0.15, 0.2), (0.55, 0.58, 0.63), (0.8, 0.82, 0.86)


class Shape:
    """Base of all shapes."""

    arrays: ClassVar[dict[str, int]] = {}  #: fields that are arrays with this many columns


class _ArrayShape(Shape):
    """A shape whose fields named in `arrays` are N x columns float32, or (colours only) one row for all."""

    def __post_init__(self):
        for name, columns in self.arrays.items():
            value = getattr(self, name)
            kind = np.uint32 if name == 'faces' else np.float32
            array = np.ascontiguousarray(value, dtype=kind)
            if array.size == 0:
                array = array.reshape(0, columns)
            if name == 'colours' and array.shape == (columns,):
                array = array.reshape(1, columns)
            if array.ndim != 2 or array.shape[1] != columns:
                raise ValueError(f'{type(self).__name__}: {name} must be N x {columns}, not {array.shape}')
            object.__setattr__(self, name, array)

    def _check_colours(self, count: int) -> None:
        if len(self.colours) not in (1, count):
            raise ValueError(f'{type(self).__name__}: colours must be one, or {count}, not {len(self.colours)}')


@dataclass(frozen=True)
class Axes(Shape):
    """A coordinate frame: x red, y green, z blue.

    :param length: of each axis in m.
    :param on_top: nothing hides it, as with a frame inside of a robot.
    """

    length: float = 0.2
    on_top: bool = False


@dataclass(frozen=True)
class Arrow(Shape):
    """An arrow along +x from the origin.

    :param length: of the whole arrow in m.
    :param radius: of the shaft in m; the head is twice as wide. None: a twentieth of the length.
    :param head: length of the head in m, up to the whole length. None: six radii, but at most half of the length.
    :param on_top: nothing hides it.
    """

    length: float = 1.0
    radius: float | None = None
    colour: Colour = RED
    head: float | None = None
    on_top: bool = False

    @property
    def sizes(self) -> tuple[float, float]:
        """Radius of the shaft and length of the head."""
        radius = self.length / 20 if self.radius is None else self.radius
        head = min(6 * radius, 0.5 * self.length) if self.head is None else min(self.head, self.length)
        return radius, head


@dataclass(frozen=True)
class Box(Shape):
    """A box around the origin.

    :param size: along x, y, z in m.
    """

    size: tuple[float, float, float] = (1.0, 1.0, 1.0)
    colour: Colour = GREY


@dataclass(frozen=True)
class Cylinder(Shape):
    """A cylinder around the origin, its axis along z (as in a URDF)."""

    radius: float = 0.5
    length: float = 1.0
    colour: Colour = GREY


@dataclass(frozen=True)
class Sphere(Shape):
    """A sphere around the origin."""

    radius: float = 0.5
    colour: Colour = GREY


@dataclass(frozen=True, eq=False)
class Mesh(_ArrayShape):
    """Triangles, seen from both sides.

    :param vertices: N x 3, m.
    :param faces: M x 3 indices of vertices.
    """

    arrays: ClassVar = {'vertices': 3, 'faces': 3}
    vertices: np.ndarray
    faces: np.ndarray
    colour: Colour = GREY


@dataclass(frozen=True, eq=False)
class Line(_ArrayShape):
    """A line through points, or many separate pieces.

    :param points: N x 3, m.
    :param colours: one colour, or N x 3.
    :param width: in pixels of the screen.
    :param pieces: points 0-1, 2-3, 4-5 … are separate lines; N is even.
    :param dashed: interrupted.
    :param on_top: nothing hides it.
    """

    arrays: ClassVar = {'points': 3, 'colours': 3}
    points: np.ndarray
    colours: np.ndarray = DARK
    width: float = 2.0
    pieces: bool = False
    dashed: bool = False
    on_top: bool = False

    def __post_init__(self):
        super().__post_init__()
        self._check_colours(len(self.points))
        if self.pieces and len(self.points) % 2:
            raise ValueError(f'Line: pieces need an even number of points, not {len(self.points)}')


@dataclass(frozen=True, eq=False)
class Points(_ArrayShape):
    """A cloud of points.

    :param points: N x 3, m.
    :param colours: one colour, or N x 3.
    :param size: of a point in m.
    """

    arrays: ClassVar = {'points': 3, 'colours': 3}
    points: np.ndarray
    colours: np.ndarray = RED
    size: float = 0.03

    def __post_init__(self):
        super().__post_init__()
        self._check_colours(len(self.points))


@dataclass(frozen=True)
class Label(Shape):
    """A text at the origin of its node that always faces the viewer; nothing hides it.

    :param height: of a capital letter in m; None: the same readable size at any distance.
    """

    text: str = ''
    height: float | None = None
    colour: Colour = DARK
    bold: bool = False
