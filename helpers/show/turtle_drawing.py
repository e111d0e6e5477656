"""turtlesim's world as a drawing with numbers: turtlesim's own picture, and around it what one reads a place from.

Axes and a grid in metres, for each turtle where it looks, where it stands in words, and the mark of a goal.
"""

import math
from html import escape

from turtlesim_nodes.svg import draw_svg
from turtlesim_nodes.world import METER, PIXELS, World, to_pixels

from helpers.show import dark_page

_LEFT, _TOP, _RIGHT, _BOTTOM = 44, 34, 44, 44  # the margins, in pixels of turtlesim's picture
_LINE = 28  # the height of a line of text
_LETTER = 12  # the width of a letter
_BELOW, _ABOVE = 48, 32  # from a turtle's middle to the foot of its name
_TEXTS = 3  # turtles whose pose is written below
_HEADING = 1.2  # m, the length of the line that shows where a turtle looks
_LAST = 11  # m, the last line of the grid
_INK, _PAPER, _GOAL = '#20262e', '#fcfcfa', '#ffd54a'
_GRID = 'stroke="#ffffff" stroke-opacity="0.3" stroke-width="1"'
_DARK_RULES = dark_page.rules(
    f'fill="{_INK}" fill="{_PAPER}"', {_INK: '#e6e9ee', _PAPER: '#181b20'}, within='.turtle-world'
)


def describe(turtle) -> str:
    """Return where a turtle is, in words."""
    return f'{turtle.name}: x {turtle.x:.2f} m, y {turtle.y:.2f} m, theta {math.degrees(turtle.theta):.0f}°'


def draw(world: World, size: int, goal: tuple[float, float] | None = None) -> str:
    """Return an SVG.

    :param size: its width in pixels.
    :param goal: a place to mark, (x, y) in m.
    """
    turtles = [world.turtles[name] for name in sorted(world.turtles)]
    lines = [describe(turtle) for turtle in turtles[:_TEXTS]]
    width = _LEFT + PIXELS + _RIGHT
    height = _TOP + PIXELS + _BOTTOM + _LINE * len(lines)
    return '\n'.join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="{size * height / width:.0f}" '
            f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="22" class="turtle-world">',
            f'<style>{_DARK_RULES}</style>',
            f'<rect width="{width}" height="{height}" rx="8" fill="{_PAPER}"/>',
            f'<g fill="{_INK}">',
            f'<g transform="translate({_LEFT},{_TOP})">',
            draw_svg(world),
            *_grid(),
            *(_heading(turtle) for turtle in turtles),
            *(_name(turtle) for turtle in turtles if len(turtles) > 1),
            _mark(*goal) if goal is not None else '',
            '</g>',
            *(
                f'<text x="{_LEFT}" y="{_TOP + PIXELS + _BOTTOM + _LINE * number + 12}">{escape(line)}</text>'
                for number, line in enumerate(lines)
            ),
            '</g>',
            '</svg>',
        ]
    )


def _grid() -> list[str]:
    """A line for each metre; each second one has its number at the axis, whose name stands at its end."""
    drawn = []
    for metre in range(_LAST + 1):
        x, y = to_pixels(metre, metre)
        drawn.append(f'<path d="M {x:.0f} 0 V {PIXELS} M 0 {y:.0f} H {PIXELS}" {_GRID}/>')
        if metre % 2 == 0:
            drawn.append(f'<text x="{x:.0f}" y="{PIXELS + 24}" text-anchor="middle">{metre}</text>')
            drawn.append(f'<text x="-8" y="{y + 8:.0f}" text-anchor="end">{metre}</text>')
    drawn.append(f'<text x="{PIXELS + _RIGHT - 8}" y="{PIXELS + 24}" text-anchor="end">x [m]</text>')
    drawn.append(f'<text x="{8 - _LEFT}" y="-10">y [m]</text>')
    return drawn


def _heading(turtle) -> str:
    x, y = to_pixels(turtle.x, turtle.y)
    dx, dy = _HEADING * METER * math.cos(turtle.theta), -_HEADING * METER * math.sin(turtle.theta)
    return (
        f'<path d="M {x:.1f} {y:.1f} l {dx:.1f} {dy:.1f}" stroke="#ffffff" stroke-width="3"/>'
        f'<circle cx="{x + dx:.1f}" cy="{y + dy:.1f}" r="5" fill="#ffffff"/>'
    )


def _name(turtle) -> str:
    """The turtle's name, on the side to which it does not look; near the border, inside of the world."""
    x, y = to_pixels(turtle.x, turtle.y)
    half = 0.5 * _LETTER * len(turtle.name)
    x = min(max(x, half), PIXELS - half)
    y += _BELOW if math.sin(turtle.theta) >= 0 else -_ABOVE
    y = min(max(y, _LINE), PIXELS - _LINE // 2)
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="middle" fill="#ffffff">{escape(turtle.name)}</text>'


def _mark(x: float, y: float) -> str:
    column, row = to_pixels(x, y)
    return (
        f'<g stroke="{_GOAL}" stroke-width="4" fill="none"><title>goal</title>'
        f'<circle cx="{column:.1f}" cy="{row:.1f}" r="14"/>'
        f'<path d="M {column - 22:.1f} {row:.1f} h 44 M {column:.1f} {row - 22:.1f} v 44"/></g>'
    )
