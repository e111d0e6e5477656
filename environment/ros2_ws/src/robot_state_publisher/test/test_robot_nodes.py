"""The programs, started as a user starts them: their topics, parameters, log lines and exit status."""

import itertools

import pytest
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from environment.tests.robots import ARM, joint, robot
from environment.tests.running import PATIENCE, ended, program

LATCHED = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
LAUNCH = """
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    description = ParameterValue(Command(['xacro ', '{file}']), value_type=str)
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', namespace='left',
             parameters=[{{'robot_description': description, 'frame_prefix': 'left/'}}]),
        Node(package='joint_state_publisher', executable='joint_state_publisher', namespace='left',
             parameters=[{{'rate': 20, 'zeros.wheel': 0.5}}]),
    ])
"""
XACRO = """<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="r" value="0.1"/>
  <link name="base"/><link name="wheel_link"/>
  <joint name="wheel" type="continuous"><parent link="base"/><child link="wheel_link"/>
    <origin xyz="0 0 ${2 * r}"/><axis xyz="0 1 0"/></joint>
</robot>"""


class Listener:
    """What a peer hears of robot_state_publisher."""

    def __init__(self, peer):
        self.peer = peer
        self.tf, self.static, self.descriptions = [], [], []
        peer.node.create_subscription(TFMessage, '/tf', lambda m: self.tf.extend(m.transforms), 100)
        peer.node.create_subscription(TFMessage, '/tf_static', self._on_static, LATCHED)
        peer.node.create_subscription(String, '/robot_description', lambda m: self.descriptions.append(m.data), LATCHED)

    def _on_static(self, message):
        self.static = message.transforms

    def send(self, publisher, stamp: float, **positions: float) -> None:
        """Send a joint state."""
        message = JointState(name=list(positions), position=list(positions.values()))
        message.header.stamp.sec, message.header.stamp.nanosec = int(stamp), round(stamp % 1 * 1e9)
        publisher.publish(message)

    def joint_states(self):
        """A publisher of joint states, best effort as its reader; what it sends leads to transforms that come here."""
        qos = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
        publisher = self.peer.node.create_publisher(JointState, '/joint_states', qos)
        stamps = itertools.count(1.0)

        def comes() -> bool:
            self.send(publisher, next(stamps), lift=0.0)
            return bool(self.tf)

        self.peer.until(comes, 'transforms on /tf')
        return publisher

    def set_parameter(self, name: str, value: ParameterValue):
        """Set a parameter of the node; return the result."""
        request = {'parameters': [Parameter(name=name, value=value)]}
        return self.peer.call(SetParameters, '/robot_state_publisher/set_parameters', **request).results[0]


@pytest.fixture
def listener(peer):
    return Listener(peer)


@pytest.fixture
def arm_file(tmp_path):
    path = tmp_path / 'arm.urdf'
    path.write_text(ARM)
    return str(path)


def text(value: str) -> ParameterValue:
    return ParameterValue(type=ParameterType.PARAMETER_STRING, string_value=value)


def test_robot_state_publisher(start, listener, arm_file):
    process = start(program('robot_state_publisher', 'robot_state_publisher'), arm_file)
    until = listener.peer.until
    until(lambda: listener.static and listener.descriptions, 'the static transforms and the description')
    assert listener.descriptions == [ARM]
    assert [(t.header.frame_id, t.child_frame_id) for t in listener.static] == [('base', 'camera')]
    process.wait_for_output('[INFO] [robot_state_publisher]: Robot initialized', PATIENCE)
    declared = listener.peer.call(
        GetParameters,
        '/robot_state_publisher/get_parameters',
        names=['robot_description', 'publish_frequency', 'frame_prefix', 'ignore_timestamp'],
    )
    values = declared.values
    assert [values[0].string_value, values[1].double_value, values[2].string_value, values[3].bool_value] == [
        ARM,
        20.0,
        '',
        False,
    ]

    # At most 20 transforms a second, by the stamps: the one after 40 ms is left out, the one after 50 ms is not.
    publisher = listener.joint_states()
    for stamp in (1000.0, 1000.04, 1000.05):
        listener.send(publisher, stamp, shoulder=1.0, lift=stamp - 1000)
    tf = until(
        lambda: (found := [t for t in listener.tf if t.header.stamp.sec >= 1000])[5:] and found,
        'two transforms of each joint',
    )
    assert [t.child_frame_id for t in tf] == ['finger', 'slider', 'upper'] * 2
    assert [t.header.stamp.nanosec for t in tf] == [0] * 3 + [50_000_000] * 3
    assert tf[4].transform.translation.x == pytest.approx(0.05)

    publisher.publish(JointState(name=['lift']))
    publisher.publish(JointState(name=['lift'], position=[1.0, 2.0]))
    process.wait_for_output('ignored an invalid JointState message', PATIENCE)
    assert 'ignored a JointState message about joint(s) "lift"(,...) whose position member was empty.' in process.output

    # A bad description is refused and the old one goes on; a good one is taken at once.
    refused = listener.set_parameter('robot_description', text(robot(joint(child='laser'))))
    assert not refused.successful
    assert refused.reason.startswith("bad robot_description: line 4: joint 'j': its child 'laser' is no link")
    assert not listener.set_parameter(
        'publish_frequency', ParameterValue(type=ParameterType.PARAMETER_DOUBLE, double_value=0.0)
    ).successful
    assert listener.set_parameter(
        'ignore_timestamp', ParameterValue(type=ParameterType.PARAMETER_BOOL, bool_value=True)
    ).successful
    assert listener.set_parameter('robot_description', text(robot(joint()))).successful
    until(lambda: len(listener.descriptions) == 2, 'the new description')
    until(lambda: {'camera', 'b'} == {t.child_frame_id for t in listener.static}, 'the new static transform')
    assert listener.set_parameter('robot_description', text(robot(joint('continuous')))).successful
    listener.tf.clear()
    listener.send(publisher, 0.0, j=1.0)
    until(lambda: listener.tf, 'a transform, whatever its stamp')
    assert listener.tf[0].child_frame_id == 'b'
    assert process.stop(PATIENCE) == 0 and 'Traceback' not in process.output


@pytest.mark.parametrize(
    ('name', 'content', 'says'),
    [
        ('robot_state_publisher', None, '[FATAL] [robot_state_publisher]: the parameter robot_description is empty'),
        (
            'robot_state_publisher',
            robot(),
            "[FATAL] [robot_state_publisher]: bad robot_description: the links 'a' and 'b'",
        ),
        ('joint_state_publisher', '<robot', '/robot.urdf: line 1: this is no XML'),
    ],
)
def test_a_bad_description_ends_the_program_in_one_line(start, tmp_path, name, content, says):
    path = tmp_path / 'robot.urdf'
    path.write_text(content or '')
    status, output = ended(start(program(name, name), *([str(path)] if content else [])))
    assert status == 1 and says in output and 'Traceback' not in output


def test_a_description_that_is_no_yaml_is_said_in_one_line(start):
    status, output = ended(
        start(
            program('robot_state_publisher', 'robot_state_publisher'),
            '--ros-args',
            '-p',
            'robot_description:=<!-- robot: a\nrobot -->',
        )
    )
    assert (
        status == 1
        and output.splitlines()[-1].startswith(
            'robot_state_publisher: the value of -p robot_description:=… is not YAML'
        )
        and 'Traceback' not in output
    )


def test_launch_of_xacro_and_both_publishers(start, listener, tmp_path):
    """In a namespace, with a prefix of the frames: the whole way from macros to /tf."""
    (tmp_path / 'cart.urdf.xacro').write_text(XACRO)
    launch = tmp_path / 'cart.launch.py'
    launch.write_text(LAUNCH.format(file=tmp_path / 'cart.urdf.xacro'))
    process = start('ros2', 'launch', str(launch))
    listener.peer.until(lambda: listener.tf, f'transforms; the launch says:\n{process.output}')
    wheel = listener.tf[0]
    assert (wheel.header.frame_id, wheel.child_frame_id) == ('left/base', 'left/wheel_link')
    assert wheel.transform.translation.z == pytest.approx(0.2)
    assert wheel.transform.rotation.y == pytest.approx(0.24740396, abs=1e-6)  # sin(0.5 / 2)
    assert process.stop(PATIENCE) == 0


def test_joint_state_publisher_takes_other_sources(start, peer, arm_file):
    start(
        program('joint_state_publisher', 'joint_state_publisher'),
        arm_file,
        '--ros-args',
        '-p',
        'rate:=50',
        '-p',
        "source_list:=['/motor']",
        '-p',
        'dependent_joints.lift.parent:=shoulder',
    )
    states = peer.listen(JointState, '/joint_states')
    first = peer.until(lambda: states, 'a joint state')[0]
    assert (first.name, first.position[0]) == (['shoulder', 'lift', 'grip'], pytest.approx(1.1))
    motor = peer.publisher(JointState, '/motor')
    motor.publish(JointState(name=['shoulder', 'grip'], position=[0.75, 9.0]))
    peer.until(lambda: states[-1].position[0] == 0.75, 'the position of the motor')
    assert list(states[-1].position) == pytest.approx([0.75, 0.75, -1.25])  # the others follow


def test_xacro_is_known_to_ros(start, tmp_path):
    (tmp_path / 'cart.urdf.xacro').write_text(XACRO)
    status, output = ended(start('ros2', 'run', 'xacro', 'xacro', str(tmp_path / 'cart.urdf.xacro')))
    assert status == 0 and '<origin xyz="0 0 0.2"/>' in output


def test_xacro_tells_that_a_file_is_not_there(start):
    status, output = ended(start('ros2', 'run', 'xacro', 'xacro', '/nowhere.urdf'))
    assert status == 2 and 'No such file or directory: /nowhere.urdf' in output and 'Traceback' not in output
