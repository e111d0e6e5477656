"""Chapter 2: what the three parts of an entry point lead to."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'An entry point has three parts: talker, py_talker_listener.talker and main. The name becomes a script that '
    'ros2 run finds and starts. The script imports the module and calls the function. Below, what a mistake in '
    'each part gives: No executable found, ModuleNotFoundError, AttributeError.'
)
PARTS = (
    ('talker', 'name', 'blue', 40, 80, 'script `talker`\nin `lib/`\n`py_talker_listener`', 'No executable found'),
    ('py_talker_listener.talker', 'module', 'green', 176, 240, 'module `talker.py`', 'ModuleNotFoundError'),
    ('main', 'function', 'violet', 470, 60, 'function `main()`', 'AttributeError'),
)
X = 40


def draw():
    sheet = Sheet('From the entry point to the function', height=316)
    boxes = {}
    for text, name, colour, x, w, _, _ in PARTS:
        sheet.text(x + w / 2, 24, name, size=NOTE, colour=colour)
        boxes[name] = sheet.box(x, 38, w, 34, f'`{text}`', colour=colour)
    sheet.text(151, 55, '`=`', bold=True)
    sheet.text(439, 55, '`:`', bold=True)
    sheet.text(560, 55, 'a line of `setup.py`', anchor='start', size=NOTE, colour='muted')
    below = {}
    for (_, name, colour, _, _, text, fault), x, w in zip(PARTS, (16, 250, 486), (168, 168, 168), strict=True):
        below[name] = sheet.box(x, 150, w, 66, text, colour=colour, plain=True, size=NOTE)
        sheet.arrow(boxes[name].bottom, below[name].top, colour=colour)
        sheet.box(x, 262, w, 34, f'`{fault}`' if 'Error' in fault else fault, colour='red', dashed=True, size=NOTE)
        sheet.arrow(below[name].bottom, (x + w / 2, 262), colour='red', dashed=True)
        sheet.text(x + w / 2 + 10, 239, 'if it is wrong', anchor='start', size=NOTE, colour='red')
    sheet.arrow(below['name'], below['module'], 'imports')
    sheet.arrow(below['module'], below['function'], 'calls')
    return sheet
