"""Chapter 6: what lookup_transform('world', 'cup') tells, seen from above."""

import math

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'The room from above. The table stands at (2, 1) in the world and is turned by 90 degrees to the left. The '
    'cup stands 0.3 m along the x axis of the table, so it is at (2, 1.3) in the world. The look-up with target '
    'world and source cup says where the cup stands, seen from the world, and takes points from the cup into the '
    'world.'
)
ORIGIN, SCALE = (90, 300), 118


def at(x, y):
    """The point of the sheet for a place in the world: x to the right, y up."""
    return ORIGIN[0] + SCALE * x, ORIGIN[1] - SCALE * y


def frame(sheet, x, y, yaw, length=0.45):
    """The axes of a frame from above: x red, y green."""
    for angle, colour, name in ((yaw, 'red', 'x'), (yaw + math.pi / 2, 'green', 'y')):
        tip = x + length * math.cos(angle), y + length * math.sin(angle)
        sheet.arrow(at(x, y), at(*tip), colour=colour)
        name_at = at(x + 1.2 * length * math.cos(angle), y + 1.2 * length * math.sin(angle))
        sheet.text(*name_at, name, size=NOTE, colour=colour, bold=True)


def draw():
    sheet = Sheet('Target and source of a look-up', height=350)
    sheet.arrow(at(0, 0), at(2, 1))
    sheet.text(
        236, 256, 'where the table stands:\n(2, 1, 0.7), turned by 90°', anchor='start', size=NOTE, colour='muted'
    )
    frame(sheet, 0, 0, 0)
    sheet.text(90, 326, '`world`: the target', size=NOTE)
    frame(sheet, 2, 1, math.pi / 2, 0.8)
    sheet.text(342, 192, '`table`', anchor='start', size=NOTE)
    sheet.arrow(at(0, 0), at(1.96, 1.29), colour='violet')
    sheet.dot(*at(2, 1.3), colour='violet')
    sheet.text(342, 147, '`cup`: the source', anchor='start', size=NOTE)
    call = "`lookup_transform('world', 'cup', …)`\n(2, 1.3, 0.7)"
    sheet.box(378, 24, 306, 60, call, size=NOTE, colour='violet')
    sheet.text(185, 110, 'the answer:\nwhere the source stands,\nseen from the target', size=NOTE, colour='violet')
    sheet.text(552, 262, 'It takes points\nfrom the source\ninto the target.', size=NOTE, colour='violet')
    return sheet
