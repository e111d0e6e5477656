"""What a turtle looks like: a few shapes in its own axes, looking along x, about one metre long."""

import math

from turtlesim_nodes.world import BREEDS, Turtle

_SHELLS = (
    '#6a8f3c',
    '#8a6d3b',
    '#4f9fb5',
    '#c9822b',
    '#7b5ea7',
    '#b5533c',
    '#3c6e8f',
    '#5b8c5a',
    '#7d7f86',
    '#2f7f6f',
    '#a05a7f',
)  # one for each breed
_SKIN, _DARK = '#cfd98a', '#2f3b1c'


def _ellipse(cx: float, cy: float, rx: float, ry: float, corners: int = 14) -> list[tuple[float, float]]:
    turn = 2 * math.pi / corners
    return [(cx + rx * math.cos(turn * i), cy + ry * math.sin(turn * i)) for i in range(corners)]


def polygons(turtle: Turtle) -> list[tuple[str, list[tuple[float, float]]]]:
    """Return (fill colour, corners in metres of the world) of a turtle, from back to front."""
    shell = _SHELLS[BREEDS.index(turtle.breed)]
    parts = [(_SKIN, _ellipse(sx * 0.22, sy * 0.27, 0.12, 0.09)) for sx in (-1, 1) for sy in (-1, 1)]
    parts += [
        (_SKIN, [(-0.30, 0.06), (-0.50, 0.0), (-0.30, -0.06)]),
        (_SKIN, _ellipse(0.40, 0.0, 0.13, 0.10)),
        (_DARK, _ellipse(0.46, 0.05, 0.02, 0.02, 6)),
        (_DARK, _ellipse(0.46, -0.05, 0.02, 0.02, 6)),
        (_DARK, _ellipse(0.0, 0.0, 0.34, 0.28)),
        (shell, _ellipse(0.0, 0.0, 0.30, 0.24)),
    ]
    cos, sin = math.cos(turtle.theta), math.sin(turtle.theta)

    def place(x: float, y: float) -> tuple[float, float]:
        return turtle.x + cos * x - sin * y, turtle.y + sin * x + cos * y

    return [(fill, [place(*corner) for corner in corners]) for fill, corners in parts]
