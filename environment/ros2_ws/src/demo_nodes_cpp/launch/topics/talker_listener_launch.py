"""A talker and a listener."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    programs = 'talker', 'listener'
    return LaunchDescription([Node(package='demo_nodes_cpp', executable=name, output='screen') for name in programs])
