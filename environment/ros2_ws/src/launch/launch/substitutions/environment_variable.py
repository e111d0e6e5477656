"""The value of an environment variable."""

from __future__ import annotations

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions.arguments import counted
from launch.substitutions.named_substitution import NamedSubstitution


@expose_substitution('env')
class EnvironmentVariable(NamedSubstitution):
    """The value of an environment variable."""

    _label = 'EnvVar'

    def __init__(self, name: SomeSubstitutionsType, *, default_value=None):
        super().__init__(name, default=default_value)

    @classmethod
    def parse(cls, data):
        """Read ``$(env name [default])``."""
        name, *default = counted('env', data, 1, 2)
        return cls, {'name': name, 'default_value': default[0] if default else None}

    @property
    def name(self):
        """The name, as substitutions."""
        return self._name

    @property
    def default_value(self):
        """The value if the variable is not set, as substitutions; None if there is none."""
        return self._default

    def _look_up(self, context: LaunchContext, name: str) -> str | None:
        return context.environment.get(name)

    def _failure(self, name: str) -> str:
        return f"environment variable '{name}' does not exist"
