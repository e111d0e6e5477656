"""ROS for launch files: nodes, namespaces, parameters and remappings, under upstream's names."""

from launch_ros import actions, descriptions, event_handlers, events, parameter_descriptions, substitutions

__all__ = ['actions', 'descriptions', 'event_handlers', 'events', 'parameter_descriptions', 'substitutions']
