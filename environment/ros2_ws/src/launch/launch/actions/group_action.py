"""A group of actions with a scope of its own."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from launch.action import Action
from launch.actions.pop_environment import PopEnvironment
from launch.actions.pop_launch_configurations import PopLaunchConfigurations
from launch.actions.push_environment import PushEnvironment
from launch.actions.push_launch_configurations import PushLaunchConfigurations
from launch.actions.reset_environment import ResetEnvironment
from launch.actions.reset_launch_configurations import ResetLaunchConfigurations, parse_keeps
from launch.actions.set_launch_configuration import SetLaunchConfiguration
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity


@expose_action('group')
class GroupAction(Action):
    """
    Actions that share a condition and a scope.

    :param scoped: what the actions change in configurations and environment ends with the group
    :param forwarding: begin the scope, if there is one, with the configurations from outside; otherwise with none
    :param launch_configurations: set at the beginning, in the group only
    """

    def __init__(
        self,
        actions: Iterable[Action],
        *,
        scoped: bool = True,
        forwarding: bool = True,
        launch_configurations: Mapping | None = None,
        **kwargs,
    ):
        super().__init__(**kwargs)
        self._actions = list(actions)
        self._scoped, self._forwarding = scoped, forwarding
        self._configurations = dict(launch_configurations or {})

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``group``."""
        _, kwargs = super().parse(entity, parser)
        for attribute in ('scoped', 'forwarding'):
            value = entity.get_attr(attribute, data_type=bool, optional=True, can_be_str=False)
            if value is not None:
                kwargs[attribute] = value
        keeps = parse_keeps(entity, parser)
        if keeps:
            kwargs['launch_configurations'] = keeps
        kwargs['actions'] = [parser.parse_action(child) for child in entity.children if child.type_name != 'keep']
        return cls, kwargs

    def describe(self) -> str:
        return 'GroupAction'

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        begin: list[Action] = [PushLaunchConfigurations(), PushEnvironment()] if self._scoped else []
        if self._forwarding or not self._scoped:
            begin += [SetLaunchConfiguration(name, value) for name, value in self._configurations.items()]
        else:
            begin += [ResetEnvironment(), ResetLaunchConfigurations(self._configurations)]
        end = [PopEnvironment(), PopLaunchConfigurations()] if self._scoped else []
        return [*begin, *self._actions, *end]

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        return self.get_sub_entities()
