"""The value of a parameter that was set for all nodes."""

from __future__ import annotations

from launch.frontend import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions import SubstitutionFailure
from launch.utilities import describe_substitutions, to_text

from launch_ros.global_parameters import GLOBAL_PARAMETERS, GlobalParameter


@expose_substitution('param')
class Parameter(Substitution):
    """The value that SetParameter gave to a parameter of the nodes that follow."""

    def __init__(self, name: SomeSubstitutionsType, *, default: SomeSubstitutionsType | None = None):
        self.name, self.default = name, default

    @classmethod
    def parse(cls, data):
        """Read ``$(param name [default])``."""
        if len(data) not in (1, 2):
            raise TypeError(f'param substitution expects 1 or 2 arguments, got {len(data)}')
        return cls, {'name': data[0], 'default': data[1] if len(data) == 2 else None}

    def describe(self) -> str:
        return f'Parameter({describe_substitutions(self.name)})'

    def perform(self, context: LaunchContext) -> str:
        name = to_text(context, self.name)
        for item in reversed(context.launch_configurations.get(GLOBAL_PARAMETERS, [])):
            if isinstance(item, GlobalParameter) and item.name == name:
                return str(item.value)
        if self.default is None:
            raise SubstitutionFailure(f"parameter '{name}' not found")
        return to_text(context, self.default)
