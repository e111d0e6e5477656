"""Chapter 1: which variables of a terminal sourcing changes."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'Two terminals. Before sourcing, PATH names the folders of the system, and AMENT_PREFIX_PATH, PYTHONPATH and '
    'ROS_DISTRO are not set. After source setup.bash, a folder of the prefix is in front of PATH, and the other '
    'three are set. A second terminal that is opened beside it knows nothing of it.'
)
ROWS = (
    ('PATH', '/usr/bin:/bin', 'PREFIX/bin:/usr/bin:/bin'),
    ('AMENT_PREFIX_PATH', '(not set)', 'PREFIX'),
    ('PYTHONPATH', '(not set)', 'PREFIX/lib/python…'),
    ('ROS_DISTRO', '(not set)', 'jazzy'),
)


def draw():
    sheet = Sheet('What sourcing changes', height=290)
    sheet.box(170, 20, 200, 190, heading='terminal, before', colour='muted')
    sheet.box(420, 20, 264, 190, heading='the same terminal, after', colour='green')
    for number, (name, before, after) in enumerate(ROWS):
        y = 66 + 38 * number
        sheet.text(160, y, f'`{name}`', anchor='end', size=NOTE)
        sheet.text(182, y, before if before.startswith('(') else f'`{before}`', anchor='start', size=NOTE)
        sheet.text(432, y, f'`{after}`', anchor='start', size=NOTE)
    sheet.arrow((370, 115), (420, 115))
    sheet.text(395, 232, '`source PREFIX/setup.bash`', size=NOTE)
    sheet.line([(395, 219), (395, 121)], dashed=True)
    sheet.box(420, 250, 264, 30, 'a second terminal: still as before', colour='muted', dashed=True, size=NOTE)
    return sheet
