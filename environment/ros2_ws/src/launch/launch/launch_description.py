"""What a launch file returns."""

from __future__ import annotations

from collections.abc import Iterable

import launch.logging
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity


class LaunchDescription(LaunchDescriptionEntity):
    """
    A list of entities, visited in order.

    :param deprecated_reason: warn with this text whenever the description is launched
    """

    def __init__(
        self, initial_entities: Iterable[LaunchDescriptionEntity] | None = None, *, deprecated_reason: str | None = None
    ):
        self._entities = list(initial_entities or [])
        self._deprecated_reason = deprecated_reason
        for entity in self._entities:
            _check(entity)

    @property
    def entities(self) -> list[LaunchDescriptionEntity]:
        """The entities, in order."""
        return self._entities

    @property
    def deprecated(self) -> bool:
        """True if there is a reason not to use the description any more."""
        return self._deprecated_reason is not None

    @property
    def deprecated_reason(self) -> str | None:
        """Why not to use the description any more."""
        return self._deprecated_reason

    def add_action(self, action: LaunchDescriptionEntity) -> None:
        """Add an action at the end."""
        self.add_entity(action)

    def add_entity(self, entity: LaunchDescriptionEntity) -> None:
        """Add an entity at the end."""
        _check(entity)
        self._entities.append(entity)

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        if self._deprecated_reason is not None:
            path = context.get_locals_as_dict().get('current_launch_file_path')
            what = 'deprecated launch description' if path is None else f'launch file [{path}] is deprecated'
            launch.logging.get_logger().warning(f'{what}: {self._deprecated_reason}')
        return self._entities

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return self._entities

    def get_launch_arguments(self, conditional_inclusion: bool = False) -> list:
        """
        Return the DeclareLaunchArgument actions that can be found without launching, each name once.

        :param conditional_inclusion: mark all as behind a condition, not only those that are
        """
        found = self.get_launch_arguments_with_include_launch_description_actions(conditional_inclusion)
        return [argument for argument, _ in found]

    def get_launch_arguments_with_include_launch_description_actions(self, conditional_inclusion: bool = False) -> list:
        """
        Return the same actions, each with the list of the includes around it, the outermost first; None for no include.

        Those behind a condition are marked as such. What follows a ResetLaunchConfigurations is left out, as no
        argument of the launch reaches it.
        """
        found: dict = {}
        _collect(self._entities, conditional=conditional_inclusion, includes=None, found=found)
        return list(found.values())


def _check(entity) -> None:
    if not isinstance(entity, LaunchDescriptionEntity):
        raise TypeError(f'a launch description holds actions, got {entity!r}')


def _collect(entities, *, conditional: bool, includes: list | None, found: dict) -> None:
    from launch.actions.declare_launch_argument import DeclareLaunchArgument
    from launch.actions.include_launch_description import IncludeLaunchDescription
    from launch.actions.reset_launch_configurations import ResetLaunchConfigurations

    for entity in entities:
        if isinstance(entity, ResetLaunchConfigurations):
            return
        if isinstance(entity, DeclareLaunchArgument):
            if entity.name not in found:
                entity._conditionally_included = conditional or entity.condition is not None
                found[entity.name] = (entity, includes)
            continue
        around = [*(includes or []), entity] if isinstance(entity, IncludeLaunchDescription) else includes
        _collect(entity.describe_sub_entities(), conditional=conditional, includes=around, found=found)
        for _, some in entity.describe_conditional_sub_entities():
            _collect(some, conditional=True, includes=around, found=found)
