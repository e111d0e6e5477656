"""Chapter 3: a map that is published once, and a planner that starts later."""

from grading.authoring.drawing import NOTE, Lanes, Sheet

ALT = (
    'Two time lines. The map server publishes the map once, and the planner starts later. With VOLATILE on both '
    'sides the map is gone when the planner comes. With TRANSIENT_LOCAL on both sides the server keeps its last '
    'messages and sends the map to the planner as soon as it subscribes.'
)


def draw():
    sheet = Sheet('A late subscription', height=320)
    for number, (title, kept) in enumerate(
        (('`VOLATILE` on both sides', False), ('`TRANSIENT_LOCAL` on both sides', True))
    ):
        y = 28 + 154 * number
        sheet.text(20, y, title, anchor='start', bold=True)
        lanes = Lanes(sheet, ['map server', 'planner'], y=y + 40, step=66, left=120, right=684, end=10)
        lanes.bar(0, 0.8, 2.4, 'the map', colour='orange')
        if kept:
            lanes.bar(0, 2.4, 10, 'kept', colour='orange', dashed=True)
        lanes.bar(1, 5, 6.6, 'starts')
        if kept:
            lanes.send(0, 7.2, 1, 7.4, colour='green')
            lanes.bar(1, 7, 8.8, 'callback', colour='violet')
        else:
            lanes.send(0, 1.6, 1, 1.8, colour='red', dashed=True)
            sheet.text(lanes.x(2.1), y + 80, 'nobody is there', anchor='start', size=NOTE, colour='red')
    return sheet
