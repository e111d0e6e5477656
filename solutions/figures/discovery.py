"""Chapter 1: a master in the middle, or none."""

from grading.authoring.drawing import Sheet

ALT = (
    'Left, ROS 1: camera, detector and arm each ask one program, roscore, for the others. Right, ROS 2: camera, '
    'detector and arm are connected to each other directly, and there is no centre.'
)


def draw():
    sheet = Sheet('Discovery with and without a master', height=250)
    sheet.text(175, 26, 'ROS 1: everybody asks the master', bold=True)
    master = sheet.box(115, 60, 120, 44, '`roscore`', colour='orange', round=22)
    for x, name in ((20, 'camera'), (125, 'detector'), (230, 'arm')):
        node = sheet.box(x, 180, 100, 40, name)
        sheet.arrow(node, master, 'asks' if name == 'detector' else '', dashed=True)
    sheet.line([(350, 20), (350, 230)])
    sheet.text(525, 26, 'ROS 2: everybody finds everybody', bold=True)
    detector = sheet.box(475, 60, 100, 40, 'detector')
    camera = sheet.box(385, 180, 100, 40, 'camera')
    arm = sheet.box(565, 180, 100, 40, 'arm')
    for one, other in ((camera, detector), (detector, arm), (camera, arm)):
        sheet.arrow(one, other, both=True)
    return sheet
