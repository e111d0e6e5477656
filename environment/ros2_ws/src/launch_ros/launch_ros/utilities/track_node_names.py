"""How many nodes of a name a launch has started."""

from __future__ import annotations

from collections import Counter

import launch.logging
from launch.launch_context import LaunchContext

_NODE_NAMES = 'unique_ros_node_names'  # the global variable of the launch that counts them


def add_node_name(context: LaunchContext, node_name: str, *, logger: str = 'launch_ros') -> None:
    """
    Count one more node; if there is already one of that name, the log says so.

    :param node_name: its full name
    :param logger: the name under which that is logged
    """
    names = context.get_locals_as_dict().get(_NODE_NAMES, Counter())
    names[node_name] += 1
    context.extend_globals({_NODE_NAMES: names})
    if names[node_name] > 1:
        launch.logging.get_logger(logger).warning(
            f'there are now at least {names[node_name]} nodes with the name {node_name} created within this '
            'launch context'
        )


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return how many nodes of that full name this launch has started."""
    return context.get_locals_as_dict().get(_NODE_NAMES, Counter())[node_name]
