"""The base of all actions."""

from __future__ import annotations

from collections.abc import Iterable

from launch.condition import Condition
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity


class Action(LaunchDescriptionEntity):
    """
    Something to do. Subclasses write ``execute``.

    :param condition: the action is executed only if this is true at that time
    """

    def __init__(self, *, condition: Condition | None = None):
        self._condition = condition

    @property
    def condition(self) -> Condition | None:
        """The condition given, if any."""
        return self._condition

    def visit(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Execute the action if its condition holds."""
        if self._condition is None or self._condition.evaluate(context):
            return self.execute(context)
        return None

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return self.get_sub_entities() if self._condition is None else []

    def describe_conditional_sub_entities(self):
        entities = self.get_sub_entities()
        return [('Conditionally included by the action', entities)] if self._condition is not None and entities else []

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that executing leads to, as far as is known without launching."""
        return []

    def execute(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Do it; return the entities to visit next, if any."""
        raise NotImplementedError
