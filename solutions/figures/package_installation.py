"""Chapter 2: where the parts of a package go when it is built."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'Left the package in src, right its installation. The Python package goes to site-packages, said by packages '
    'in setup.py. The marker in resource and package.xml go to share, said by data_files. Each entry point '
    'becomes a script in lib/py_talker_listener, in the folder that setup.cfg names.'
)
ROWS = (
    (
        '`py_talker_listener/`\nthe Python package',
        '`packages`',
        '`lib/python3.…/site-packages/`\n`py_talker_listener/`',
    ),
    (
        '`resource/`\n`py_talker_listener`',
        '`data_files`',
        '`share/ament_index/resource_index/`\n`packages/py_talker_listener`',
    ),
    ('`package.xml`', '`data_files`', '`share/py_talker_listener/`\n`package.xml`'),
    ('a line of\n`entry_points`', '`entry_points`\n`setup.cfg`', '`lib/py_talker_listener/`\n`talker`'),
)


def draw():
    sheet = Sheet('From the package to its installation', height=340)
    sheet.box(16, 16, 220, 308, heading='src/py_talker_listener', colour='muted')
    sheet.box(374, 16, 310, 308, heading='install/py_talker_listener', colour='green')
    for number, (source, how, target) in enumerate(ROWS):
        y = 48 + 68 * number
        left = sheet.box(32, y, 188, 52, source, plain=True, size=NOTE)
        right = sheet.box(380, y, 298, 52, target, plain=True, size=NOTE)
        sheet.line([left.right, (242, y + 26)])
        sheet.arrow((242, y + 26), right, how, at=0.42)
    return sheet
