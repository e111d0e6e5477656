"""What the handlers of events of actions have in common."""

from __future__ import annotations

from launch.event import Event
from launch.event_handler import EventHandler
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.utilities import to_entities


class OnActionEventBase(EventHandler):
    """
    Handles the events of one kind, of one action or of all.

    :param action_matcher: an action, a function that says for an action whether it is meant, or None for all
    :param on_event: entities, or a function of (event, context) that returns some
    :param target_event_cls: the kind of event
    :param target_action_cls: the kind of action that it may come from; any, if None
    :raises TypeError: if the action or one of the entities is something else
    """

    def __init__(
        self,
        *,
        action_matcher,
        on_event,
        target_event_cls: type[Event],
        target_action_cls: type | None = None,
        **kwargs,
    ):
        kind = target_action_cls or LaunchDescriptionEntity
        if not (action_matcher is None or isinstance(action_matcher, kind) or callable(action_matcher)):
            raise TypeError(f"action_matcher must be an '{kind.__name__}' instance or a callable")
        if not callable(on_event):
            on_event = to_entities(on_event)
            for entity in on_event:
                if not isinstance(entity, LaunchDescriptionEntity):
                    raise TypeError(
                        f"expected all items in 'on_event' iterable to be of type 'LaunchDescriptionEntity' but got "
                        f"'{type(entity)}'"
                    )
        self._target, self._kind = action_matcher, target_event_cls
        self._source = kind.__name__
        super().__init__(matcher=self._accepts, entities=on_event, **kwargs)

    def _accepts(self, event: Event) -> bool:
        if not isinstance(event, self._kind):
            return False
        if self._target is None or event.action is self._target:
            return True
        # An action is no function, although a class of them may be callable.
        is_function = callable(self._target) and not isinstance(self._target, LaunchDescriptionEntity)
        return is_function and bool(self._target(event.action))

    @property
    def handler_description(self) -> str:
        """The function, or a word for the entities, which the description lists."""
        return str(self.entities) if callable(self.entities) else '<actions>'

    @property
    def matcher_description(self) -> str:
        """The kind of event and, if only some actions are meant, of action."""
        kind = f'event == {self._kind.__name__}'
        return kind if self._target is None else f'{kind} and {self._source}(event.action)'
