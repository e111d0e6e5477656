# expect: does a later block override it
# rejected by: test_values
# Exercise 8.3: two governors
FLEET_YAML = '''
/robot1/governor:
  ros__parameters:
    max_linear: 1.0
/robot2/governor:
  ros__parameters:
    mode: slow
/**:
  ros__parameters:
    rate: 20.0
    max_linear: 0.6
'''
FLEET_LAUNCH = '''
from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])
    governor = {'package': 'fleet', 'executable': 'governor', 'output': 'screen'}
    return LaunchDescription([
        Node(namespace='robot1', parameters=[config], **governor),
        Node(namespace='robot2', parameters=[config], remappings=[('cmd_vel', 'base/cmd_vel')], **governor),
    ])
'''
