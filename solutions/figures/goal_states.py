"""Chapter 5: the states of a goal, and which call makes which step."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'The states of a goal. The goal callback answers ACCEPT or REJECT; after REJECT there is no goal. ACCEPTED '
    'becomes EXECUTING by execute(). From EXECUTING, succeed() leads to SUCCEEDED and abort() to ABORTED. A '
    'cancel request that is accepted leads from ACCEPTED or EXECUTING to CANCELING, from there canceled() leads to '
    'CANCELED; succeed() and abort() are possible, too.'
)


def draw():
    sheet = Sheet('The states of a goal', height=370)
    asked = sheet.box(16, 30, 100, 40, 'goal', colour='muted')
    rejected = sheet.box(16, 130, 100, 40, 'rejected', colour='muted', dashed=True)
    accepted = sheet.box(196, 30, 120, 40, '`ACCEPTED`')
    executing = sheet.box(196, 130, 120, 40, '`EXECUTING`')
    canceling = sheet.box(196, 270, 120, 40, '`CANCELING`', colour='orange')
    sheet.box(440, 84, 244, 132, colour='muted', plain=True)
    for y, call, state, colour in ((100, 'succeed()', 'SUCCEEDED', 'green'), (160, 'abort()', 'ABORTED', 'red')):
        sheet.text(448, y + 20, f'`{call}`', anchor='start', size=NOTE, colour=colour)
        box = sheet.box(564, y, 108, 40, f'`{state}`', colour=colour)
        sheet.arrow((530, y + 20), box, colour=colour)
    canceled = sheet.box(564, 270, 108, 40, '`CANCELED`', colour='orange')
    sheet.arrow(asked, accepted, '`ACCEPT`')
    sheet.arrow(asked, rejected, '`REJECT`')
    sheet.arrow(accepted, executing, '`execute()`')
    sheet.arrow(executing, canceling, 'a cancel request\nis accepted', side='left')
    sheet.arrow(executing, (440, 150), 'one of the two')
    sheet.arrow(canceling.on('right', 0.2), (440, 200), 'or one\nof the two', side='above', at=0.4)
    sheet.arrow(canceling, canceled, '`canceled()`', colour='orange', side='below')
    sheet.text(
        350, 346, 'The calls are those of the goal handle. A cancel may also come before `execute()`.', size=NOTE
    )
    return sheet
