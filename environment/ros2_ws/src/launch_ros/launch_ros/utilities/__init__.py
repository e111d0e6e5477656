"""What launch files that are programs need besides the actions."""

from launch_ros.utilities.namespace_utils import (
    is_namespace_absolute,
    is_root_namespace,
    make_namespace_absolute,
    prefix_namespace,
)
from launch_ros.utilities.track_node_names import add_node_name, get_node_name_count

__all__ = [
    'add_node_name',
    'get_node_name_count',
    'is_namespace_absolute',
    'is_root_namespace',
    'make_namespace_absolute',
    'prefix_namespace',
]
