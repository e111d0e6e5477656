"""A sheet with texts, boxes, lines and arrows, written as SVG."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from xml.sax.saxutils import escape, quoteattr

from grading.authoring.drawing import metrics, style
from grading.authoring.drawing.sheet_geometry import Point, Rectangle, TextBlock, along, shortened
from helpers.show import dark_page

WIDTH = 700
GAP = 5  # between a line and its label
HEAD = 9  # length of an arrow's head


@dataclass
class Sheet:
    """What a figure draws on. Things drawn later lie above."""

    title: str
    height: float
    width: float = WIDTH
    items: list[TextBlock | Rectangle | list[Point]] = field(
        default_factory=list
    )  # in the order in which they were drawn
    _written: list[str] = field(default_factory=list)

    @property
    def texts(self) -> list[TextBlock]:
        return [item for item in self.items if isinstance(item, TextBlock)]

    @property
    def boxes(self) -> list[Rectangle]:
        return [item for item in self.items if isinstance(item, Rectangle)]

    @property
    def lines(self) -> list[list[Point]]:
        return [item for item in self.items if isinstance(item, list)]

    def text(
        self,
        x: float,
        y: float,
        text: str,
        *,
        anchor: str = 'middle',
        size: float = style.SIZE,
        colour: str = 'ink',
        bold: bool = False,
        halo: bool = False,
    ) -> TextBlock:
        """Write lines of text whose block has its middle at the height `y`.

        :param anchor: what `x` is, as SVG names it: 'start', 'middle' or 'end'.
        :param halo: keep lines that pass below away from the letters.
        """
        lines = text.split('\n')
        line_height = metrics.LINE * size
        width = max(metrics.width(line, size, bold) for line in lines)
        left = x - {'start': 0.0, 'middle': width / 2, 'end': width}[anchor]
        top = y - line_height * len(lines) / 2
        around = (
            f' stroke="{style.GROUND}" stroke-width="3" stroke-linejoin="round" paint-order="stroke"' if halo else ''
        )
        for number, line in enumerate(lines):
            base = top + line_height * (number + 0.5) + 0.35 * size
            self._written.append(
                f'<text x="{_n(x)}" y="{_n(base)}" font-size="{_n(size)}" text-anchor="{anchor}" '
                f'fill="{style.INK[colour]}"{around}>{_spans(line, bold)}</text>'
            )
        block = TextBlock(text, left, top, left + width, top + line_height * len(lines), size)
        self.items.append(block)
        return block

    def box(
        self,
        x: float,
        y: float,
        w: float,
        h: float,
        text: str = '',
        *,
        colour: str = 'blue',
        dashed: bool = False,
        round: float = 6,
        size: float = style.SIZE,
        bold: bool = False,
        heading: str = '',
        plain: bool = False,
    ) -> Rectangle:
        """Draw a box with a text in its middle, or with a heading at its top; `plain` leaves its ground white."""
        fill = style.FILL['ink' if plain else colour]
        dashes = ' stroke-dasharray="6 4"' if dashed else ''
        self._written.append(
            f'<rect x="{_n(x)}" y="{_n(y)}" width="{_n(w)}" height="{_n(h)}" rx="{_n(round)}" fill="{fill}" '
            f'stroke="{style.INK[colour]}" stroke-width="1.5"{dashes}/>'
        )
        box = Rectangle(x, y, w, h)
        self.items.append(box)
        if text:
            self.text(*box.centre, text, size=size, bold=bold)
        if heading:
            self.text(x + 10, y + 15, heading, anchor='start', size=style.NOTE, colour=colour, bold=True)
        return box

    def line(self, points: Sequence[Point], *, colour: str = 'muted', dashed: bool = False, width: float = 1.6) -> None:
        """Draw a line through points."""
        coordinates = ' '.join(f'{_n(x)},{_n(y)}' for x, y in points)
        dashes = ' stroke-dasharray="6 4"' if dashed else ''
        self._written.append(
            f'<polyline points="{coordinates}" fill="none" stroke="{style.INK[colour]}" stroke-width="{_n(width)}" '
            f'stroke-linejoin="round"{dashes}/>'
        )
        self.items.append(list(points))

    def arrow(
        self,
        start: Rectangle | Point,
        end: Rectangle | Point,
        label: str = '',
        *,
        via: Sequence[Point] = (),
        side: str = '',
        at: float = 0.5,
        colour: str = 'muted',
        dashed: bool = False,
        both: bool = False,
        size: float = style.NOTE,
    ) -> None:
        """Draw an arrow, with a label beside its middle.

        :param via: corners between start and end.
        :param side: of the label: 'above', 'below', 'left' or 'right'.
        :param at: the place of the label, in parts of the arrow's length.
        :param both: a head at both ends.
        """
        first = via[0] if via else end.centre if isinstance(end, Rectangle) else end
        last = via[-1] if via else start.centre if isinstance(start, Rectangle) else start
        begin = start.towards(first) if isinstance(start, Rectangle) else start
        stop = end.towards(last) if isinstance(end, Rectangle) else end
        points = [begin, *via, stop]
        shaft = shortened(points, HEAD / 2)
        if both:
            shaft = shortened(shaft[::-1], HEAD / 2)[::-1]
        self.line(shaft, colour=colour, dashed=dashed)
        self.head(points[-2], points[-1], colour)
        if both:
            self.head(points[1], points[0], colour)
        if label:
            self.label(points, label, side=side, at=at, colour=colour, size=size)

    def head(self, before: Point, tip: Point, colour: str = 'muted') -> None:
        """Draw the head of an arrow that comes from `before`."""
        angle = math.atan2(tip[1] - before[1], tip[0] - before[0])
        corners = [tip] + [
            (tip[0] - HEAD * math.cos(angle + turn), tip[1] - HEAD * math.sin(angle + turn)) for turn in (0.42, -0.42)
        ]
        coordinates = ' '.join(f'{_n(x)},{_n(y)}' for x, y in corners)
        self._written.append(f'<polygon points="{coordinates}" fill="{style.INK[colour]}"/>')

    def label(
        self,
        points: Sequence[Point],
        label: str,
        *,
        side: str = '',
        at: float = 0.5,
        colour: str = 'muted',
        size: float = style.NOTE,
    ) -> None:
        """Write a label beside a line, so far away that it does not touch it."""
        (x, y), (dx, dy) = along(points, at)
        normals = {'above': (dy, -dx), 'below': (-dy, dx)}
        if not side:
            side = 'above' if abs(dx) >= abs(dy) else 'right'
        nx, ny = normals.get(side, (-dy, dx))
        wanted = {'above': -ny, 'below': ny, 'right': nx, 'left': -nx}[side]
        if wanted < 0:
            nx, ny = -nx, -ny
        lines = label.split('\n')
        width = max(metrics.width(line, size) for line in lines)
        height = metrics.LINE * size * len(lines)
        away = GAP + abs(nx) * width / 2 + abs(ny) * height / 2
        self.text(x + nx * away, y + ny * away, label, size=size, colour=colour, halo=True)

    def dot(self, x: float, y: float, *, radius: float = 5, colour: str = 'blue', hollow: bool = False) -> Rectangle:
        """Draw a dot."""
        fill = style.GROUND if hollow else style.INK[colour]
        self._written.append(
            f'<circle cx="{_n(x)}" cy="{_n(y)}" r="{_n(radius)}" fill="{fill}" stroke="{style.INK[colour]}" '
            'stroke-width="1.6"/>'
        )
        return Rectangle(x - radius, y - radius, 2 * radius, 2 * radius)

    def cross(self, x: float, y: float, *, size: float = 6, colour: str = 'red') -> None:
        """Draw a cross: what does not happen, or is lost."""
        for one in (1, -1):
            self._written.append(
                f'<line x1="{_n(x - size)}" y1="{_n(y - one * size)}" x2="{_n(x + size)}" y2="{_n(y + one * size)}" '
                f'stroke="{style.INK[colour]}" stroke-width="2.5" stroke-linecap="round"/>'
            )

    def svg(self, name: str, alt: str) -> str:
        """Return the text of an SVG file; `name` keeps its ids apart from those of other figures on a page."""
        ground = (
            f'<rect x="0.75" y="0.75" width="{_n(self.width - 1.5)}" height="{_n(self.height - 1.5)}" rx="8" '
            f'fill="{style.GROUND}" stroke="{style.EDGE}" stroke-width="1.5"/>'
        )
        drawing = '\n'.join([ground, *self._written])
        return '\n'.join(
            [
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{_n(self.width)}" height="{_n(self.height)}" '
                f'viewBox="0 0 {_n(self.width)} {_n(self.height)}" role="img" '
                f'aria-labelledby="{name}-title {name}-desc" style="max-width: 100%; height: auto" '
                f'font-family={quoteattr(style.SANS)}>',
                f'<title id="{name}-title">{escape(self.title)}</title>',
                f'<desc id="{name}-desc">{escape(alt)}</desc>',
                f'<style>\n{dark_page.rules(drawing, style.DARK)}\n</style>',
                drawing,
                '</svg>',
                '',
            ]
        )


def _n(number: float) -> str:
    """A number with one decimal, or none."""
    text = f'{number:.1f}'.removesuffix('.0')
    return '0' if text == '-0' else text


def _spans(line: str, bold: bool) -> str:
    parts = []
    for span in metrics.spans(line, bold):
        family = f' font-family={quoteattr(style.MONO)}' if span.mono else ''
        weight = ' font-weight="600"' if span.bold else ''
        inside = escape(span.text)
        parts.append(f'<tspan{family}{weight}>{inside}</tspan>' if family or weight else inside)
    return ''.join(parts)
