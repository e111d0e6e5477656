"""What several figures are made of: queues, stacks, tables, time lines, plots."""

from collections.abc import Sequence
from dataclasses import dataclass

from grading.authoring.drawing import style
from grading.authoring.drawing.sheet import Sheet
from grading.authoring.drawing.sheet_geometry import Rectangle


def queue(
    sheet: Sheet,
    x: float,
    y: float,
    texts: Sequence[str],
    *,
    cell: float = 44,
    height: float = 34,
    colour: str = 'orange',
    size: float = style.NOTE,
) -> Rectangle:
    """Draw a queue, a cell for each text; an empty text is a free place."""
    for number, text in enumerate(texts):
        sheet.box(
            x + number * cell, y, cell, height, text, colour=colour, round=0, dashed=not text, plain=not text, size=size
        )
    return Rectangle(x, y, cell * len(texts), height)


def stack(
    sheet: Sheet,
    x: float,
    y: float,
    w: float,
    layers: Sequence[tuple[str, str]],
    *,
    h: float = 44,
    gap: float = 6,
    heading: bool = False,
) -> list[Rectangle]:
    """Draw layers (text, colour) from top to bottom; as a `heading` the text leaves room below itself."""
    return [
        sheet.box(
            x,
            y + number * (h + gap),
            w,
            h,
            '' if heading else text,
            heading=text if heading else '',
            colour=colour,
            size=style.NOTE,
        )
        for number, (text, colour) in enumerate(layers)
    ]


@dataclass
class Lanes:
    """Time runs to the right, and each lane belongs to one who acts."""

    sheet: Sheet
    names: Sequence[str]
    y: float = 40  # of the first lane
    step: float = 60  # from lane to lane
    left: float = 120
    right: float = 680
    end: float = 10  # time at the right end
    colour: str = 'muted'

    def __post_init__(self) -> None:
        for number, name in enumerate(self.names):
            height = self.y + number * self.step
            self.sheet.text(self.left - 10, height, name, anchor='end', size=style.NOTE, bold=True)
            self.sheet.arrow((self.left, height), (self.right, height), colour=self.colour)

    def x(self, time: float) -> float:
        return self.left + (self.right - self.left - 12) * time / self.end

    def at(self, lane: int, time: float) -> tuple[float, float]:
        """The point of a lane at a time."""
        return self.x(time), self.y + lane * self.step

    def bar(
        self, lane: int, begin: float, end: float, text: str = '', *, colour: str = 'blue', dashed=False
    ) -> Rectangle:
        """Something that lasts, such as a callback."""
        x, y = self.at(lane, begin)
        return self.sheet.box(
            x, y - 13, self.x(end) - x, 26, text, colour=colour, dashed=dashed, round=3, size=style.NOTE
        )

    def send(self, lane: int, time: float, other: int, arrival: float, label: str = '', **how) -> None:
        """A message from lane to lane; it ends at the border of what is there."""
        (ax, ay), (bx, by) = self.at(lane, time), self.at(other, arrival)
        down = 1 if by > ay else -1
        self.sheet.arrow((ax, ay + 13 * down), (bx, by - 13 * down), label, **how)


@dataclass
class Plot:
    """Axes of a plot, with ticks; `x_range` and `y_range` are in the units of the data."""

    sheet: Sheet
    x: float
    y: float
    w: float
    h: float
    x_range: tuple[float, float]
    y_range: tuple[float, float]
    x_ticks: Sequence[float]
    y_ticks: Sequence[float]
    x_name: str
    y_name: str

    def __post_init__(self) -> None:
        bottom = self.y + self.h
        self.sheet.line([(self.x, self.y), (self.x, bottom), (self.x + self.w, bottom)], colour='ink', width=1.4)
        for value in self.x_ticks:
            x, _ = self.at(value, self.y_range[0])
            self.sheet.line([(x, bottom), (x, bottom + 5)], colour='ink', width=1.4)
            self.sheet.text(x, bottom + 15, f'{value:g}', size=style.NOTE)
        for value in self.y_ticks:
            _, y = self.at(self.x_range[0], value)
            self.sheet.line([(self.x - 5, y), (self.x, y)], colour='ink', width=1.4)
            self.sheet.text(self.x - 9, y, f'{value:g}', anchor='end', size=style.NOTE)
        self.sheet.text(self.x + self.w / 2, bottom + 36, self.x_name, size=style.NOTE, colour='muted')
        self.sheet.text(self.x - 40, self.y - 18, self.y_name, anchor='start', size=style.NOTE, colour='muted')

    def at(self, x: float, y: float) -> tuple[float, float]:
        """The point of the sheet for a value."""
        (x0, x1), (y0, y1) = self.x_range, self.y_range
        return self.x + (x - x0) / (x1 - x0) * self.w, self.y + self.h - (y - y0) / (y1 - y0) * self.h

    def curve(self, values: Sequence[tuple[float, float]], *, colour: str = 'blue', dashed: bool = False) -> None:
        """A line through values."""
        self.sheet.line([self.at(*value) for value in values], colour=colour, dashed=dashed, width=2)

    def dots(self, values: Sequence[tuple[float, float]], *, colour: str = 'blue', hollow: bool = False) -> None:
        """A dot for each value."""
        for value in values:
            self.sheet.dot(*self.at(*value), radius=4, colour=colour, hollow=hollow)
