"""The paper under the turtles: a small RGB raster that can draw a thick line and tell a pixel's colour."""

import math
from collections.abc import Iterator

BLANK = (255, 255, 255)


class Canvas:
    """A square of ``size`` x ``size`` pixels; row 0 is the top one."""

    def __init__(self, size: int):
        self.size = size
        self._rgb = bytearray()
        self.clear()

    def clear(self) -> None:
        """Make every pixel blank."""
        self._rgb = bytearray(BLANK) * (self.size * self.size)

    def pixel(self, x: float, y: float) -> tuple[int, int, int]:
        """Return the colour (red, green, blue) of the pixel nearest to (x, y); outside the paper it is blank."""
        column, row = math.floor(x + 0.5), math.floor(y + 0.5)
        if not (0 <= column < self.size and 0 <= row < self.size):
            return BLANK
        at = 3 * (row * self.size + column)
        return tuple(self._rgb[at : at + 3])

    def line(self, start: tuple[float, float], end: tuple[float, float], color: tuple[int, int, int], width: int):
        """Draw a straight line with square ends, ``width`` pixels wide."""
        corners = _outline(start, end, width / 2)
        paint = bytes(color)
        for row, left, right in _spans(corners, self.size):
            at = 3 * (row * self.size + left)
            self._rgb[at : at + 3 * (right - left + 1)] = paint * (right - left + 1)


def _outline(start: tuple[float, float], end: tuple[float, float], half: float) -> list[tuple[float, float]]:
    """Return the four corners of a line with square ends."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = math.hypot(dx, dy)
    ux, uy = (dx / length, dy / length) if length else (1.0, 0.0)
    ax, ay = ux * half, uy * half
    return [
        (start[0] - ax - ay, start[1] - ay + ax),
        (end[0] + ax - ay, end[1] + ay + ax),
        (end[0] + ax + ay, end[1] + ay - ax),
        (start[0] - ax + ay, start[1] - ay - ax),
    ]


def _spans(corners: list[tuple[float, float]], size: int) -> Iterator[tuple[int, int, int]]:
    """Yield (row, first column, last column) of the pixels whose centre lies in a convex polygon."""
    rows = [y for _, y in corners]
    for row in range(max(0, math.ceil(min(rows))), min(size - 1, math.floor(max(rows))) + 1):
        crossings = []
        for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1], strict=True):
            if y0 == y1:
                if y0 == row:
                    crossings += [x0, x1]
            elif min(y0, y1) <= row <= max(y0, y1):
                crossings.append(x0 + (row - y0) * (x1 - x0) / (y1 - y0))
        if crossings:
            left, right = max(0, math.ceil(min(crossings))), min(size - 1, math.floor(max(crossings)))
            if left <= right:
                yield row, left, right
