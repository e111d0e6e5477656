"""What launch files that are programs need besides the actions."""

from launch_ros.utilities.namespace_utils import (
    is_namespace_absolute,
    is_root_namespace,
    make_namespace_absolute,
    prefix_namespace,
)
from launch_ros.utilities.parameter_lists import evaluate_parameters, normalize_parameters
from launch_ros.utilities.track_node_names import add_node_name, get_node_name_count

__all__ = [
    'add_node_name',
    'evaluate_parameters',
    'get_node_name_count',
    'is_namespace_absolute',
    'is_root_namespace',
    'make_namespace_absolute',
    'normalize_parameters',
    'prefix_namespace',
]
