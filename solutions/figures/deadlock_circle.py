"""Chapter 4: the circle in which each one waits for the next."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'A circle of three. The callback on_timer waits for the future. The future waits until somebody takes the '
    'response out of the queue of the client. Only spin can take it, and spin waits until on_timer returns. The '
    'response is there, and nobody may take it.'
)


def draw():
    sheet = Sheet('The circle of the deadlock', height=330)
    sheet.box(240, 20, 220, 54, '`on_timer`\nstands in `client.call`', colour='violet', size=NOTE)
    future = sheet.box(462, 210, 220, 54, 'the future\nof the request', colour='orange', size=NOTE)
    spin = sheet.box(18, 210, 220, 54, '`spin`, or another thread\nof the executor', colour='green', size=NOTE)
    sheet.arrow((425, 74), (572, 210), 'waits until\nit is done', side='right', colour='red')
    sheet.arrow(future, spin, 'waits until the response\nis taken from the queue', side='below', colour='red')
    sheet.arrow((128, 210), (275, 74), 'waits until\nit returns', side='left', colour='red')
    sheet.box(256, 142, 188, 46, 'the response is there,\nin the queue of the client', colour='muted', size=NOTE)
    sheet.text(350, 310, 'Each one waits for the next. No error comes, and none will.', size=NOTE)
    return sheet
