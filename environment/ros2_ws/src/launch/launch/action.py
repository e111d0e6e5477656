"""The base of all actions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.condition import Condition
from launch.conditions import IfCondition, UnlessCondition
from launch.events import ExecutionComplete
from launch.frontend import Entity, Parser
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity


class Action(LaunchDescriptionEntity):
    """
    Something to do. Subclasses say in ``execute`` what.

    :param condition: the action is executed only if this is true at that time
    """

    def __init__(self, *, condition: Condition | None = None):
        self._condition = condition

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """
        Return the class, and the keyword arguments to make an action from an element of a launch file.

        :raises RuntimeError: if it has both conditions
        """
        if_text, unless_text = (entity.get_attr(name, optional=True) for name in ('if', 'unless'))
        if if_text is not None and unless_text is not None:
            raise RuntimeError("if and unless conditions can't be used simultaneously")
        if if_text is not None:
            return cls, {'condition': IfCondition(parser.parse_substitution(if_text))}
        if unless_text is not None:
            return cls, {'condition': UnlessCondition(parser.parse_substitution(unless_text))}
        return cls, {}

    @property
    def condition(self) -> Condition | None:
        """The condition given, if any."""
        return self._condition

    def visit(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Execute the action if its condition holds."""
        if self._condition is not None and not self._condition.evaluate(context):
            return None
        following = self.execute(context)
        self._tell_completion(context)
        return following

    def _tell_completion(self, context: LaunchContext) -> None:
        """Emit ExecutionComplete if a handler waits for it: now, or when what goes on has ended."""
        event = ExecutionComplete(action=self)
        if not context.would_handle_event(event):
            return
        future = self.get_asyncio_future()
        if future is None:
            context.emit_event_sync(event)
        else:
            future.add_done_callback(lambda _: context.emit_event_sync(event))

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return self.get_sub_entities() if self._condition is None else []

    def describe_conditional_sub_entities(self):
        entities = self.get_sub_entities()
        return [('Conditionally included by the action', entities)] if self._condition is not None and entities else []

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that executing leads to, as far as is known without launching."""
        return []

    def execute(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Do it, which is nothing here; return the entities to visit next, if any."""
        return None
