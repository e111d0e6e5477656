"""Ends the launched system."""

from __future__ import annotations

import launch.logging
from launch.actions.emit_event import EmitEvent
from launch.events import Shutdown as ShutdownEvent
from launch.events.process import ProcessExited
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text


@expose_action('shutdown')
class Shutdown(EmitEvent):
    """Ends the launched system; as ``on_exit`` of a process it makes that process a required one."""

    def __init__(self, *, reason: SomeSubstitutionsType = 'reason not given', **kwargs):
        super().__init__(event=ShutdownEvent(reason=reason), **kwargs)
        self._reason = reason

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``shutdown``."""
        _, kwargs = super().parse(entity, parser)
        reason = entity.get_attr('reason', optional=True)
        if reason is not None:
            kwargs['reason'] = parser.parse_substitution(reason)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        event = context.get_locals_as_dict().get('event')
        if isinstance(event, ProcessExited) and not context.is_shutdown:
            launch.logging.get_logger('launch').info(
                f'process[{event.process_name}] was required: shutting down launched system'
            )
        self.event.reason = to_text(context, self._reason)
        super().execute(context)
