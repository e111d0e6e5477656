"""Chapter 5: the three services and two topics of an action."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'Between the action client and the action server there are five connections below /fibonacci/_action. Three '
    'are services that the client calls: send_goal, cancel_goal and get_result. Two are topics on which the '
    'server publishes: feedback and status.'
)
WIRES = (
    ('send_goal', 'service: the goal; accepted or not', True),
    ('cancel_goal', 'service: which goals to stop; which ones will', True),
    ('get_result', 'service: the answer comes at the end of the goal', True),
    ('feedback', 'topic: how far it is', False),
    ('status', 'topic, latched: the state of each goal', False),
)


def draw():
    sheet = Sheet('The five connections of an action', height=330)
    client = sheet.box(16, 20, 110, 290, 'action\nclient')
    server = sheet.box(574, 20, 110, 290, 'action\nserver', colour='violet')
    for number, (name, what, service) in enumerate(WIRES):
        y = 52 + 58 * number
        begin, end = (client.x + client.w, y), (server.x, y)
        colour = 'blue' if service else 'violet'
        if service:
            sheet.arrow(begin, end, colour=colour, both=True)
        else:
            sheet.arrow(end, begin, colour=colour, dashed=True)
        sheet.text(140, y - 13, f'`/fibonacci/_action/{name}`', anchor='start', size=NOTE)
        sheet.text(350, y + 13, what, size=NOTE, colour='muted')
    return sheet
