"""What actions and substitutions know while launching."""

from __future__ import annotations

import asyncio
import contextlib
import os
from collections import deque
from collections.abc import Callable, Iterable, Mapping, MutableMapping
from typing import Any

from launch.event import Event
from launch.substitution import Substitution


class _Locals:
    """The local variables as attributes, to be read only."""

    def __init__(self, values: dict[str, Any]):
        vars(self).update(values)

    def __getattr__(self, name: str):
        known = ', '.join(vars(self))
        raise AttributeError(f"context.locals does not contain attribute '{name}', it contains: [{known}]")

    def __setattr__(self, name: str, value: Any):
        raise AttributeError(f"can't set attribute '{name}', locals are read-only; see extend_locals of the context")


class LaunchContext:
    """
    The state of one launch: configurations, environment, event handlers, the event queue.

    :param argv: the launch arguments as typed
    :param noninteractive: True if nobody sits at a terminal
    """

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False):
        self.argv = list(argv or [])
        self.noninteractive = noninteractive
        self.launch_configurations: dict[str, Any] = {}
        self.is_shutdown = False
        self.asyncio_loop: asyncio.AbstractEventLoop | None = None
        self.running_processes: list = []
        self._handlers: list = []
        self._queue: deque[Event] = deque()
        self._wakeup = asyncio.Event()
        self._futures: list[asyncio.Future] = []
        self._locals: list[dict[str, Any]] = [{}]
        self._globals: dict[str, Any] = {}
        self._configuration_stack: list[dict[str, Any]] = []
        self._first_environment = dict(os.environ)
        self._at_end: list[Callable[[], None]] = []
        self._environment_stack: list[dict[str, str]] = []

    @property
    def environment(self) -> MutableMapping[str, str]:
        """The environment that processes inherit."""
        return os.environ

    def call_at_end(self, function: Callable[[], None]) -> None:
        """Call a function when the launch has ended and no process runs any more; the last one given comes first."""
        self._at_end.append(function)

    def close(self) -> None:
        """Call the functions of ``call_at_end``."""
        while self._at_end:
            self._at_end.pop()()

    # --- texts ------------------------------------------------------------------------------------------------

    def perform_substitution(self, substitution: Substitution) -> str:
        """Return the text of a substitution."""
        return substitution.perform(self)

    # --- locals: what is known only while an event is handled or a file is visited ----------------------------

    @property
    def locals(self) -> Any:
        """The local variables as attributes, e.g. ``event`` and ``current_launch_file_directory``; not to be set."""
        return _Locals(self.get_locals_as_dict())

    def get_locals_as_dict(self) -> dict[str, Any]:
        """Return a copy of the local variables, the global ones among them."""
        return {**self._globals, **self._locals[-1]}

    def extend_globals(self, extensions: dict[str, Any]) -> None:
        """Set variables that last to the end of the launch."""
        self._globals.update(extensions)

    def extend_locals(self, extensions: dict[str, Any]) -> None:
        """Set local variables; they last until ``pop_locals``."""
        self._locals[-1].update(extensions)

    def push_locals(self, extensions: dict[str, Any]) -> None:
        """Save the local variables and begin with the old ones and ``extensions``."""
        self._locals.append({**self._locals[-1], **extensions})

    def pop_locals(self) -> None:
        """Go back to the local variables saved last."""
        self._locals.pop()

    @contextlib.contextmanager
    def local_scope(self, extensions: dict[str, Any] | None = None):
        """Put the local variables back at the end, also if an error left some saved ones behind."""
        depth = len(self._locals)
        self.push_locals(extensions or {})
        try:
            yield
        finally:
            del self._locals[depth:]

    @contextlib.contextmanager
    def configuration_scope(self, configurations: Mapping[str, Any]):
        """Use other launch configurations, and put those of now back at the end, also after an error."""
        saved, depth = self.launch_configurations, len(self._configuration_stack)
        self.launch_configurations = dict(configurations)
        try:
            yield
        finally:
            del self._configuration_stack[depth:]
            self.launch_configurations = saved

    # --- scopes of GroupAction --------------------------------------------------------------------------------

    def push_launch_configurations(self) -> None:
        """Save the configurations; later changes last until ``pop_launch_configurations``."""
        self._configuration_stack.append(self.launch_configurations)
        self.launch_configurations = dict(self.launch_configurations)

    def pop_launch_configurations(self) -> None:
        """Go back to the configurations saved last."""
        self.launch_configurations = self._configuration_stack.pop()

    def push_environment(self) -> None:
        """Save the environment; later changes last until ``pop_environment``."""
        self._environment_stack.append(dict(self.environment))

    def pop_environment(self) -> None:
        """Go back to the environment saved last."""
        self._set_environment(self._environment_stack.pop())

    def reset_environment(self) -> None:
        """Go back to the environment that the launch began with."""
        self._set_environment(self._first_environment)

    def _set_environment(self, variables: dict[str, str]) -> None:
        for name in [name for name in self.environment if name not in variables]:
            del self.environment[name]
        self.environment.update(variables)

    # --- events -----------------------------------------------------------------------------------------------

    @property
    def event_handlers(self) -> tuple:
        """The registered handlers; the newest comes first."""
        return tuple(self._handlers)

    def register_event_handler(self, event_handler, append: bool = False) -> None:
        """Let a handler see events from now on, before the others or, with ``append``, after them."""
        self._handlers.insert(len(self._handlers) if append else 0, event_handler)

    def unregister_event_handler(self, event_handler) -> None:
        """
        Let a handler see no more events.

        :raises ValueError: if it is not registered
        """
        self._handlers.remove(event_handler)

    def emit_event_sync(self, event: Event, *, urgent: bool = False) -> None:
        """
        Queue an event, an urgent one before all others.

        Only for the thread that launches; others use ``LaunchService.emit_event``.
        """
        if urgent:
            self._queue.appendleft(event)
        else:
            self._queue.append(event)
        self._wakeup.set()

    def would_handle_event(self, event: Event) -> bool:
        """Return True if a handler wants the event."""
        return any(handler.matches(event) for handler in self._handlers)

    async def emit_event(self, event: Event) -> None:
        """Queue an event."""
        self.emit_event_sync(event)

    def add_future(self, future: asyncio.Future) -> None:
        """Keep the launch going until a future is done; its exception ends the launch."""
        self._futures.append(future)
        future.add_done_callback(lambda _: self._wakeup.set())
