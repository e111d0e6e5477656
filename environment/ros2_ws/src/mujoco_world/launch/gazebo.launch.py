"""The same robot and scene in Gazebo Harmonic, where it is installed: ``ros2 launch mujoco_world gazebo.launch.py``.

Gazebo reads the robot's own <gazebo> elements for friction, drive and sensors; ros_gz_bridge brings its topics to ROS.
"""

import tempfile
from pathlib import Path

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare
from mujoco_world import gazebo, scene

ROBOT = PathJoinSubstitution([FindPackageShare('mobile_robot_description'), 'urdf', 'mobile_robot.urdf'])
ABSENT = (
    'Gazebo is not installed here: there is no ROS package {}. With a stock Jazzy: sudo apt-get install '
    'ros-jazzy-ros-gz. Without Gazebo, MuJoCo runs the same scene: ros2 launch mujoco_world world.launch.py'
)


def start(context) -> list:
    """What is to be started, now that the arguments are known."""
    try:
        simulator, _ = (get_package_share_directory(name) for name in ('ros_gz_sim', 'ros_gz_bridge'))
    except PackageNotFoundError as error:
        raise RuntimeError(ABSENT.format(error)) from None
    place = scene.load(LaunchConfiguration('scene').perform(context))
    world = Path(tempfile.mkdtemp(prefix='gazebo_'), f'{place.name}.sdf')
    world.write_text(gazebo.sdf(place))
    x, y, yaw = map(str, place.start)
    window = LaunchConfiguration('window').perform(context) == 'true'
    arguments = f'-r {"" if window else "-s --headless-rendering "}{world}'
    description = ParameterValue(Command(['xacro "', LaunchConfiguration('urdf'), '"']), value_type=str)
    bridge = Path(get_package_share_directory('mujoco_world'), 'config', 'ros_gz_bridge.yaml')
    return [
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(str(Path(simulator, 'launch', 'gz_sim.launch.py'))),
            launch_arguments={'gz_args': arguments, 'on_exit_shutdown': 'true'}.items(),
        ),
        Node(
            package='robot_state_publisher',
            executable='robot_state_publisher',
            output='screen',
            parameters=[{'robot_description': description, 'use_sim_time': True, 'publish_frequency': 50.0}],
        ),
        Node(
            package='ros_gz_sim',
            executable='create',
            output='screen',
            arguments=['-topic', 'robot_description', '-name', 'mobile_robot', '-x', x, '-y', y, '-Y', yaw],
        ),
        Node(
            package='ros_gz_bridge',
            executable='parameter_bridge',
            output='screen',
            parameters=[{'config_file': str(bridge), 'use_sim_time': True}],
        ),
        # Gazebo's odometry begins at zero where the robot begins. Nothing corrects it later.
        Node(
            package='tf2_ros',
            executable='static_transform_publisher',
            arguments=['--x', x, '--y', y, '--yaw', yaw, '--frame-id', 'map', '--child-frame-id', 'odom'],
        ),
    ]


def generate_launch_description() -> LaunchDescription:
    """Gazebo, the robot in it, the bridge, and what publishes the robot's own frames."""
    return LaunchDescription(
        [
            DeclareLaunchArgument('urdf', default_value=ROBOT, description="the robot's description, URDF or xacro"),
            DeclareLaunchArgument('scene', default_value='rooms', description='as of world.launch.py'),
            DeclareLaunchArgument('window', default_value='true', description="whether Gazebo's window opens"),
            OpaqueFunction(function=start),
        ]
    )
