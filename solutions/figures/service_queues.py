"""Chapter 4: requests wait in one queue, answers go back to those who asked."""

from grading.authoring.drawing import NOTE, Sheet, queue

ALT = (
    'Three clients, anna, ben and carl, ask one server. Their requests wait in one queue of depth 10, in the '
    'order of their arrival. The one callback of the server takes them one after the other. Each answer goes back '
    'to the client that has asked, and to no other.'
)
CLIENTS = (('anna', 'blue'), ('ben', 'green'), ('carl', 'violet'))


def draw():
    sheet = Sheet('Many clients, one server', height=270)
    sheet.box(270, 16, 414, 170, heading='server')
    boxes = [
        sheet.box(46, 30 + 60 * number, 100, 40, name, colour=colour) for number, (name, colour) in enumerate(CLIENTS)
    ]
    cells = queue(sheet, 290, 92, [*[''] * 7, 'c', 'b', 'a'], cell=24, height=36)
    sheet.text(410, 74, 'request queue, depth 10', size=NOTE)
    for number, box in enumerate(boxes):
        label = 'requests' if number == 0 else ''
        sheet.arrow(box.right, (290, 100 + 10 * number), label, colour=CLIENTS[number][1], at=0.45)
    callback = sheet.box(560, 90, 108, 40, '`on_add`', colour='violet', plain=True)
    sheet.arrow(cells.right, callback)
    sheet.text(614, 74, 'one at a time', size=NOTE, colour='muted')
    sheet.line([(614, 126), (614, 226), (24, 226), (24, 50)])
    for box in boxes:
        sheet.arrow((24, box.left[1]), box)
    sheet.text(340, 244, 'each answer goes back to the one who asked', size=NOTE)
    return sheet
