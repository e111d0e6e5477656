"""Chapter 2: three layers, and which package is found first."""

from grading.authoring.drawing import NOTE, Sheet, stack

ALT = (
    'Three layers. On top the workspace top_ws with py_talker_listener version 4, below it ros2_ws with '
    'py_talker_listener version 3 and greeter, at the bottom the ROS installation with rclpy and std_msgs. A '
    'package is looked up from the top: version 4 is found first and hides version 3; greeter is found one layer '
    'lower.'
)


def draw():
    sheet = Sheet('Layers of workspaces', height=300)
    layers = (
        ('top_ws: overlay of ros2_ws', 'orange'),
        ('ros2_ws: overlay of ROS', 'blue'),
        ('the ROS installation: the underlay', 'muted'),
    )
    stack(sheet, 130, 20, 550, layers, h=80, gap=10, heading=True)
    sheet.box(150, 54, 250, 34, '`py_talker_listener`, version 4', plain=True, size=NOTE, colour='orange')
    sheet.box(150, 144, 250, 34, '`py_talker_listener`, version 3', plain=True, size=NOTE, dashed=True)
    sheet.text(420, 161, 'hidden', anchor='start', size=NOTE, colour='muted')
    sheet.box(520, 144, 140, 34, '`greeter`', plain=True, size=NOTE)
    sheet.box(150, 234, 120, 34, '`rclpy`', plain=True, size=NOTE, colour='muted')
    sheet.box(290, 234, 120, 34, '`std_msgs`', plain=True, size=NOTE, colour='muted')
    sheet.arrow((100, 24), (100, 276))
    sheet.text(54, 150, 'looked up\nfrom the\ntop, first\nhit wins', size=NOTE)
    return sheet
