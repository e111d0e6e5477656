"""Chapter 3: the way of a message from publish() to the callback."""

from grading.authoring.drawing import NOTE, Sheet, queue

ALT = (
    'The node alice calls publish on the topic chatter. Each message goes into the queue of a subscription of the '
    'node bob and waits there. Spin takes the oldest one out of the queue and calls the callback with it. Without '
    'spin the queue fills and no callback runs.'
)


def draw():
    sheet = Sheet('From publish to the callback', height=230)
    sheet.box(16, 60, 130, 90, heading='node alice')
    sheet.text(81, 113, '`publish()`', size=NOTE)
    sheet.box(290, 16, 394, 198, heading='node bob')
    cells = queue(sheet, 312, 87, [*[''] * 7, '3', '2', '1'], cell=20, height=36)
    sheet.text(412, 71, 'queue, depth 10', size=NOTE)
    sheet.text(412, 141, 'arrived, and waiting', size=NOTE, colour='muted')
    sheet.arrow((146, 105), cells.left, 'topic `chatter`', at=0.44)
    callback = sheet.box(560, 85, 108, 40, 'callback', colour='violet', plain=True)
    sheet.arrow(cells.right, callback, 'spin', colour='green')
    sheet.text(614, 143, 'called with `1`', size=NOTE, colour='muted')
    sheet.text(487, 186, 'no spin, no callback: the message stays in the queue', size=NOTE, colour='green')
    return sheet
