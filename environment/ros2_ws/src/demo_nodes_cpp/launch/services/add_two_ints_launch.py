"""A server that adds two numbers, and a client that asks it once."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    programs = 'add_two_ints_server', 'add_two_ints_client'
    return LaunchDescription([Node(package='demo_nodes_cpp', executable=name, output='screen') for name in programs])
