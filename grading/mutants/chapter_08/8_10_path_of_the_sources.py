# expect: a parameter file that is not there
# rejected by: test_values
# alone: its exercise uses the answers of others
# Exercise 8.10: start it
DELIVERY_YAML = '''
/delivery_robot:
  ros__parameters:
    max_linear: 0.4
    tolerance: 0.08
    timeout: 30.0
'''
DELIVERY_LAUNCH = '''
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('scene', default_value='rooms'),
        DeclareLaunchArgument('real_time_factor', default_value='1.0'),
        IncludeLaunchDescription(
            PathJoinSubstitution([FindPackageShare('mujoco_world'), 'launch', 'world.launch.py']),
            launch_arguments=[(name, LaunchConfiguration(name)) for name in ('scene', 'real_time_factor')]),
        Node(package='delivery_robot', executable='robot', output='screen', parameters=[
            'src/delivery_robot/config/delivery.yaml',
            {'use_sim_time': True}]),
    ])
'''
