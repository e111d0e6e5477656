"""Parameters for all nodes that follow."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml
from launch.action import Action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_bool, to_text

from launch_ros.parameters import evaluate_parameters

GLOBAL_PARAMETERS = 'global_params'


@dataclass(frozen=True)
class GlobalParameter:
    """A parameter of every node. It goes on the command line: in a file it would beat the node's own files."""

    name: str
    value: Any

    def as_yaml(self) -> str:
        """Return the value as one line of YAML."""
        text = yaml.safe_dump(self.value, default_flow_style=True, width=math.inf)
        return text.removesuffix('...\n').strip()


def _add(context: LaunchContext, item) -> None:
    # A new list: the old one belongs to the scope outside.
    old = context.launch_configurations.get(GLOBAL_PARAMETERS, [])
    context.launch_configurations[GLOBAL_PARAMETERS] = [*old, item]


class SetParameter(Action):
    """Sets one parameter of all nodes that follow, to the end of the GroupAction around it."""

    def __init__(self, name: SomeSubstitutionsType, value, **kwargs):
        super().__init__(**kwargs)
        self.name, self.value = name, value

    def execute(self, context: LaunchContext) -> None:
        for name, value in evaluate_parameters(context, {self.name: self.value}).items():
            _add(context, GlobalParameter(name, value))


class SetUseSimTime(SetParameter):
    """Lets all nodes that follow take their time from /clock, or not."""

    def __init__(self, value, **kwargs):
        super().__init__('use_sim_time', value, **kwargs)

    def execute(self, context: LaunchContext) -> None:
        _add(context, GlobalParameter('use_sim_time', to_bool(context, self.value)))


class SetParametersFromFile(Action):
    """Gives a parameter file to all nodes that follow, to the end of the GroupAction around it."""

    def __init__(self, filename: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.filename = filename

    def execute(self, context: LaunchContext) -> None:
        _add(context, Path(to_text(context, self.filename)))
