"""Chapter 6: the four frames of REP 105, and who connects them."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'A chain of frames from map over odom and base_link to laser. The localisation publishes map to odom, which '
    'may jump. The wheels give odom to base_link, which is smooth but drifts. base_link to laser is static. The '
    'localisation knows map to base_link, and publishes what is missing.'
)
FRAMES = (
    ('map', 'fixed to\nthe building'),
    ('odom', 'fixed to where it\nwas switched on'),
    ('base_link', 'fixed to\nthe body'),
    ('laser', 'fixed to\na sensor'),
)
LINKS = (('localisation:\nmay **jump**', 'red'), ('wheels: **smooth**,\nbut drifts', 'green'), ('static', 'muted'))


def draw():
    sheet = Sheet('From the map to the robot', height=200)
    boxes = []
    for number, (name, fixed) in enumerate(FRAMES):
        box = sheet.box(16 + 188 * number, 70, 104, 40, f'`{name}`')
        sheet.text(box.centre[0], 132, fixed, size=NOTE, colour='muted')
        boxes.append(box)
    for one, other, (how, colour) in zip(boxes, boxes[1:], LINKS, strict=False):
        sheet.arrow(one, other, colour=colour)
        sheet.text((one.right[0] + other.left[0]) / 2, 44, how, size=NOTE, colour=colour)
    sheet.text(
        350, 178, 'The localisation knows map → base_link, and publishes what is missing: map → odom.', size=NOTE
    )
    return sheet
