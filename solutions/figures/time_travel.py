"""Chapter 6: one frame at two times, and a frame that stands still between them."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'A track with metres from 0 to 12, fixed to the station. At second 105 the train is at 5 m and the cow '
    'exactly beside it. At second 112 the train is at 12 m. Seen from the train of second 112, the place that it '
    'had at second 105 is 7 m behind. The look-up goes from the train then over the fixed frame station to the '
    'train later.'
)
LEFT, METRE = 60, 48


def draw():
    sheet = Sheet('A look-up at two times', height=290)
    x = [LEFT + METRE * metre for metre in range(13)]
    sheet.line([(x[0] - 20, 150), (x[12] + 30, 150)], colour='ink')
    for metre in range(13):
        sheet.line([(x[metre], 150), (x[metre], 157)], colour='ink')
        sheet.text(x[metre], 169, str(metre), size=NOTE)
    sheet.box(16, 190, 200, 34, '`station`: the fixed frame', colour='green', size=NOTE)
    sheet.arrow((60, 190), (60, 181), colour='green')
    sheet.box(x[5] - 70, 96, 140, 38, '`train`, second 105', dashed=True, size=NOTE)
    sheet.box(x[12] - 92, 96, 144, 38, '`train`, second 112', size=NOTE)
    sheet.dot(x[5], 66, colour='orange')
    sheet.text(x[5] - 12, 66, 'cow', anchor='end', size=NOTE, colour='orange')
    sheet.arrow((x[12], 66), (x[5] + 8, 66), '7 m behind', colour='violet')
    sheet.line([(x[12], 66), (x[12], 96)], colour='violet', dashed=True)
    sheet.text(x[5], 28, 'source: `train` at 105', size=NOTE)
    sheet.text(690, 28, 'target: `train` at 112', anchor='end', size=NOTE)
    sheet.line([(x[5], 180), (x[5], 262)], colour='green', dashed=True)
    sheet.arrow((x[5], 262), (x[12], 262), 'only a frame that stands still\ncan connect the two times', colour='green')
    sheet.line([(x[12], 262), (x[12], 180)], colour='green', dashed=True)
    return sheet
