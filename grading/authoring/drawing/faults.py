"""What cannot be read in a drawing: texts outside of the sheet, over each other, on a line or on a box's border."""

from collections.abc import Iterator
from itertools import combinations

from grading.authoring.drawing import style
from grading.authoring.drawing.sheet import Sheet
from grading.authoring.drawing.sheet_geometry import Point, Rectangle, TextBlock

MARGIN = 6  # between texts and the sheet's border
PADDING = 3  # between texts and the borders of boxes, to the sides
SLACK = 2  # lines of a block have some room above and below their letters


def found(sheet: Sheet) -> list[str]:
    """Return one line for each fault; empty if all can be read."""
    return list(_found(sheet))


def _found(sheet: Sheet) -> Iterator[str]:
    for text in sheet.texts:
        if text.size < style.LEAST:
            yield f'{text.text!r} has the size {text.size:g}, at least {style.LEAST} is needed'
        outside = (
            text.left < MARGIN
            or text.top < MARGIN
            or text.right > sheet.width - MARGIN
            or text.bottom > sheet.height - MARGIN
        )
        if outside:
            yield f'{text.text!r} is not on the sheet, or too near to its border: {_extent(text)}'
        for box in sheet.boxes:
            if _on_border(text, box):
                yield f'{text.text!r}, {_extent(text)}, lies on the border of the box at {box.x:g}, {box.y:g}'
        for number, line in enumerate(sheet.items):
            if not isinstance(line, list) or any(_covers(item, text) for item in sheet.items[number:]):
                continue
            if any(_crossed(text, *piece) for piece in zip(line, line[1:], strict=False)):
                yield f'{text.text!r}, {_extent(text)}, lies on the line from {_point(line[0])} to {_point(line[-1])}'
    for box in sheet.boxes:
        if box.x < 1 or box.y < 1 or box.x + box.w > sheet.width - 1 or box.y + box.h > sheet.height - 1:
            yield f'the box at {box.x:g}, {box.y:g} is not on the sheet'
    for one, other in combinations(sheet.texts, 2):
        if _overlap(one, other):
            yield f'{one.text!r} and {other.text!r} overlap'


def _overlap(one: TextBlock, other: TextBlock) -> bool:
    return (
        one.left < other.right
        and other.left < one.right
        and one.top + SLACK < other.bottom - SLACK
        and other.top + SLACK < one.bottom - SLACK
    )


def _on_border(text: TextBlock, box: Rectangle) -> bool:
    right, bottom = box.x + box.w, box.y + box.h
    top_of_text, bottom_of_text = text.top + SLACK, text.bottom - SLACK
    apart = text.right < box.x or text.left > right or bottom_of_text < box.y or top_of_text > bottom
    inside = (
        text.left > box.x + PADDING and text.right < right - PADDING and top_of_text > box.y and bottom_of_text < bottom
    )
    return not apart and not inside


def _covers(item: object, text: TextBlock) -> bool:
    """Whether it is a box with the text inside, which hides the lines that were drawn before."""
    if not isinstance(item, Rectangle):
        return False
    inside_x = item.x <= text.left and text.right <= item.x + item.w
    return inside_x and item.y <= text.top + SLACK and text.bottom - SLACK <= item.y + item.h


def _crossed(text: TextBlock, a: Point, b: Point) -> bool:
    """Whether a straight piece of a line enters the text's room (Liang and Barsky's clipping)."""
    begin, end = 0.0, 1.0
    dx, dy = b[0] - a[0], b[1] - a[1]
    for step, room in (
        (-dx, a[0] - text.left),
        (dx, text.right - a[0]),
        (-dy, a[1] - text.top - SLACK),
        (dy, text.bottom - SLACK - a[1]),
    ):
        if step == 0:
            if room < 0:
                return False
        elif step < 0:
            begin = max(begin, room / step)
        else:
            end = min(end, room / step)
    return begin < end


def _extent(text: TextBlock) -> str:
    return f'{text.left:.0f}..{text.right:.0f} by {text.top:.0f}..{text.bottom:.0f}'


def _point(point: Point) -> str:
    return f'{point[0]:.0f}, {point[1]:.0f}'
