"""Adds to a variable of the environment."""

from __future__ import annotations

import os

from launch.actions.set_environment_variable import SetEnvironmentVariable
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text
from launch.utilities.type_utils import to_bool


@expose_action('append_env')
class AppendEnvironmentVariable(SetEnvironmentVariable):
    """
    Adds to a variable that holds a list.

    :param prepend: add in front
    :param separator: what stands between the items
    """

    def __init__(
        self,
        name: SomeSubstitutionsType,
        value: SomeSubstitutionsType,
        prepend: bool | SomeSubstitutionsType = False,
        separator: SomeSubstitutionsType = os.pathsep,
        **kwargs,
    ):
        super().__init__(name, value, **kwargs)
        self.prepend, self.separator = prepend, separator

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``append_env``."""
        _, kwargs = super().parse(entity, parser)
        prepend = entity.get_attr('prepend', data_type=bool, optional=True, can_be_str=True)
        if prepend is not None:
            kwargs['prepend'] = parser.parse_if_substitutions(prepend)
        separator = entity.get_attr('separator', optional=True)
        if separator is not None:
            kwargs['separator'] = parser.parse_substitution(separator)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        name, value = to_text(context, self.name), to_text(context, self.value)
        old = context.environment.get(name)
        parts = [part for part in (old, value) if part is not None]
        if to_bool(context, self.prepend):
            parts.reverse()
        context.environment[name] = to_text(context, self.separator).join(parts)
