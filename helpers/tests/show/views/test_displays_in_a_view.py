"""Displays in a `TfView`, fed over ROS: what comes, and what the status says when nothing comes."""

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan as LaserScanMsg
from std_msgs.msg import String
from tf2_ros import StaticTransformBroadcaster
from visualization_msgs.msg import Marker as MarkerMsg
from visualization_msgs.msg import MarkerArray as MarkerArrayMsg

from helpers import spin_for, wait_for
from helpers.show.views import LaserScan, Marker, MarkerArray, RobotModel, TfView
from helpers.tests.show.views.test_displays import ROBOT, marker, scan


def problem(view, text: str) -> None:
    """Wait until a problem is told."""
    try:
        wait_for(lambda: text in '\n'.join(view.problems), timeout=30.0)
    except TimeoutError:
        raise AssertionError(f'it never said: {text}; now it says {view.problems}; there are {_publishers()}') from None


def _publishers() -> list[str]:
    """All publishers that a new node finds, for a message: one of a program that nobody awaits has its own name."""
    node = rclpy.create_node('asks')
    spin_for(1.0, node)
    return [
        f'{info.node_name} on {topic} ({info.qos_profile.reliability.name})'
        for topic, _ in node.get_topic_names_and_types()
        for info in node.get_publishers_info_by_topic(topic)
        if topic not in ('/rosout', '/parameter_events')
    ]


def test_scan_robot_and_marker_are_in_the_picture(ros):
    node = rclpy.create_node('sender')
    transforms = []
    for child in ('laser', 'base', 'map'):
        transforms.append(TransformStamped(child_frame_id=child))
        transforms[-1].header.frame_id, transforms[-1].transform.rotation.w = 'odom', 1.0
    StaticTransformBroadcaster(node).sendTransform(transforms)
    latched = RobotModel.default_qos()
    description = node.create_publisher(String, '/robot_description', latched)
    description.publish(String(data=ROBOT.format(mesh='/nowhere.stl')))
    scans = node.create_publisher(LaserScanMsg, '/scan', 10)
    markers = node.create_publisher(MarkerMsg, '/visualization_marker', 10)
    with TfView(RobotModel(), LaserScan(), Marker(), fixed_frame='odom', frames=False, live=False) as view:
        wait_for(lambda: scans.get_subscription_count() and markers.get_subscription_count())
        scans.publish(scan())
        markers.publish(marker(MarkerMsg.TEXT_VIEW_FACING, text='the dock'))
        shown = ('RobotModel/base/0', 'LaserScan/message', 'Marker/n/0/0')
        wait_for(lambda: set(shown) <= {item.path for item in view.scene.items()}, timeout=30.0)  # trimesh is imported
        problem(view, 'RobotModel: link [wheel]: /nowhere.stl: there is no file')
    svg = view.picture().svg
    for drawn in ('<polygon', '<circle', 'stroke="#d42b2b"', '>the dock<', 'there is no file /nowhere.stl'):
        assert drawn in svg


def test_why_nothing_comes(ros):
    node = rclpy.create_node('sender')
    scans = node.create_publisher(LaserScanMsg, '/scan', qos_profile_sensor_data)
    node.create_publisher(String, '/robot_description', 10)
    node.create_publisher(String, '/front', 10)
    displays = (
        LaserScan(),
        RobotModel(),
        LaserScan('/front'),
        LaserScan('/rear'),
        LaserScan(qos=qos_profile_sensor_data),
    )
    with TfView(*displays, fixed_frame='laser', live=False) as view:
        problem(
            view,
            'LaserScan: incompatible QoS on [/scan]: reliability: the publisher offers BEST_EFFORT, '
            'this display asks for RELIABLE',
        )
        problem(
            view,
            'RobotModel: incompatible QoS on [/robot_description]: durability: the publisher offers '
            'VOLATILE, this display asks for TRANSIENT_LOCAL',
        )
        problem(view, 'LaserScan 2: [/front] carries std_msgs/msg/String, not sensor_msgs/msg/LaserScan')
        problem(view, 'LaserScan 3: no publisher on [/rear]')
        problem(view, 'LaserScan 4: no message on [/scan] so far')
        # Nobody sends again what is lost, and the display may find the publisher later than the publisher finds it.
        wait_for(lambda: scans.publish(scan()) or 'LaserScan 4: ' not in '\n'.join(view.problems))
        assert displays[4].status() == '' and view.scene.below('LaserScan 4').items()


def test_what_was_sent_before_the_display_came_is_seen(ros):
    """Of publishers that keep their last message, whether they or the display came first."""
    node = rclpy.create_node('sender')
    latched = RobotModel.default_qos()
    walls = node.create_publisher(MarkerArrayMsg, '/walls', latched)
    walls.publish(MarkerArrayMsg(markers=[marker()]))
    early, late, asked = MarkerArray('/walls'), MarkerArray('/later'), MarkerArray('/walls', qos=10)
    with TfView(early, late, asked, fixed_frame='map', live=False):
        wait_for(lambda: early.markers)
        later = node.create_publisher(MarkerArrayMsg, '/later', latched)
        later.publish(MarkerArrayMsg(markers=[marker()]))
        wait_for(lambda: late.markers)
        assert asked.markers == []
