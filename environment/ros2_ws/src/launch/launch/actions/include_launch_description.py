"""Includes another launch file."""

from __future__ import annotations

import os
from collections.abc import Iterable

from launch.action import Action
from launch.actions.opaque_function import OpaqueFunction
from launch.actions.set_launch_configuration import SetLaunchConfiguration
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.launch_description_source import LaunchDescriptionSource
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions.text_substitution import TextSubstitution
from launch.utilities import normalize_to_list_of_substitutions, to_text


@expose_action('include')
class IncludeLaunchDescription(Action):
    """
    Visits the launch description of another file.

    :param launch_description_source: the source, or the path of a launch file
    :param launch_arguments: (name, value) pairs, set one after the other when the file is known, so ThisLaunchFileDir
        in a value is the included file's; they stay set after the include, unless a GroupAction is around it
    """

    def __init__(
        self,
        launch_description_source: LaunchDescriptionSource | SomeSubstitutionsType,
        *,
        launch_arguments: Iterable[tuple[SomeSubstitutionsType, SomeSubstitutionsType]] | None = None,
        **kwargs,
    ):
        super().__init__(**kwargs)
        if not isinstance(launch_description_source, LaunchDescriptionSource):
            launch_description_source = AnyLaunchDescriptionSource(launch_description_source)
        self.launch_description_source = launch_description_source
        self.launch_arguments = list(launch_arguments or [])

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``include``, with a ``let`` or ``arg`` for each argument."""
        _, kwargs = super().parse(entity, parser)
        kwargs['launch_description_source'] = parser.parse_substitution(entity.get_attr('file'))
        arguments = []
        for tag in ('let', 'arg'):
            for argument in entity.get_attr(tag, data_type=list[Entity], optional=True) or []:
                name, value = (parser.parse_substitution(argument.get_attr(key)) for key in ('name', 'value'))
                arguments.append((name, value))
                argument.assert_entity_completely_parsed()
        kwargs['launch_arguments'] = arguments
        return cls, kwargs

    def provided_names(self) -> frozenset[str]:
        """Return the names of the arguments given here, as far as they are plain texts."""
        names = [normalize_to_list_of_substitutions(name) for name, _ in self.launch_arguments]
        plain = [name for name in names if all(isinstance(part, TextSubstitution) for part in name)]
        return frozenset(''.join(part.text for part in name) for name in plain)

    def describe(self) -> str:
        return f'IncludeLaunchDescription({self.launch_description_source.location})'

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        description = self.launch_description_source.try_get_launch_description_without_context()
        return [] if description is None else [description]

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        source = self.launch_description_source
        description = source.get_launch_description(context)
        path = os.path.abspath(source.location)
        # A description from a script has no file; what it is called then stands for its directory, too.
        directory = os.path.dirname(path) if os.path.exists(path) else source.location
        context.push_locals({'current_launch_file_path': path, 'current_launch_file_directory': directory})
        self._check_arguments(context, description)
        arguments = [SetLaunchConfiguration(name, value) for name, value in self.launch_arguments]
        return [*arguments, description, OpaqueFunction(function=lambda context: context.pop_locals())]

    def _check_arguments(self, context: LaunchContext, description: LaunchDescription) -> None:
        """Raise RuntimeError if a required argument is given neither here nor by an include around it."""
        given = [to_text(context, name) for name, _ in self.launch_arguments]
        for argument, includes in description.get_launch_arguments_with_include_launch_description_actions():
            optional = argument.default_value is not None or argument._conditionally_included
            between = {name for include in includes or [] for name in include.provided_names()}
            if not optional and argument.name not in between.union(given):
                raise RuntimeError(
                    f"Included launch description missing required argument '{argument.name}' "
                    f"(description: '{argument.description}'), given: [{', '.join(given)}]"
                )
