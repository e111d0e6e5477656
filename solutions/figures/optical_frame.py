"""Chapter 6: the axes of a camera's body and of its picture."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'A camera that looks to the right, twice. In camera_link, x is forward, y left and z up. In '
    'camera_optical_frame, z is forward, x right and y down. The point 0.1, 0.2, 3.0 in the optical frame is 3.0, '
    '-0.1, -0.2 in camera_link.'
)


def camera(sheet, x, name, axes, point):
    """A camera seen from its right side: what is left of it points away from you."""
    y = 146
    sheet.text(x, 30, f'`{name}`', bold=True)
    sheet.box(x - 116, y - 26, 70, 52, 'camera', colour='muted', size=NOTE)
    for text, colour, dx, dy in axes:
        sheet.arrow((x - 46, y), (x - 46 + dx, y + dy), colour=colour)
        length = (dx * dx + dy * dy) ** 0.5
        sheet.text(
            x - 46 + dx * (1 + 12 / length), y + dy * (1 + 12 / length), text, size=NOTE, colour=colour, bold=True
        )
    sheet.text(x, 266, point, size=NOTE)


def draw():
    sheet = Sheet('The axes of a camera and of its picture', height=292)
    camera(
        sheet,
        180,
        'camera_link',
        [('x', 'red', 110, 0), ('y', 'green', -44, -60), ('z', 'blue', 0, -74)],
        'the same point:\n(3.0, -0.1, -0.2)',
    )
    camera(
        sheet,
        520,
        'camera_optical_frame',
        [('z', 'blue', 110, 0), ('x', 'red', 44, 60), ('y', 'green', 0, 74)],
        'a point of the picture:\n(0.1, 0.2, 3.0)',
    )
    sheet.line([(350, 20), (350, 272)])
    return sheet
