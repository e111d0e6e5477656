"""Parameters for all nodes that follow, as the launch context keeps them."""

import math
from dataclasses import dataclass
from typing import Any

import yaml
from launch.launch_context import LaunchContext

GLOBAL_PARAMETERS = 'global_params'  # the launch configuration that holds them, so that a group is a scope for them


@dataclass(frozen=True)
class GlobalParameter:
    """A parameter of every node. It goes on the command line: in a file it would beat the node's own files."""

    name: str
    value: Any

    def as_yaml(self) -> str:
        """Return the value as one line of YAML."""
        text = yaml.safe_dump(self.value, default_flow_style=True, width=math.inf)
        return text.removesuffix('...\n').strip()


def add_global_parameter(context: LaunchContext, item) -> None:
    """Add a GlobalParameter, or the path of a parameter file."""
    # A new list: the old one belongs to the scope outside.
    old = context.launch_configurations.get(GLOBAL_PARAMETERS, [])
    context.launch_configurations[GLOBAL_PARAMETERS] = [*old, item]
