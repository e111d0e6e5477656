"""Declares an argument of the launch file."""

from __future__ import annotations

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


@expose_action('arg')
class DeclareLaunchArgument(Action):
    """
    An argument that may be given to the launch file; its value is the launch configuration of the same name.

    :param default_value: the value if none is given; without a default the argument is required
    :param description: what ``ros2 launch --show-args`` says about it
    :param choices: the values that are allowed; None allows all
    :raises RuntimeError: if the choices are an empty list or do not hold the default
    """

    def __init__(
        self,
        name: str,
        *,
        default_value: SomeSubstitutionsType | None = None,
        description: str | None = None,
        choices: list[str] | None = None,
        **kwargs,
    ):
        super().__init__(**kwargs)
        if choices is not None and not choices:
            raise RuntimeError('Provided choices arg is empty. Use None to ignore the choice list.')
        if choices is not None and isinstance(default_value, str) and default_value not in choices:
            raise RuntimeError(f'Provided default_value "{default_value}" is not in provided choices "{choices}".')
        self.name = name
        self.choices = choices
        self.default_value: list[Substitution] | None = None
        if default_value is not None:
            self.default_value = normalize_to_list_of_substitutions(default_value)
        self.description = _describe(description, choices)
        self._conditionally_included = False  # set by LaunchDescription.get_launch_arguments; read by ros2launch

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``arg``, with a ``choice`` for each value that is allowed."""
        _, kwargs = super().parse(entity, parser)
        kwargs['name'] = parser.escape_characters(entity.get_attr('name'))
        default = entity.get_attr('default', optional=True)
        if default is not None:
            kwargs['default_value'] = parser.parse_substitution(default)
        description = entity.get_attr('description', optional=True)
        if description is not None:
            kwargs['description'] = parser.escape_characters(description)
        choices = entity.get_attr('choice', data_type=list[Entity], optional=True)
        if choices is not None:
            kwargs['choices'] = [parser.escape_characters(choice.get_attr('value')) for choice in choices]
            for choice in choices:
                choice.assert_entity_completely_parsed()
        return cls, kwargs

    def describe(self) -> str:
        return f"DeclareLaunchArgument('{self.name}')"

    def execute(self, context: LaunchContext) -> None:
        if self.name not in context.launch_configurations:
            if self.default_value is None:
                raise RuntimeError(
                    f'Required launch argument "{self.name}" (description: "{self.description}") was not provided'
                )
            context.launch_configurations[self.name] = perform_substitutions(context, self.default_value)
        value = context.launch_configurations[self.name]
        if self.choices is not None and value not in self.choices:
            raise RuntimeError(
                f'Argument "{self.name}" provided value "{value}" is not valid. Valid options are: {self.choices}'
            )


def _describe(description: str | None, choices: list[str] | None) -> str:
    if description is None:
        return 'no description given' if choices is None else f'One of: {choices}'
    if choices is None:
        return description
    return f'{description.removesuffix(".")}. Valid choices are: {choices}'
