"""Chapter 5: three servers on which a cancel request fails, and one that stops."""

from grading.authoring.drawing import NOTE, Lanes, Sheet

ALT = (
    'Four time lines of a goal that would take 1.6 s, with a cancel request at 0.5 s. Plain server: the request '
    'is answered at the end, and refused. With a cancel callback but one thread: the same, for the request is '
    'heard when the goal is over. With several threads: accepted at once, but nobody looks, and the goal runs to '
    'its end. With a look in each step: the goal ends as canceled at 0.6 s.'
)
CASES = (
    ('no cancel callback, one thread', 1.6, 1.6, 'refused: no\ncancel callback'),
    ('with a cancel callback, one thread', 1.6, 1.6, 'refused: the\ngoal is over'),
    ('with several threads, but nobody looks', 1.6, 0.5, 'accepted'),
    ('a look in each step, and `canceled()`', 0.6, 0.5, 'accepted'),
)


def draw():
    sheet = Sheet('Why a goal does not stop', height=560)
    for number, (title, end, answered, answer) in enumerate(CASES):
        y = 24 + 132 * number
        good = end < 1
        sheet.text(20, y, f'**{number + 1}**  {title}', anchor='start')
        lanes = Lanes(sheet, ['client', 'server'], y=y + 34, step=60, left=90, right=684, end=2.2)
        lanes.bar(
            1, 0, end, 'canceled' if good else '`execute`, with all numbers', colour='green' if good else 'violet'
        )
        (x, top), bottom = lanes.at(0, 0.5), y + 81
        sheet.arrow((x, top), (x, bottom), 'cancel', side='left', colour='orange')
        late = answered > 1
        ax = lanes.x(answered) + (6 if late else 12)
        if late:
            sheet.line([(x + 6, y + 72), (ax, y + 72)], dashed=True, colour='orange')
            sheet.text((x + ax) / 2, y + 57, 'the request waits', size=NOTE, colour='orange')
        sheet.arrow(
            (ax, bottom if not late else y + 72), (ax, top), answer, side='right', colour='red' if late else 'green'
        )
    return sheet
