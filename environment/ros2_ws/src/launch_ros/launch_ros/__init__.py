"""ROS for launch files: nodes, namespaces, parameters and remappings, under upstream's names."""

from launch_ros import actions, substitutions

__all__ = ['actions', 'substitutions']
