"""A group of actions with a scope of its own."""

from __future__ import annotations

from collections.abc import Iterable

from launch.action import Action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.utilities import to_text


class PushLaunchConfigurations(Action):
    """Begins a scope: later changes of configurations and environment last until it ends."""

    def __init__(self, *, forwarding: bool = True, **kwargs):
        super().__init__(**kwargs)
        self._forwarding = forwarding

    def execute(self, context: LaunchContext) -> None:
        context.push_scope(forwarding=self._forwarding)


class PopLaunchConfigurations(Action):
    """Ends the scope begun last."""

    def execute(self, context: LaunchContext) -> None:
        context.pop_scope()


class GroupAction(Action):
    """
    Actions that share a condition and a scope.

    :param scoped: what the actions change in configurations and environment ends with the group
    :param forwarding: begin the scope with the configurations from outside; otherwise with none
    :param launch_configurations: set at the beginning, in the group only
    """

    def __init__(
        self,
        actions: Iterable[Action],
        *,
        scoped: bool = True,
        forwarding: bool = True,
        launch_configurations: dict | None = None,
        **kwargs,
    ):
        super().__init__(**kwargs)
        if not scoped and not forwarding:
            raise RuntimeError("GroupAction with scoped=False cannot have forwarding=False")
        self._actions = list(actions)
        self._scoped, self._forwarding = scoped, forwarding
        self._configurations = launch_configurations or {}

    def describe(self) -> str:
        return 'GroupAction'

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return self._actions

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        # The values are taken from outside, before a scope without forwarding hides them.
        given = {to_text(context, name): to_text(context, value) for name, value in self._configurations.items()}
        if self._scoped:
            context.push_scope(forwarding=self._forwarding)
        context.launch_configurations.update(given)
        return [*self._actions, PopLaunchConfigurations()] if self._scoped else self._actions
