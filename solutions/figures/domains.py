"""Chapter 1: the same topic in two domains."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'Two domains on one network. In one of them ann publishes on roll_call and ben hears it. In the other one cem '
    'subscribes to the same topic and hears nothing: no connection crosses the border of a domain.'
)


def draw():
    sheet = Sheet('Two domains on one network', height=190)
    sheet.box(20, 20, 420, 130, heading='our domain', colour='green')
    sheet.box(480, 20, 200, 130, heading='their domain', colour='orange')
    ann = sheet.box(40, 70, 100, 40, 'ann', plain=True)
    ben = sheet.box(320, 70, 100, 40, 'ben', plain=True)
    cem = sheet.box(530, 70, 100, 40, 'cem', plain=True)
    sheet.arrow(ann, ben, '`roll_call`')
    sheet.arrow(ben.right, cem.left, colour='red', dashed=True)
    sheet.cross(460, 90, size=8)
    sheet.text(350, 170, 'one network, one topic, one type: only the number of the domain differs', size=NOTE)
    return sheet
