"""What tests of launched ROS nodes need beside ``launch_testing``."""

from launch_testing_ros import tools
from launch_testing_ros.data_republisher import DataRepublisher
from launch_testing_ros.message_pump import MessagePump
from launch_testing_ros.wait_for_topics import WaitForTopics

__all__ = ['DataRepublisher', 'MessagePump', 'WaitForTopics', 'tools']
