"""Chapter 8: the node delivery_robot and everything around it."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'The node delivery_robot with its three classes: StationKeeper with parameters, status and stations; Courier '
    'with tf2 and the motor; DeliveryRobot with the action, which uses the function steer. A customer calls '
    'set_station and sends goals to go_to_station. The world sends /tf and gets cmd_vel. status tells everybody '
    'what the robot does. The file delivery.yaml gives the parameters.'
)


def draw():
    sheet = Sheet('The delivery robot', height=380)
    sheet.box(230, 70, 250, 240, heading='node delivery_robot')
    keeper = sheet.box(246, 100, 218, 52, '`StationKeeper`\nparameters, status, stations', plain=True, size=NOTE)
    courier = sheet.box(246, 172, 218, 52, '`Courier`\nwhere am I? drive', plain=True, size=NOTE)
    robot = sheet.box(246, 244, 218, 52, '`DeliveryRobot`\nthe action, with `steer()`', plain=True, size=NOTE)
    sheet.box(16, 100, 90, 196, 'customer', colour='violet')
    sheet.box(594, 150, 90, 96, 'world', colour='green')
    sheet.box(246, 16, 218, 34, '`config/delivery.yaml`', colour='orange', size=NOTE)
    sheet.box(594, 70, 90, 40, 'anybody', colour='muted', size=NOTE)
    sheet.arrow((430, 50), (430, 100))
    sheet.arrow((106, 126), (246, 126), '`set_station`', at=0.42, both=True)
    sheet.arrow((106, 270), (246, 270), '`go_to_station`', at=0.43, both=True)
    sheet.arrow((464, 112), (594, 90), '`status`', at=0.55)
    sheet.arrow((594, 184), (464, 184), '`/tf`', at=0.45)
    sheet.arrow((464, 212), (594, 212), '`cmd_vel`', side='below', at=0.55)
    sheet.arrow(keeper, courier)
    sheet.arrow(courier, robot)
    sheet.text(355, 340, 'each class adds to the one above it', size=NOTE, colour='muted')
    return sheet
