"""The simulated world with its robot: ``ros2 launch mujoco_world world.launch.py [scene:=…] [urdf:=FILE] …``."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare

ROBOT = PathJoinSubstitution([FindPackageShare('mobile_robot_description'), 'urdf', 'mobile_robot.urdf'])
ARGUMENTS = {
    'scene': ('rooms', 'a scene of mujoco_world (rooms, empty), or the path of a YAML file'),
    'seed': ('0', 'of the noise'),
    'real_time_factor': ('1.0', 'simulated seconds in a second; 0: as many as possible'),
    'odometry_noise': ('0.0', "standard deviation of a wheel's way after one metre, in metres"),
    'localization': ('true', 'publish map -> odom, as a perfect localiser would'),
}


def generate_launch_description() -> LaunchDescription:
    """The world, and what publishes the robot's own frames."""
    description = ParameterValue(Command(['xacro "', LaunchConfiguration('urdf'), '"']), value_type=str)
    return LaunchDescription([
        DeclareLaunchArgument('urdf', default_value=ROBOT, description="the robot's description, URDF or xacro"),
        *(DeclareLaunchArgument(name, default_value=default, description=text)
          for name, (default, text) in ARGUMENTS.items()),
        Node(package='mujoco_world', executable='world', output='screen',
             parameters=[{'robot_description': description}, {name: LaunchConfiguration(name) for name in ARGUMENTS}]),
        Node(package='robot_state_publisher', executable='robot_state_publisher', output='screen',
             parameters=[{'robot_description': description, 'use_sim_time': True, 'publish_frequency': 50.0}]),
    ])
