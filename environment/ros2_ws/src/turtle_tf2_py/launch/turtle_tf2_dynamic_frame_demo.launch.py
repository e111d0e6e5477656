"""turtle2 follows carrot1, the frame of dynamic_frame_tf2_broadcaster."""

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

DEMO = [FindPackageShare('turtle_tf2_py'), 'launch', 'turtle_tf2_demo.launch.py']


def generate_launch_description():
    return LaunchDescription(
        [
            IncludeLaunchDescription(PathJoinSubstitution(DEMO), launch_arguments=[('target_frame', 'carrot1')]),
            Node(package='turtle_tf2_py', executable='dynamic_frame_tf2_broadcaster', name='dynamic_broadcaster'),
        ]
    )
