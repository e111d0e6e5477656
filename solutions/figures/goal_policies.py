"""Chapter 5: three ways to treat a second goal."""

from grading.authoring.drawing import Lanes, Sheet

ALT = (
    'Three time lines of two goals, the second sent while the first runs. Refuse: the second one is rejected. '
    'Queue: it is accepted, waits, and begins when the first has ended. Preempt: it begins at once, and the first '
    'one ends as aborted.'
)


def draw():
    sheet = Sheet('Three policies for a second goal', height=330)
    for number, (name, how) in enumerate((('refuse', 'rejected'), ('queue', 'waits'), ('preempt', ''))):
        y = 40 + 104 * number
        sheet.text(20, y + 20, f'**{name}**', anchor='start')
        lanes = Lanes(sheet, ['first goal', 'second goal'], y=y, step=40, left=210, right=684, end=10)
        if name == 'preempt':
            lanes.bar(0, 0, 3.2, 'aborted', colour='red')
            lanes.bar(1, 3, 8, 'runs', colour='green')
        else:
            lanes.bar(0, 0, 5, 'runs', colour='green')
        if name == 'queue':
            lanes.bar(1, 3, 5, how, colour='orange', dashed=True)
            lanes.bar(1, 5, 9.6, 'runs', colour='green')
        if name == 'refuse':
            lanes.bar(1, 3, 4.9, how, colour='red', dashed=True)
    return sheet
