"""The base of all event handlers."""

from __future__ import annotations

from collections.abc import Callable

from launch.event import Event
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.utilities import to_entities


class EventHandler:
    """
    Says which entities to visit when an event comes that ``matcher`` accepts.

    :param entities: the entities, or a function of (event, context) that returns some
    :param handle_once: forget the handler after its first event
    """

    def __init__(self, *, matcher: Callable[[Event], bool], entities=None, handle_once: bool = False):
        self._matcher = matcher
        self._entities = entities
        self._handle_once = handle_once
        self._locals: dict = {}

    @property
    def entities(self):
        """What was given as entities."""
        return self._entities

    @property
    def handle_once(self) -> bool:
        """Whether the handler is forgotten after its first event."""
        return self._handle_once

    @property
    def handler_description(self) -> str | None:
        """What the handler does with an event, in words; None where a subclass says nothing."""
        return None

    @property
    def matcher_description(self) -> str | None:
        """Which events the handler wants, in words; None where a subclass says nothing."""
        return None

    def matches(self, event: Event) -> bool:
        """Return True if the handler wants the event."""
        return self._matcher(event)

    def remember_locals(self, context: LaunchContext) -> None:
        """Keep the place of registering, so that ThisLaunchFileDir means the file that registered the handler."""
        self._locals = context.get_locals_as_dict()
        self._locals.pop('event', None)

    def handle(self, event: Event, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return the entities to visit because of the event."""
        context.extend_locals({**self._locals, 'event': event})
        if self._handle_once:
            context.unregister_event_handler(self)
        return to_entities(self._entities(event, context) if callable(self._entities) else self._entities)

    def describe(self) -> tuple[str, list[LaunchDescriptionEntity]]:
        """Return a line of text, and the entities as far as they are known."""
        text = (
            f"{type(self).__name__}(matcher='{self.matcher_description}', handler='{self.handler_description}', "
            f'handle_once={self.handle_once})'
        )
        return text, [] if callable(self._entities) else to_entities(self._entities)


BaseEventHandler = EventHandler
