"""Chapter 3: a queue of depth 3, and twenty numbers."""

from grading.authoring.drawing import NOTE, Sheet, queue

ALT = (
    'Twenty numbers, 0 to 19, are published while nobody spins. The queue of the subscription has the depth 3. It '
    'keeps 17, 18 and 19; the older ones, 0 to 16, were pushed out, the oldest first, with no warning. When '
    'somebody spins, the callback sees 17, 18, 19.'
)


def draw():
    sheet = Sheet('What a queue of depth 3 keeps', height=196)
    sheet.text(20, 30, 'published', anchor='start', size=NOTE, bold=True)
    for number in range(20):
        kept = number >= 17
        sheet.box(
            20 + 33 * number, 46, 33, 32, str(number), colour='orange' if kept else 'muted', plain=not kept, round=0
        )
    sheet.text(290, 96, 'pushed out, the oldest first, with no warning', size=NOTE, colour='muted')
    cells = queue(sheet, 430, 130, ['19', '18', '17'], height=36)
    sheet.text(418, 148, 'queue, depth 3', anchor='end', size=NOTE)
    sheet.arrow((630, 78), (496, 130))
    sheet.arrow(cells.right, (684, 148), 'to the callback', at=0.5, side='below')
    return sheet
