"""Waits, then does something."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable

from launch.action import Action
from launch.event_handlers import OnShutdown
from launch.events import TimerEvent
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities.type_utils import to_number


@expose_action('timer')
class TimerAction(Action):
    """
    Visits actions after a time. They see the launch configurations of the moment at which the time began to run.

    What they change of these is changed for themselves only.

    :param period: seconds, as a number or a text
    :param cancel_on_shutdown: do nothing any more once the system shuts down
    """

    def __init__(
        self,
        *,
        period: float | SomeSubstitutionsType,
        actions: Iterable[LaunchDescriptionEntity],
        cancel_on_shutdown: bool = True,
        **kwargs,
    ):
        super().__init__(**kwargs)
        self._period = period
        self.actions = list(actions)
        self._cancel_on_shutdown = cancel_on_shutdown
        self._future: asyncio.Future | None = None

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``timer``."""
        _, kwargs = super().parse(entity, parser)
        period = entity.get_attr('period', data_type=float, can_be_str=True)
        kwargs['period'] = parser.parse_if_substitutions(period)
        kwargs['actions'] = [parser.parse_action(child) for child in entity.children]
        return cls, kwargs

    @property
    def period(self) -> float | SomeSubstitutionsType:
        """Seconds, as given."""
        return self._period

    def describe(self) -> str:
        return 'TimerAction'

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return []

    def describe_conditional_sub_entities(self):
        return [(f'After {self._period} second(s)', self.actions)]

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return self.actions

    def cancel(self) -> None:
        """Do nothing any more; harmless if the time has passed."""
        if self._future is not None and not self._future.done():
            self._future.cancel()

    def execute(self, context: LaunchContext) -> None:
        self._future = future = context.asyncio_loop.create_future()
        local_variables, configurations = context.get_locals_as_dict(), dict(context.launch_configurations)

        def fire() -> None:
            if not future.done():
                context.emit_event_sync(TimerEvent(self, local_variables, configurations))
                future.set_result(None)

        stop_waiting = self._call_later(context, to_number(context, self._period), fire)
        future.add_done_callback(lambda _: stop_waiting())
        if self._cancel_on_shutdown:
            context.register_event_handler(OnShutdown(on_shutdown=lambda *_: self.cancel()))

    def _call_later(self, context: LaunchContext, seconds: float, function: Callable[[], None]) -> Callable[[], None]:
        """Call a function in the launch's loop after a time; return what makes it not be called any more."""
        return context.asyncio_loop.call_later(seconds, function).cancel

    def get_asyncio_future(self) -> asyncio.Future | None:
        return self._future
