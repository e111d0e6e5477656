"""What launch files that are programs need besides the actions."""

from launch_ros.utilities.namespace_utils import (
    is_namespace_absolute,
    is_root_namespace,
    make_namespace_absolute,
    prefix_namespace,
)

__all__ = ['is_namespace_absolute', 'is_root_namespace', 'make_namespace_absolute', 'prefix_namespace']
