"""What the tutorials on URDF start: a robot from a package, as topics and frames."""

import pytest
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from environment.tests.running import PATIENCE, ROS2

pytestmark = pytest.mark.usefixtures('domain')

ROBOT = ('urdf_package:=mobile_robot_description', 'urdf_package_path:=urdf/mobile_robot.urdf')


@pytest.fixture
def heard(peer):
    """What comes on a topic; a late subscriber gets what was published before."""

    def on(kind, topic):
        messages = []
        late = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        peer.node.create_subscription(kind, topic, messages.append, late if kind is String else 10)
        return messages

    return on


def test_a_description_is_published(start, peer, heard):
    launched = start(ROS2, 'launch', 'urdf_launch', 'description.launch.py', *ROBOT)
    texts = heard(String, 'robot_description')
    peer.until(lambda: texts, 'the description')
    assert '<robot' in texts[0].data and 'left_wheel' in texts[0].data
    assert launched.stop(PATIENCE) == 0


@pytest.mark.parametrize('window', ['true', 'false'])
def test_a_robot_is_displayed_as_far_as_programs_are_here(start, peer, heard, window):
    launched = start(ROS2, 'launch', 'urdf_launch', 'display.launch.py', *ROBOT, f'jsp_gui:={window}')
    states = heard(JointState, 'joint_states')
    peer.until(lambda: states, 'joint states')
    assert {'left_wheel_joint', 'right_wheel_joint'} <= set(states[0].name)
    launched.wait_for_output('rviz2 is not installed', PATIENCE)
    assert ('joint_state_publisher_gui is not installed' in launched.output) == (window == 'true')
    assert launched.stop(PATIENCE) == 0
