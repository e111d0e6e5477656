"""Chapter 8: the four states of a managed node."""

from grading.authoring.drawing import Sheet

ALT = (
    'The states of a lifecycle node. configure leads from unconfigured to inactive, activate from inactive to '
    'active. deactivate and cleanup lead back. From each of these three states, shutdown leads to finalized.'
)


def draw():
    sheet = Sheet('The life cycle of a node', height=214)
    states = [
        sheet.box(x, 40, 130, 44, name, colour=colour)
        for x, name, colour in ((16, 'unconfigured', 'muted'), (285, 'inactive', 'blue'), (554, 'active', 'green'))
    ]
    for one, other, forth, back in zip(
        states, states[1:], ('configure', 'activate'), ('cleanup', 'deactivate'), strict=False
    ):
        sheet.arrow(one.on('right', 0.3), other.on('left', 0.3), f'`{forth}`')
        sheet.arrow(other.on('left', 0.7), one.on('right', 0.7), f'`{back}`', side='below')
    final = sheet.box(285, 152, 130, 44, 'finalized', colour='red', dashed=True)
    sheet.arrow(states[0].bottom, final.left, via=[(81, 174)], label='`shutdown`', at=0.7, side='above')
    sheet.arrow(states[1], final, '`shutdown`')
    sheet.arrow(states[2].bottom, final.right, via=[(619, 174)], label='`shutdown`', at=0.7, side='above')
    return sheet
