"""A robot description, positions for its joints, and the programs that show them, if they are installed."""

from ament_index_python.packages import PackageNotFoundError, get_package_prefix
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, LogInfo, OpaqueFunction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

NO_WINDOW = 'joint_state_publisher_gui is not installed: joint_state_publisher takes its place, without a window'
NO_RVIZ = 'rviz2 is not installed: look at the robot with TfView(views.RobotModel()) in a notebook'


def is_installed(package: str) -> bool:
    """Return whether a package is in one of the prefixes that are sourced."""
    try:
        get_package_prefix(package)
    except PackageNotFoundError:
        return False
    return True


def joint_states(context) -> list:
    """Return the publisher of joint states: with a window if it is asked for, and there is one."""
    asked = IfCondition(LaunchConfiguration('jsp_gui')).evaluate(context)
    window = asked and is_installed('joint_state_publisher_gui')
    name = 'joint_state_publisher_gui' if window else 'joint_state_publisher'
    return [*([LogInfo(msg=NO_WINDOW)] if asked and not window else []), Node(package=name, executable=name)]


def rviz() -> LogInfo | Node:
    """Return RViz, or a line that says what there is in its place."""
    if not is_installed('rviz2'):
        return LogInfo(msg=NO_RVIZ)
    chosen = ['-d', LaunchConfiguration('rviz_config')]
    return Node(package='rviz2', executable='rviz2', output='screen', arguments=chosen)


def generate_launch_description() -> LaunchDescription:
    """Describe what is launched."""
    folder = PathJoinSubstitution([FindPackageShare('urdf_launch'), 'launch'])
    handed_on = {name: LaunchConfiguration(name) for name in ('urdf_package', 'urdf_package_path')}
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                'jsp_gui',
                default_value='true',
                choices=['true', 'false'],
                description='Whether joint_state_publisher_gui is started, if it is installed',
            ),
            DeclareLaunchArgument('rviz_config', default_value='', description="Absolute path to RViz's settings"),
            IncludeLaunchDescription(
                PathJoinSubstitution([folder, 'description.launch.py']), launch_arguments=handed_on.items()
            ),
            OpaqueFunction(function=joint_states),
            rviz(),
        ]
    )
