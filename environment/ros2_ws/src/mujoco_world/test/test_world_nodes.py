"""The world as a program: started by its launch file, driven and watched over topics."""

import math
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from geometry_msgs.msg import Twist
from mujoco_world import gazebo, scene
from mujoco_world.topics import Topics
from mujoco_world.world import World
from nav_msgs.msg import Odometry
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import SetParameters
from rclpy.time import Time
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, JointState, LaserScan
from std_srvs.srv import SetBool, Trigger
from tf2_ros import Buffer, TransformListener

from environment.tests.running import ROS2, program

STARTED = 'MuJoCo world "rooms" with the robot "mobile_robot"'


@pytest.fixture
def launched(start):
    """`ros2 launch mujoco_world world.launch.py`, four times as fast as real time."""
    process = start(ROS2, 'launch', 'mujoco_world', 'world.launch.py', 'real_time_factor:=4.0')
    process.wait_for_output(STARTED, timeout=30)
    process.wait_for_output('Robot initialized', timeout=30)
    return process


def test_the_launched_world_has_the_frames_and_topics_of_its_robot_and_can_be_driven(launched, peer):
    heard = {
        topic: peer.listen(kind, topic)
        for topic, kind in {
            '/clock': Clock,
            '/odom': Odometry,
            '/joint_states': JointState,
            '/scan': LaserScan,
            '/camera_info': CameraInfo,
        }.items()
    }
    buffer = Buffer()
    TransformListener(buffer, peer.node)
    command = peer.publisher(Twist, '/cmd_vel')
    # Time is nobody's but the world's.
    peer.until(lambda: all(heard.values()), 'a message on each topic')
    expect_frames(peer, buffer)
    expect_messages({topic: messages[-1] for topic, messages in heard.items()})
    expect_driving(launched, peer, command, heard['/odom'])
    expect_services(peer, heard['/odom'])
    expect_parameters(peer, heard['/scan'])


def expect_frames(peer, buffer):
    """REP 105: map -> odom -> base_footprint, and below it the robot's own."""
    peer.until(
        lambda: all(
            buffer.can_transform('map', frame, Time())
            for frame in ('base_footprint', 'laser', 'camera_optical_frame', 'left_wheel')
        ),
        'the frames',
    )
    tree = yaml.safe_load(buffer.all_frames_as_yaml())
    parents = {frame: entry['parent'] for frame, entry in tree.items()}
    assert parents == {
        'odom': 'map',
        'base_footprint': 'odom',
        'base_link': 'base_footprint',
        'caster': 'base_link',
        'laser': 'base_link',
        'camera': 'base_link',
        'camera_optical_frame': 'camera',
        'left_wheel': 'base_link',
        'right_wheel': 'base_link',
    }


def expect_messages(newest):
    """The newest message of each topic is the robot's."""
    scan, odometry, info = newest['/scan'], newest['/odom'], newest['/camera_info']
    assert (scan.header.frame_id, info.header.frame_id) == ('laser', 'camera_optical_frame')
    assert (odometry.header.frame_id, odometry.child_frame_id) == ('odom', 'base_footprint')
    assert info.k[0] == pytest.approx(info.width / 2 / math.tan(0.6)) and info.k[2] == info.width / 2
    assert newest['/joint_states'].name == ['left_wheel_joint', 'right_wheel_joint']
    assert len(scan.ranges) == 360 and scan.ranges[180] == pytest.approx(3.95, abs=0.06)


def expect_driving(launched, peer, command, odometry):
    """A command counts for half a second, and one that is no number for nothing."""
    twist = Twist()
    twist.linear.x = math.nan
    command.publish(twist)
    twist.linear.x = 0.5
    command.publish(twist)
    peer.until(lambda: odometry[-1].pose.pose.position.x > 0.1, 'the robot drives')
    peer.until(lambda: odometry[-1].twist.twist.linear.x < 0.001, 'the robot stops')
    launched.wait_for_output('ignoring a message on cmd_vel', timeout=30)


def expect_services(peer, odometry):
    """Pause, one step, reset. The world is paused then."""
    assert peer.call(SetBool, '/world/pause', data=True).success
    first = peer.call(Trigger, '/world/step').message
    second = peer.call(Trigger, '/world/step').message
    assert float(second.split()[1]) - float(first.split()[1]) == pytest.approx(0.02)
    assert peer.call(Trigger, '/world/reset').success
    peer.call(Trigger, '/world/step')
    peer.until(lambda: abs(odometry[-1].pose.pose.position.x) < 0.001, 'the robot at its start')


def expect_parameters(peer, scans):
    """Parameters that can be changed, and one that cannot; the world, which is paused, goes on."""

    def set_to(name, kind, **value):
        one = Parameter(name=name, value=ParameterValue(type=kind, **value))
        return peer.call(SetParameters, '/world/set_parameters', parameters=[one]).results[0].successful

    double = ParameterType.PARAMETER_DOUBLE
    assert set_to('range_noise', double, double_value=0.5)
    assert not set_to('range_noise', double, double_value=-1.0)
    assert not set_to('odometry_noise', double, double_value=math.nan)
    assert not set_to('scene', ParameterType.PARAMETER_STRING, string_value='empty')
    peer.call(SetBool, '/world/pause', data=False)
    peer.until(lambda: max(scans[-1].ranges[179:182]) - min(scans[-1].ranges[179:182]) > 0.1, 'noise on the scan')


def test_a_world_that_cannot_be_is_one_line_and_an_exit_status(domain):
    argv = [program('mujoco_world', 'world'), '--ros-args', '-p', 'scene:=attic']
    done = subprocess.run(argv, capture_output=True, text=True, timeout=60)
    assert done.returncode == 1 and done.stdout == ''
    (line,) = done.stderr.splitlines()
    assert line.endswith("there is no scene 'attic'; there are empty, rooms, or give a .yaml file")


# Gazebo, as far as it can be checked where it is not installed.

# From ros_gz_bridge's README (Jazzy): ROS type -> Gazebo type.
BRIDGED = {
    'geometry_msgs/msg/Twist': 'gz.msgs.Twist',
    'nav_msgs/msg/Odometry': 'gz.msgs.Odometry',
    'rosgraph_msgs/msg/Clock': 'gz.msgs.Clock',
    'sensor_msgs/msg/CameraInfo': 'gz.msgs.CameraInfo',
    'sensor_msgs/msg/Image': 'gz.msgs.Image',
    'sensor_msgs/msg/JointState': 'gz.msgs.Model',
    'sensor_msgs/msg/LaserScan': 'gz.msgs.LaserScan',
    'tf2_msgs/msg/TFMessage': 'gz.msgs.Pose_V',
}


def test_the_bridge_names_types_that_it_knows_and_the_topics_of_the_robot():
    share = Path(get_package_share_directory('mujoco_world'))
    entries = yaml.safe_load((share / 'config' / 'ros_gz_bridge.yaml').read_text())
    assert {entry['ros_type_name']: entry['gz_type_name'] for entry in entries} == BRIDGED
    world = World(scene='rooms')
    ours = {f'/{topic.name.lstrip("/")}' for topic in Topics(world).topics}
    out = {entry['topic_name'] for entry in entries if entry['direction'] == 'GZ_TO_ROS'}
    assert out == ours and [e['topic_name'] for e in entries if e['direction'] == 'ROS_TO_GZ'] == ['/cmd_vel']
    # The robot tells Gazebo the same names, without the slash.
    named = {
        element.text
        for element in ElementTree.fromstring(world.urdf).iter()
        if element.tag in ('topic', 'odom_topic', 'tf_topic', 'camera_info_topic')
    }
    assert named == {name.lstrip('/') for name in ours | {'/cmd_vel'}} - {'clock'}


def test_gazebos_world_has_the_walls_of_the_scene():
    rooms = scene.load('rooms')
    root = ElementTree.fromstring(gazebo.sdf(rooms))
    assert root.tag == 'sdf' and {plugin.get('filename') for plugin in root.iter('plugin')} == set(gazebo.SYSTEMS)
    models = {model.get('name'): model for model in root.find('world').iter('model')}
    assert models.keys() == {
        'floor',
        *(wall.name for wall in rooms.walls),
        *(f'station_{name}' for name in rooms.stations),
    }
    for wall in rooms.walls:
        model = models[wall.name]
        assert model.findtext('static') == 'true'
        assert [float(part) for part in model.findtext('pose').split()] == pytest.approx(
            [*wall.at, wall.height / 2, 0, 0, 0]
        )
        for kind in ('collision', 'visual'):
            size = model.findtext(f'link/{kind}/geometry/box/size')
            assert [float(part) for part in size.split()] == pytest.approx([*wall.size, wall.height])


def test_without_gazebo_the_launch_file_says_what_is_missing_and_what_to_do(domain):
    try:
        get_package_share_directory('ros_gz_sim')
        pytest.skip('Gazebo is installed')
    except PackageNotFoundError:
        pass
    done = subprocess.run(
        [ROS2, 'launch', 'mujoco_world', 'gazebo.launch.py'], capture_output=True, text=True, timeout=60
    )
    said = done.stdout + done.stderr
    assert done.returncode == 1 and 'Traceback' not in said
    assert 'there is no ROS package' in said and 'ros2 launch mujoco_world world.launch.py' in said
