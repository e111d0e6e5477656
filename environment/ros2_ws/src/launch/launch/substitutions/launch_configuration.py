"""The value of a launch configuration."""

from __future__ import annotations

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions.arguments import counted
from launch.substitutions.named_substitution import NamedSubstitution


@expose_substitution('var')
class LaunchConfiguration(NamedSubstitution):
    """The value of a launch argument or another launch configuration."""

    _label = 'LaunchConfig'

    def __init__(self, variable_name: SomeSubstitutionsType, *, default=None):
        super().__init__(variable_name, default=default)

    @classmethod
    def parse(cls, data):
        """Read ``$(var name [default])``."""
        name, *default = counted('var', data, 1, 2)
        return cls, {'variable_name': name, 'default': default[0] if default else None}

    @property
    def variable_name(self):
        """The name, as substitutions."""
        return self._name

    def _look_up(self, context: LaunchContext, name: str) -> str | None:
        return context.launch_configurations.get(name)

    def _failure(self, name: str) -> str:
        return f"launch configuration '{name}' does not exist"
