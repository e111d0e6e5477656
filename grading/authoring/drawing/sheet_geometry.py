"""Points, boxes and blocks of text on a sheet, and lines between them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

Point = tuple[float, float]


@dataclass(frozen=True)
class TextBlock:
    """A block of text and the room that it takes."""

    text: str
    left: float
    top: float
    right: float
    bottom: float
    size: float


@dataclass(frozen=True)
class Rectangle:
    """A rectangle on the sheet."""

    x: float
    y: float
    w: float
    h: float

    @property
    def centre(self) -> Point:
        return self.x + self.w / 2, self.y + self.h / 2

    @property
    def left(self) -> Point:
        return self.on('left')

    @property
    def right(self) -> Point:
        return self.on('right')

    @property
    def top(self) -> Point:
        return self.on('top')

    @property
    def bottom(self) -> Point:
        return self.on('bottom')

    def on(self, side: str, part: float = 0.5) -> Point:
        """A point of a side; `part` goes from left to right, or from top to bottom."""
        if side in ('left', 'right'):
            return self.x + (self.w if side == 'right' else 0), self.y + part * self.h
        return self.x + part * self.w, self.y + (self.h if side == 'bottom' else 0)

    def towards(self, point: Point) -> Point:
        """Where the line from the centre to a point leaves the box."""
        (cx, cy), (px, py) = self.centre, point
        dx, dy = px - cx, py - cy
        part = min(self.w / 2 / abs(dx) if dx else math.inf, self.h / 2 / abs(dy) if dy else math.inf)
        return cx + dx * part, cy + dy * part


def shortened(points: Sequence[Point], less: float) -> list[Point]:
    """Return the same line, `less` pixels shorter at its end."""
    (ax, ay), (bx, by) = points[-2], points[-1]
    length = math.hypot(bx - ax, by - ay)
    part = max(length - less, 0) / length if length else 0
    return [*points[:-1], (ax + (bx - ax) * part, ay + (by - ay) * part)]


def along(points: Sequence[Point], at: float) -> tuple[Point, Point]:
    """Return the point at this part of a line's length, and the direction there."""
    pieces = list(zip(points, points[1:], strict=False))
    lengths = [math.dist(a, b) for a, b in pieces]
    left = at * sum(lengths)
    for (a, b), length in zip(pieces, lengths, strict=True):
        if length and left <= length + 1e-9:
            dx, dy = (b[0] - a[0]) / length, (b[1] - a[1]) / length
            return (a[0] + dx * left, a[1] + dy * left), (dx, dy)
        left -= length
    return points[-1], (1, 0)
