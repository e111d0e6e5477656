"""Clears the launch configurations."""

from __future__ import annotations

from collections.abc import Mapping

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.utilities import to_text


@expose_action('reset')
class ResetLaunchConfigurations(Action):
    """
    Removes all launch configurations but the ones given.

    :param launch_configurations: names and values of those that there are afterwards
    """

    def __init__(self, launch_configurations: Mapping | None = None, **kwargs):
        super().__init__(**kwargs)
        self.launch_configurations = dict(launch_configurations or {})

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``reset``, with a ``keep`` for each configuration to be set."""
        _, kwargs = super().parse(entity, parser)
        kwargs['launch_configurations'] = parse_keeps(entity, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        # The values are taken before those that they are made of are gone.
        given = {to_text(context, name): to_text(context, value) for name, value in self.launch_configurations.items()}
        context.launch_configurations.clear()
        context.launch_configurations.update(given)


def parse_keeps(entity: Entity, parser: Parser) -> dict:
    """Return the names and values of the ``keep`` children."""
    result = {}
    for keep in entity.get_attr('keep', data_type=list[Entity], optional=True) or []:
        name = tuple(parser.parse_substitution(keep.get_attr('name')))
        result[name] = parser.parse_substitution(keep.get_attr('value'))
        keep.assert_entity_completely_parsed()
    return result
