from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('loop_and_share_directory', source="""
FLEET_YAML = '''
/**/governor:
  ros__parameters: {rate: 2.0e+1, max_linear: 0.6}
/robot1:
  governor:
    ros__parameters:
      max_linear: 1.0
/robot2:
  governor:
    ros__parameters:
      mode: "slow"
'''
FLEET_LAUNCH = '''
import os

from ament_index_python import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory('fleet'), 'config', 'fleet.yaml')
    description = LaunchDescription()
    for robot, topic in (('robot1', 'cmd_vel'), ('/robot2', 'base/cmd_vel')):
        description.add_action(Node(package='fleet', executable='governor', name='governor', namespace=robot,
                                    parameters=[config], remappings=[('cmd_vel', topic)]))
    return description
'''
"""),
    Alternative('one_after_the_other', edits=(
        ('import LaunchDescription', 'import LaunchDescription, actions'),
        ("Node(namespace='robot2'", "actions.TimerAction(period=1.0, actions=[Node(namespace='robot2'"),
        ("'base/cmd_vel')], **governor)", "'base/cmd_vel')], **governor)])"),
    )),
]
