"""Chapter 2: what colcon builds first, and what the three options choose."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'Packages in two steps of a build. wheel_math, greeter and robot_interfaces need no other package of the '
    'workspace and are built at the same time. odometry needs wheel_math and is built after it. A frame shows '
    'that --packages-up-to odometry builds wheel_math and odometry, and that --packages-above wheel_math builds '
    'the same two.'
)


def draw():
    sheet = Sheet('The order of a build', height=270)
    sheet.text(150, 26, 'first: all at the same time', bold=True)
    sheet.text(530, 26, 'then', bold=True)
    sheet.box(30, 44, 640, 92, colour='green', dashed=True, plain=True)
    sheet.text(350, 122, '`--packages-up-to odometry` and `--packages-above wheel_math`', size=NOTE, colour='green')
    library = sheet.box(70, 60, 160, 40, '`wheel_math`')
    user = sheet.box(450, 60, 160, 40, '`odometry`', colour='violet')
    sheet.arrow(library, user, 'is built before')
    for y, name in ((152, 'robot_interfaces'), (208, 'greeter')):
        sheet.box(70, y, 160, 40, f'`{name}`')
    sheet.text(
        460, 200, 'The order comes from `package.xml` alone.\ncolcon never looks into the Python files.', size=NOTE
    )
    return sheet
