"""Chapter 6: the axes of a robot, and the sense of roll, pitch and yaw."""

import math

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'Four small pictures. The axes of a robot: x forward, y left, z up. Yaw, from above: the axis z points at '
    'you, and a positive yaw turns the nose to the left. Pitch, from the left side: y points at you, a positive '
    'pitch turns the nose down. Roll, from the front: x points at you, a positive roll lifts the left side. Each '
    'time the positive sense is counter-clockwise.'
)


def turn(sheet, x, y, radius=48, colour='violet'):
    """An arrow counter-clockwise around a point: the positive sense if the axis points at you."""
    angles = [math.radians(20 + 5 * step) for step in range(27)]
    points = [(x + radius * math.cos(a), y - radius * math.sin(a)) for a in angles]
    sheet.line(points[:-1], colour=colour)
    sheet.head(points[-3], points[-1], colour)


def towards_you(sheet, x, y, colour):
    """An axis that points out of the sheet."""
    sheet.dot(x, y, radius=7, colour=colour, hollow=True)
    sheet.dot(x, y, radius=2, colour=colour)


def panel(sheet, number, title, axes, nose, note):
    """One robot; `axes` are two of (name, colour, dx, dy), `nose` the corners of the body from the centre."""
    x, y = 92 + 172 * number, 128
    sheet.text(x, 28, title, size=NOTE, bold=True)
    body = [(x + dx, y + dy) for dx, dy in nose]
    if body:
        sheet.line([*body, body[0]], colour='muted')
    for name, colour, dx, dy in axes:
        if dx or dy:
            sheet.arrow((x, y), (x + dx, y + dy), colour=colour)
            far = 1 + 11 / math.hypot(dx, dy)
            sheet.text(x + far * dx, y + far * dy, name, size=NOTE, colour=colour, bold=True)
        else:
            towards_you(sheet, x, y, colour)
            sheet.text(x + 17, y + 11, name, size=NOTE, colour=colour, bold=True)
    sheet.text(x, 216, note, size=NOTE)


def draw():
    sheet = Sheet('Axes and positive turns', height=278)
    up, left, out = (0, -62), (-62, 0), (0, 0)
    panel(
        sheet,
        0,
        'axes',
        [('x', 'red', 50, 22), ('y', 'green', 46, -30), ('z', 'blue', *up)],
        [],
        'x forward, y left,\nz up',
    )
    panel(
        sheet,
        1,
        'yaw, from above',
        [('x', 'red', *up), ('y', 'green', *left), ('z', 'blue', *out)],
        [(-28, 30), (-28, -16), (0, -34), (28, -16), (28, 30)],
        'positive: the nose\nturns to the left',
    )
    panel(
        sheet,
        2,
        'pitch, from the left',
        [('z', 'blue', *up), ('x', 'red', *left), ('y', 'green', *out)],
        [(34, 24), (34, -20), (-16, -20), (-36, 2), (-16, 24)],
        'positive: the nose\ngoes down',
    )
    panel(
        sheet,
        3,
        'roll, from the front',
        [('z', 'blue', *up), ('y', 'green', 62, 0), ('x', 'red', *out)],
        [(-30, 24), (-30, -20), (30, -20), (30, 24)],
        'positive: the left\nside goes up',
    )
    rule = 'Right hand: the thumb points along the axis, and the fingers curl in the positive sense.'
    sheet.text(350, 258, rule, size=NOTE)
    for number in (1, 2, 3):
        turn(sheet, 92 + 172 * number, 128)
    return sheet
