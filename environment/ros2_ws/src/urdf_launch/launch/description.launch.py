"""A URDF or xacro file of a package becomes /robot_description, and the frames of its fixed joints."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description() -> LaunchDescription:
    """Describe what is launched."""
    package, path = LaunchConfiguration('urdf_package'), LaunchConfiguration('urdf_package_path')
    text = Command(['xacro ', PathJoinSubstitution([FindPackageShare(package), path])])
    return LaunchDescription(
        [
            DeclareLaunchArgument('urdf_package', description='The package that has the robot description'),
            DeclareLaunchArgument('urdf_package_path', description='Its file, from the share folder of the package'),
            Node(
                package='robot_state_publisher',
                executable='robot_state_publisher',
                parameters=[{'robot_description': ParameterValue(text, value_type=str)}],
            ),
        ]
    )
