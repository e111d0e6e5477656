"""The still renderer: a scene as a small SVG, without browser or GL.

It is what remains in the saved notebook, in exported HTML, on GitHub and in CI. The projection is orthographic, from
the direction from which the live view looks at first; nearer things are painted over farther ones.
"""

import math
import textwrap
from collections.abc import Iterable, Sequence
from html import escape

import numpy as np

from helpers.show import dark_page
from helpers.show.views.painter import Element, order
from helpers.show.views.scene import Item, Scene
from helpers.show.views.shapes import (
    BLUE,
    DARK,
    GREEN,
    RED,
    Arrow,
    Axes,
    Box,
    Colour,
    Cylinder,
    Label,
    Line,
    Mesh,
    Points,
    Sphere,
)

VIEW_FROM = np.array((0.49, -0.70, 0.53)) / math.sqrt(0.49**2 + 0.70**2 + 0.53**2)  # as in web/viewer.js
_RIGHT = np.cross((0.0, 0.0, 1.0), VIEW_FROM) / np.linalg.norm(np.cross((0.0, 0.0, 1.0), VIEW_FROM))
_UP = np.cross(VIEW_FROM, _RIGHT)
_BRIGHTNESS = np.array((0.3, 0.59, 0.11))  # what red, green and blue add to it
_LIGHT = np.array((0.25, -0.5, 0.83))
_LARGEST = 56_000  # characters; budgets are cut until the picture is smaller
_MARGIN = (34, 46, 40, 70)  # pixels at the top, the left, the bottom and the right that hold names and captions
_BUDGET = 3000  # points of clouds, and faces of meshes
_APART = 4.0  # pixels between two places of an axis that are looked at
_SEEN, _ON_TOP = 1, 2  # layers of the picture: points in front of all faces, and shapes that are `on_top`
_SIDES = 20  # of a cylinder
_HALO = '<g stroke="#fff" stroke-width="3" paint-order="stroke">'  # of texts, which may lie over anything
_FONT = 'system-ui, -apple-system, "Segoe UI", sans-serif'
_PAPER, _BORDER, _GRID, _GREY_TEXT, _PROBLEM = '#f6f8fa', '#cfd3da', '#d5dae1', '#59606e', '#b3261e'


def _hex(colour) -> str:
    return '#' + ''.join(f'{round(255 * min(1.0, max(0.0, float(value)))):02x}' for value in colour)


# On a dark page. The ground is not black, so that dark wheels can be seen on it.
DARK_COLOURS = {
    _PAPER: '#2a3038',
    _BORDER: '#4a515c',
    _GRID: '#434b56',
    '#fff': '#2a3038',  # around texts
    _GREY_TEXT: '#dde2e8',
    _PROBLEM: '#ff9d93',
    _hex(DARK): '#e6e9ee',
    _hex(RED): '#ff7478',
    _hex(GREEN): '#4cc766',
    _hex(BLUE): '#7ea6ff',
}


def dark_colours(names: Iterable[Colour], marks: Iterable[Colour] = ()) -> dict[str, str]:
    """What the colours of a picture become on a dark page.

    :param names: of texts; a dark one becomes nearly white.
    :param marks: of points and thin lines; a dark one becomes lighter.
    """
    lighter = {}
    for colours, limit, least in ((marks, 0.35, 0.45), (names, 0.5, 0.8)):
        for colour in map(np.array, colours):
            if colour @ _BRIGHTNESS < limit:
                lighter[_hex(colour)] = _hex(least + (1 - least) * colour)
    return lighter | DARK_COLOURS


def svg(
    scene: Scene,
    caption: str = '',
    problems: Sequence[str] = (),
    legend: Sequence[tuple[str, Colour, bool]] = (),
    around: tuple[np.ndarray, float] | None = None,
    width: int = 720,
    height: int = 420,
) -> str:
    """Return the scene as an SVG of less than 60 kB.

    :param caption: a line below the picture.
    :param problems: lines in red above it.
    :param legend: kinds of lines: what, colour, dashed.
    :param around: a point and how much around it to show, in m; None: everything.
    """
    items = scene.items()
    budget = _BUDGET
    while True:
        text = _ScenePicture(items, around, width, height, budget).text(caption, problems, legend)
        if len(text) < _LARGEST or budget < 50:
            return text
        budget = int(budget * min(0.5, 0.9 * _LARGEST / len(text)))


class _ScenePicture:
    def __init__(self, items: list[Item], around, width: int, height: int, budget: int):
        self.items, self.width, self.height, self.budget = items, width, height, budget
        self.finest = 0.8 * _BUDGET / budget  # pixels between two points of a line
        self.parts: list[Element] = []
        self.walls: list[tuple] = []  # faces that hide points: corners, outline, normal
        self.boxes: list[tuple] = []  # the places that names cover
        self.marks: set[tuple] = set()  # the colours of points and lines
        self.beams: list[np.ndarray] = []  # pixels along axes, which names should not cover
        self._fit(around)

    # Projection

    def _fit(self, around) -> None:
        clouds = [points for item in self.items if len(points := _extent(item))]
        self.empty = not clouds
        points = np.vstack(clouds) if clouds else np.array([[-1.0, -1.0, 0.0], [1.0, 1.0, 0.0]])
        if around is not None:
            centre, span = around
            points = centre + 0.5 * span * np.array([_RIGHT, -_RIGHT, _UP, -_UP])
        self.low, self.high = points.min(axis=0), points.max(axis=0)  # where there is ground
        if around is not None:
            self.low, self.high = centre - span, centre + span
        u, v = points @ _RIGHT, points @ _UP
        top, left, bottom, right = _MARGIN
        room = np.array((self.width - left - right, self.height - top - bottom), dtype=float)
        spread = np.array((max(np.ptp(u), 0.05), max(np.ptp(v), 0.05)))
        self.scale = float((room / spread).min())
        self.u0 = (u.max() + u.min()) / 2 - (left + room[0] / 2) / self.scale
        self.v0 = (v.max() + v.min()) / 2 + (top + room[1] / 2) / self.scale

    def flat(self, points: np.ndarray) -> np.ndarray:
        """Project N x 3 points to pixels, N x 2."""
        points = np.asarray(points, dtype=float).reshape(-1, 3)
        return np.column_stack(((points @ _RIGHT - self.u0) * self.scale, (self.v0 - points @ _UP) * self.scale))

    # Elements

    def text(self, caption: str, problems: Sequence[str], legend) -> str:
        body = [self._ground()]
        for item in sorted(self.items, key=lambda item: isinstance(item.shape, Points)):  # last: faces may hide them
            if not isinstance(item.shape, Label):
                first = len(self.parts)
                getattr(self, f'_{type(item.shape).__name__.lower()}')(item)
                if getattr(item.shape, 'on_top', False):
                    for part in self.parts[first:]:
                        part.layer = _ON_TOP
        body += order(self.parts, VIEW_FROM)
        named = [item for item in self.items if isinstance(item.shape, Label) and item.shape.text]
        named.sort(key=lambda item: item.shape.height is None)  # last: names that make room for the others
        body += [_HALO, *map(self._name, named), '</g>']
        lines = [
            f'<text x="12" y="{22 + 17 * number}" fill="{_PROBLEM}">{escape(line)}</text>'
            for number, line in enumerate(
                line for problem in problems for line in textwrap.wrap(problem, int(self.width / 7.2))
            )
        ]
        if self.empty:
            lines.append(
                f'<text x="{self.width / 2:g}" y="{self.height / 2:g}" text-anchor="middle" fill="{_GREY_TEXT}">'
                'no frame so far</text>'
            )
        if not self.empty:
            caption = f'{caption} · grid {self.step:g} m' if caption else f'grid {self.step:g} m'
            marks, free = self._legend(legend)
            x = self._caption_place(caption, free)
            lines.append(f'<text x="{x}" y="{self.height - 12}" fill="{_GREY_TEXT}">{escape(caption)}</text>')
            lines += marks
        drawing = '\n'.join(
            (
                f'<rect width="{self.width}" height="{self.height}" rx="6" fill="{_PAPER}" stroke="{_BORDER}"/>',
                *(part for part in body if part),
                _HALO,
                *lines,
                '</g>',
            )
        )
        colours = dark_colours([item.shape.colour for item in named], self.marks)
        return '\n'.join(
            (
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
                f'viewBox="0 0 {self.width} {self.height}" style="max-width:100%;height:auto" class="scene-picture" '
                f'fill="none" stroke-linecap="round" stroke-linejoin="round" font-family=\'{_FONT}\' font-size="13">',
                f'<style>{dark_page.rules(drawing, colours, ".scene-picture")}</style>',
                drawing,
                '</svg>',
            )
        )

    def _caption_place(self, caption: str, end: float) -> int:
        """Where the line below the picture begins, so that it ends before `end` and covers no name, if it can."""
        long = math.ceil(0.54 * 13 * len(caption))
        row = self.height - 26, self.height - 6
        for x in range(12, int(end) - long, 12):
            if not any(_overlap((x - 6, row[0], x + long + 6, row[1]), other) for other in self.boxes):
                return x
        return 12

    def _legend(self, legend) -> tuple[list[str], float]:
        """What explains the kinds of arrows, and where it begins."""
        x, parts = self.width - 12.0, []
        for what, colour, dashed in reversed(legend):
            x -= 7 * len(what) + 46
            dash = ' stroke-dasharray="5 4" stroke-linecap="butt"' if dashed else ''
            parts.append(
                f'<path d="M{x:.0f} {self.height - 16}h20" stroke="{_hex(colour)}" stroke-width="2.5"{dash}/>'
                f'<text x="{x + 26:.0f}" y="{self.height - 12}" fill="{_GREY_TEXT}">{escape(what)}</text>'
            )
        return parts, x

    def _ground(self) -> str:
        wide = max(*(self.high - self.low)[:2], 0.1)
        power = 10 ** math.floor(math.log10(wide / 4))
        step = next(factor * power for factor in (1, 2, 5, 10, 20) if wide / (factor * power) <= 8)
        self.step = step
        x0, y0 = (math.floor(value / step) - 1 for value in self.low[:2])
        x1, y1 = (math.ceil(value / step) + 1 for value in self.high[:2])
        ends = [(x, y, 0) for x in range(x0, x1 + 1) for y in (y0, y1)]
        ends += [(x, y, 0) for y in range(y0, y1 + 1) for x in (x0, x1)]
        flat = self.flat(np.array(ends, dtype=float) * step)
        path = ''.join(f'M{_pair(a)}L{_pair(b)}' for a, b in zip(flat[::2], flat[1::2], strict=True))
        return f'<path d="{path}" stroke="{_GRID}"/>'

    def _add(self, element: str, opacity: float, points: np.ndarray, normal=None, layer: int = 0) -> None:
        if not len(points):
            return
        flat = self.flat(points)
        self.parts.append(
            Element(
                element if opacity >= 1 else f'<g opacity="{opacity:.2g}">{element}</g>',
                points,
                flat.min(axis=0) - 1,
                flat.max(axis=0) + 1,
                normal,
                layer,
            )
        )

    def _outside(self, flat: np.ndarray) -> bool:
        """Whether all of an element is beside the picture."""
        low, high = flat.min(axis=0), flat.max(axis=0)
        return bool(high[0] < 0 or high[1] < 0 or low[0] > self.width or low[1] > self.height)

    def _stroke(self, ends, colour, width: float, opacity: float, more: str = '') -> None:
        flat = self.flat(ends)
        if self._outside(flat):
            return
        kept = [flat[0]]
        for place in flat[1:]:
            if np.abs(place - kept[-1]).max() >= self.finest:
                kept.append(place)
        if len(kept) < 2:
            kept.append(kept[0])
        path = f'M{_pair(kept[0])}L' + ' '.join(_pair(place) for place in kept[1:])
        self._add(f'<path d="{path}" stroke="{_hex(colour)}" stroke-width="{width:.3g}"{more}/>', opacity, ends)

    def _axes(self, item: Item) -> None:
        origin = item.pose[:3, 3]
        for column, colour in enumerate((RED, GREEN, BLUE)):
            tip = origin + item.shape.length * item.pose[:3, column]
            width = min(4.5, max(2.0, 0.07 * item.shape.length * self.scale))
            self._stroke(np.array((origin, tip)), colour, width, item.opacity)
            self.beams.append(self._along(np.array((origin, tip))))

    def _along(self, ends: np.ndarray) -> np.ndarray:
        """Places along a line between two points, some pixels apart."""
        begin, end = self.flat(ends)
        count = 2 + int(np.linalg.norm(end - begin) / _APART)
        return begin + (end - begin) * np.linspace(0, 1, count)[:, None]

    def _arrow(self, item: Item) -> None:
        shape = item.shape
        radius, head = shape.sizes
        ends = _placed(item.pose, np.array(((0, 0, 0), (shape.length - head, 0, 0), (shape.length, 0, 0)), dtype=float))
        if head < shape.length:
            self._stroke(ends[:2], shape.colour, max(1.2, 2 * radius * self.scale), item.opacity)
        tail, tip = self.flat(ends[1:])
        way = tip - tail
        across = np.array((-way[1], way[0])) / (np.linalg.norm(way) + 1e-9) * max(2.5, 2 * radius * self.scale)
        corners = ' '.join(_pair(place) for place in (tip, tail + across, tail - across))
        self._add(f'<polygon points="{corners}" fill="{_hex(shape.colour)}"/>', item.opacity, ends[1:])

    def _line(self, item: Item) -> None:
        shape = item.shape
        points = _placed(item.pose, shape.points)
        more = ' stroke-dasharray="5 4" stroke-linecap="butt"' if shape.dashed else ''
        several = len(shape.colours) > 1
        if shape.pieces:
            runs = [(i, i + 2) for i in range(0, len(points), 2)]
        else:  # in runs of one colour, and short enough to be hidden where something is nearer
            most = 2 if several else max(2, min(40, len(points) // 12))
            runs = [(i, min(i + most, len(points))) for i in range(0, len(points) - 1, most - 1)]
        self.marks.update(map(tuple, shape.colours))
        for begin, end in runs:
            self._stroke(points[begin:end], shape.colours[begin if several else 0], shape.width, item.opacity, more)

    def _points(self, item: Item) -> None:
        shape = item.shape
        some = _some(len(shape.points), self.budget)
        points = _placed(item.pose, shape.points[some])
        if not len(points):
            return
        flat = self.flat(points)
        if self._outside(flat):
            return
        colours = shape.colours if len(shape.colours) == 1 else shape.colours[some]
        colours = np.broadcast_to(np.round(colours * 6) / 6, points.shape)
        seen = ~self._hidden(points, flat, 1.5 * shape.size)
        groups: dict[tuple, dict] = {}
        for place, colour in zip(np.round(flat[seen]).astype(int).tolist(), colours[seen].tolist(), strict=True):
            groups.setdefault(tuple(colour), {})[tuple(place)] = None
        width = min(6.0, max(1.5, shape.size * self.scale))
        self.marks.update(groups)
        for colour, places in groups.items():
            path = ''.join(f'M{x} {y}h0' for x, y in places)
            self._add(
                f'<path d="{path}" stroke="{_hex(colour)}" stroke-width="{width:.2g}"/>',
                item.opacity,
                points[seen],
                layer=_SEEN,
            )

    def _hidden(self, points: np.ndarray, flat: np.ndarray, near: float) -> np.ndarray:
        """Which points a face hides, from which they are farther away than `near` m."""
        hidden = np.zeros(len(points), dtype=bool)
        for corners, outline, normal in self.walls:
            low, high = outline.min(axis=0), outline.max(axis=0)
            some = np.flatnonzero(~hidden & np.all((flat >= low) & (flat <= high), axis=1))
            if not len(some):
                continue
            ahead = ((corners[0] - points[some]) @ normal) / (VIEW_FROM @ normal)  # how far it is to the face
            sides = np.roll(outline, -1, axis=0) - outline
            to = flat[some][:, None] - outline
            turns = sides[:, 0] * to[..., 1] - sides[:, 1] * to[..., 0]
            inside = np.all(turns >= 0, axis=1) | np.all(turns <= 0, axis=1)
            hidden[some[inside & (ahead > near)]] = True
        return hidden

    def _box(self, item: Item) -> None:
        x, y, z = (0.5 * size for size in item.shape.size)
        corners = np.array([(i, j, k) for i in (-x, x) for j in (-y, y) for k in (-z, z)])
        faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
        self._faces(_placed(item.pose, corners), faces, item.shape.colour, item.opacity)

    def _cylinder(self, item: Item) -> None:
        angles = np.arange(_SIDES) * (2 * math.pi / _SIDES)
        ring = np.column_stack((np.cos(angles), np.sin(angles))) * item.shape.radius
        half = item.shape.length / 2
        corners = np.vstack([np.column_stack((ring, np.full(_SIDES, side))) for side in (-half, half)])
        faces = [(i, (i + 1) % _SIDES, (i + 1) % _SIDES + _SIDES, i + _SIDES) for i in range(_SIDES)]
        faces += [tuple(range(_SIDES - 1, -1, -1)), tuple(range(_SIDES, 2 * _SIDES))]
        self._faces(_placed(item.pose, corners), faces, item.shape.colour, item.opacity)

    def _sphere(self, item: Item) -> None:
        """The outline of a sphere, an ellipse where the pose scales it."""
        centre = item.pose[:3, 3]
        radii = item.shape.radius * item.pose[:3, :3]
        outline = np.vstack((_RIGHT, _UP)) @ radii
        squares, ways = np.linalg.eigh(outline @ outline.T)
        short, long = np.maximum(1.0, np.sqrt(np.maximum(squares, 0)) * self.scale)
        turn = -math.degrees(math.atan2(ways[1, 1], ways[0, 1]))
        x, y = self.flat(centre)[0]
        light = _hex(np.minimum(1.0, np.array(item.shape.colour) * 0.6 + 0.4))
        form = (
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{long:.1f}"'
            if long - short < 0.2
            else f'<ellipse cx="{x:.1f}" cy="{y:.1f}" rx="{long:.1f}" ry="{short:.1f}" '
            f'transform="rotate({turn:.0f} {x:.1f} {y:.1f})"'
        )
        self._add(
            f'{form} fill="{_hex(item.shape.colour)}"/>'
            f'<circle cx="{x - 0.25 * short:.1f}" cy="{y - 0.3 * short:.1f}" r="{0.35 * short:.1f}" '
            f'fill="{light}" opacity=".55"/>',
            item.opacity,
            _extent(item),
        )

    def _mesh(self, item: Item) -> None:
        vertices, faces = _coarser(item.shape.vertices, item.shape.faces, self.budget // 3)
        self._faces(_placed(item.pose, vertices), faces, item.shape.colour, item.opacity, both_sides=True)

    def _faces(self, corners, faces, colour, opacity: float, both_sides: bool = False) -> None:
        """Paint those faces that look at the viewer, brighter the more they look into the light."""
        flat, colour = self.flat(corners), np.array(colour)
        if self._outside(flat):
            return
        for face in faces:
            face = list(face)
            a, b, c = corners[face[:3]]
            normal = np.cross(b - a, c - a)
            size = np.linalg.norm(normal)
            if size == 0:
                continue
            normal /= size
            if normal @ VIEW_FROM <= 0:
                if not both_sides:
                    continue
                normal = -normal
            if opacity >= 1:
                self.walls.append((corners[face], flat[face], normal))
            shade = _hex(np.minimum(1.0, colour * (0.62 + 0.42 * max(0.0, float(normal @ _LIGHT)))))
            path = ' '.join(_pair(place) for place in flat[face])
            self._add(
                f'<polygon points="{path}" fill="{shade}" stroke="{shade}" stroke-width=".5"/>',
                opacity,
                corners[face],
                normal,
            )

    # Names

    def _name(self, item: Item) -> str:
        shape = item.shape
        x, y = self.flat(item.pose[:3, 3])[0]
        if not (0 <= x <= self.width and 0 <= y <= self.height):
            return ''
        size = 13.0 if shape.height is None else min(60.0, max(4.0, 1.4 * shape.height * self.scale))
        long, tall = (0.58 if shape.bold else 0.54) * size * len(shape.text), 1.15 * size
        if shape.height is not None:  # a label with a height of its own is not moved
            left, middle, line = x - long / 2, y, ''
            self.boxes.append((left, middle - tall / 2, left + long, middle + tall / 2))
        else:
            place = self._free_place(x, y, long, tall)
            if place is None:
                return ''
            left, middle = place
            line = ''
            if abs(middle - y) > tall:
                end = left - 2 if left > x else left + long + 2
                line = (
                    f'<path d="M{x:.0f} {y:.0f}L{end:.0f} {middle:.0f}" stroke="{_hex(shape.colour)}" '
                    'stroke-width=".7"/>'
                )  # of its own colour, not of the names' border
        weight = ' font-weight="600"' if shape.bold else ''
        opacity = f' opacity="{item.opacity:.2g}"' if item.opacity < 1 else ''
        big = '' if shape.height is None else f' font-size="{size:.3g}"'
        return (
            f'{line}<text x="{left:.0f}" y="{middle + 0.35 * size:.0f}"{big}{weight}{opacity} '
            f'fill="{_hex(shape.colour)}">{escape(shape.text)}</text>'
        )

    def _free_place(self, x: float, y: float, long: float, tall: float) -> tuple[float, float] | None:
        """The place near (x, y) that covers other names least, then axes: left end and middle of the text.

        None if there is no room without other names.
        """
        best = None
        beams = np.vstack(self.beams) if self.beams else np.empty((0, 2))
        for up in (-1, 1, -2.3, 2.3, -3.6, 3.6, -4.9, 4.9):
            for side in (1, -1):
                left = x + 8 if side > 0 else x - 8 - long
                middle = y + 0.75 * up * tall
                box = (left, middle - tall / 2, left + long, middle + tall / 2)
                covered = sum(_overlap(box, other) for other in self.boxes)
                outside = max(0.0, -left, left + long - self.width) + max(0.0, -box[1], box[3] - self.height)
                crossed = np.all((beams >= box[:2]) & (beams <= box[2:]), axis=1).sum()
                hidden = covered + 100 * outside
                cost = hidden + 8 * crossed + 16 * (abs(up) - 1)  # near its frame, and not on an axis if it can be
                if best is None or cost < best[0]:
                    best = (cost, hidden, box)
        _, hidden, box = best
        if hidden > 0.25 * long * tall:
            return None
        self.boxes.append(box)
        return box[0], (box[1] + box[3]) / 2


def _extent(item: Item) -> np.ndarray:
    """Points that say how far a shape reaches, in the fixed frame."""
    match item.shape:
        case Axes(length):
            local = np.vstack((np.zeros(3), length * np.eye(3)))
        case Arrow(length):
            local = np.array(((0, 0, 0), (length, 0, 0)), dtype=float)
        case Box(size):
            local = np.array([(i, j, k) for i in (-0.5, 0.5) for j in (-0.5, 0.5) for k in (-0.5, 0.5)]) * size
        case Cylinder(radius, length):
            corners = np.array([(i, j, k) for i in (-1, 1) for j in (-1, 1) for k in (-0.5, 0.5)])
            local = corners * (radius, radius, length)
        case Sphere(radius):
            local = radius * np.vstack((np.eye(3), -np.eye(3)))
        case Mesh(vertices):
            local = vertices
        case Line() | Points():
            local = item.shape.points
        case _:
            local = np.zeros((1, 3))
    return _placed(item.pose, local)


def _placed(pose: np.ndarray, points: np.ndarray) -> np.ndarray:
    return points @ pose[:3, :3].T + pose[:3, 3]


def _coarser(vertices, faces, most: int):
    """A mesh with at most about so many faces: vertices that are near each other become one."""
    if len(faces) <= most:
        return vertices, faces
    low, span = vertices.min(axis=0), float(np.ptp(vertices, axis=0).max()) or 1.0
    for cells in (40, 28, 20, 14, 10, 7, 5, 3):
        keys = np.round((vertices - low) / span * cells).astype(int)
        _, first, group = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        few = group.reshape(-1)[faces]
        few = few[(few[:, 0] != few[:, 1]) & (few[:, 1] != few[:, 2]) & (few[:, 0] != few[:, 2])]
        few = few[np.unique(np.sort(few, axis=1), axis=0, return_index=True)[1]]
        if len(few) <= most:
            break
    return vertices[first], few


def _some(count: int, most: int):
    """Which points of a cloud to show, at most so many; by chance, as every n-th would show a pattern."""
    return slice(None) if count <= most else np.sort(np.random.default_rng(0).permutation(count)[:most])


def _overlap(a, b) -> float:
    return max(0.0, min(a[2], b[2]) - max(a[0], b[0])) * max(0.0, min(a[3], b[3]) - max(a[1], b[1]))


def _pair(place) -> str:
    return f'{place[0]:.1f},{place[1]:.1f}'
