"""Chapter 8: the six charges of section 8.4, and what the robot does."""

from grading.authoring.drawing import NOTE, Plot, Sheet

ALT = (
    'A plot of six charges: 0.5, 0.19, 0.5, 0.89, 0.9 and 0.5. Below the threshold 0.2 the robot begins to '
    'charge, from 0.9 on it works again. In between it goes on with what it did: at the same charge 0.5 it works, '
    'then charges, then works.'
)
CHARGES = (0.5, 0.19, 0.5, 0.89, 0.9, 0.5)
STATES = ('working', 'charging', 'charging', 'charging', 'working', 'working')


def draw():
    sheet = Sheet('Two thresholds', height=300)
    plot = Plot(
        sheet, 70, 40, 520, 190, (0.5, 6.5), (0, 1), range(1, 7), (0, 0.2, 0.5, 0.9), 'call of next_state', 'charge'
    )
    for value, name in ((0.2, 'low'), (0.9, 'full')):
        plot.curve([(0.5, value), (6.5, value)], colour='muted', dashed=True)
        sheet.text(598, plot.at(0, value)[1], f'`{name}`', anchor='start', size=NOTE, colour='muted')
    values = list(zip(range(1, 7), CHARGES, strict=True))
    plot.curve(values, colour='muted')
    for value, state in zip(values, STATES, strict=True):
        plot.dots([value], colour='green' if state == 'working' else 'orange', hollow=state == 'charging')
    for x, word, colour, dx, dy in (
        (1, 'working', 'green', 0, -16),
        (3, 'charging', 'orange', 44, 6),
        (6, 'working', 'green', 0, 18),
    ):
        sx, sy = plot.at(x, 0.5)
        sheet.text(sx + dx, sy + dy, word, size=NOTE, colour=colour)
    return sheet
