"""The simulated world with its robot: ``ros2 launch mujoco_world world.launch.py [scene:=…] [urdf:=FILE] …``."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction, Shutdown
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


def check(context) -> list:
    """One line for a file that is not there, where xacro would print a traceback."""
    file = LaunchConfiguration('urdf').perform(context)
    if not Path(file).is_file():
        raise RuntimeError(f'urdf: there is no file {file}')
    return []


def generate_launch_description() -> LaunchDescription:
    """The world, and what publishes the robot's own frames."""
    description = ParameterValue(Command(['xacro "', LaunchConfiguration('urdf'), '"']), value_type=str)
    return LaunchDescription(
        [
            DeclareLaunchArgument('urdf', default_value=ROBOT, description="the robot's description, URDF or xacro"),
            *(
                DeclareLaunchArgument(name, default_value=default, description=text)
                for name, (default, text) in ARGUMENTS.items()
            ),
            OpaqueFunction(function=check),
            Node(
                package='mujoco_world',
                executable='world',
                output='screen',
                on_exit=Shutdown(),
                parameters=[
                    {'robot_description': description},
                    {name: LaunchConfiguration(name) for name in ARGUMENTS},
                ],
            ),
            Node(
                package='robot_state_publisher',
                executable='robot_state_publisher',
                output='screen',
                parameters=[{'robot_description': description, 'use_sim_time': True, 'publish_frequency': 50.0}],
            ),
        ]
    )
