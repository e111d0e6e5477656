"""Chapter 4: which calls may run side by side."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'A table with four small time lines of three calls a, b and c. With a mutually exclusive group they run one '
    'after the other, with one thread and with several. With a reentrant group and one thread they run one after '
    'the other, too. Only a reentrant group and several threads let them run side by side.'
)


def cell(sheet, x, y, threads, side_by_side):
    """Three calls on one thread or on three."""
    sheet.box(x, y, 256, 116, colour='green' if side_by_side else 'muted', plain=True)
    for thread in range(threads):
        height = y + 22 + 28 * thread + (28 if threads == 1 else 0)
        sheet.arrow((x + 12, height), (x + 244, height))
    for number, name in enumerate('abc'):
        row = 1 if threads == 1 else number
        begin = x + 22 + (0 if side_by_side else 68 * number)
        sheet.box(begin, y + 11 + 28 * row, 64, 22, name, colour='violet', round=3, size=NOTE)
    sheet.text(x + 128, y + 102, 'side by side' if side_by_side else 'one at a time', size=NOTE, bold=side_by_side)


def draw():
    sheet = Sheet('Callback group and executor', height=310)
    sheet.text(288, 24, 'one thread', bold=True)
    sheet.text(556, 24, 'several threads', bold=True)
    sheet.text(80, 98, 'mutually\nexclusive group\n(default)', size=NOTE)
    sheet.text(80, 234, 'reentrant\ngroup', size=NOTE)
    cell(sheet, 160, 40, 1, False)
    cell(sheet, 428, 40, 3, False)
    cell(sheet, 160, 176, 1, False)
    cell(sheet, 428, 176, 3, True)
    return sheet
