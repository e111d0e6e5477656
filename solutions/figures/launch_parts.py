"""Chapter 8: what stands in a launch file, and what becomes of it."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'Left the launch file two_robots.launch.py: a LaunchDescription with two Node actions. package and executable '
    'say which program, namespace gives its names, parameters its values. Right two processes, '
    '/robot1/battery_monitor and /robot2/battery_monitor. Both read the one installed file config/robots.yaml.'
)


def draw():
    sheet = Sheet('The parts of a launch file', height=330)
    sheet.box(16, 16, 350, 298, heading='two_robots.launch.py', colour='muted')
    sheet.box(32, 48, 318, 250, heading='LaunchDescription', colour='muted', plain=True)
    for number, robot in enumerate(('robot1', 'robot2')):
        y = 80 + 108 * number
        node = sheet.box(48, y, 286, 96, heading='Node: starts a process')
        sheet.text(
            60,
            y + 58,
            f"`package`, `executable`: which program\n`namespace='{robot}'`: its names\n`parameters`: its values",
            anchor='start',
            size=NOTE,
        )
        process = sheet.box(
            456, y + 24 - 40 + 80 * number, 228, 48, f'process\n`/{robot}/battery_monitor`', colour='green', size=NOTE
        )
        sheet.arrow(node.on('right', 0.3 + 0.4 * number), process, 'starts', side='above')
        if number == 0:
            first = process
    file = sheet.box(456, 158, 228, 48, '`config/robots.yaml`\nin the installed package', colour='orange', size=NOTE)
    sheet.arrow(file, first, 'values', side='right')
    sheet.arrow(file, process, 'values', side='right')
    return sheet
