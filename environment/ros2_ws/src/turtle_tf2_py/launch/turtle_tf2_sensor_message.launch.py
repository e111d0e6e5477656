"""turtle3 tells its place as stamped points; turtle1 and turtle3 have frames."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    broadcasters = [
        Node(
            package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name=name, parameters=[{'turtlename': turtle}]
        )
        for name, turtle in (('broadcaster1', 'turtle1'), ('broadcaster2', 'turtle3'))
    ]
    return LaunchDescription(
        [
            DeclareLaunchArgument('target_frame', default_value='turtle1', description='Target frame name.'),
            Node(package='turtlesim', executable='turtlesim_node', name='sim', output='screen'),
            *broadcasters,
            Node(package='turtle_tf2_py', executable='turtle_tf2_message_broadcaster', name='message_broadcaster'),
        ]
    )
