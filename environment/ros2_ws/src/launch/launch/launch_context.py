"""What actions and substitutions know while launching."""

from __future__ import annotations

import asyncio
import contextlib
import os
from collections import deque
from collections.abc import Iterable, MutableMapping
from types import SimpleNamespace
from typing import Any

from launch.event import Event
from launch.substitution import Substitution


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
        self._configuration_stack: list[dict[str, Any]] = []
        self._temporary_files: list[str] = []
        self._environment_stack: list[dict[str, str]] = []

    @property
    def environment(self) -> MutableMapping[str, str]:
        """The environment that processes inherit."""
        return os.environ

    def remove_at_end(self, path: str) -> None:
        """Remove a file when the launch has ended and no process can want it any more."""
        self._temporary_files.append(path)

    def remove_temporary_files(self) -> None:
        """Remove the files of ``remove_at_end``."""
        while self._temporary_files:
            with contextlib.suppress(OSError):
                os.remove(self._temporary_files.pop())

    # --- texts ------------------------------------------------------------------------------------------------

    def perform_substitution(self, substitution: Substitution) -> str:
        """Return the text of a substitution."""
        return substitution.perform(self)

    # --- locals: what is known only while an event is handled or a file is visited ----------------------------

    @property
    def locals(self) -> SimpleNamespace:
        """The local variables, e.g. ``event`` and ``current_launch_file_directory``."""
        return SimpleNamespace(**self.get_locals_as_dict())

    def get_locals_as_dict(self) -> dict[str, Any]:
        """Return a copy of the local variables."""
        return dict(self._locals[-1])

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

    # --- scopes of GroupAction --------------------------------------------------------------------------------

    def push_scope(self, *, forwarding: bool = True) -> None:
        """Save configurations and environment; without forwarding begin with no configuration."""
        self._configuration_stack.append(self.launch_configurations)
        self.launch_configurations = dict(self.launch_configurations) if forwarding else {}
        self._environment_stack.append(dict(self.environment))

    def pop_scope(self) -> None:
        """Go back to the configurations and the environment saved last."""
        self.launch_configurations = self._configuration_stack.pop()
        saved = self._environment_stack.pop()
        for name in [name for name in self.environment if name not in saved]:
            del self.environment[name]
        self.environment.update(saved)

    # --- events -----------------------------------------------------------------------------------------------

    @property
    def event_handlers(self) -> tuple:
        """The registered handlers; the newest comes first."""
        return tuple(self._handlers)

    def register_event_handler(self, handler) -> None:
        """Let a handler see events from now on."""
        self._handlers.insert(0, handler)

    def unregister_event_handler(self, handler) -> None:
        """
        Let a handler see no more events.

        :raises ValueError: if it is not registered
        """
        self._handlers.remove(handler)

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

    def is_awaited(self, event: Event) -> bool:
        """Return True if a handler wants the event."""
        return any(handler.matches(event) for handler in self._handlers)

    async def emit_event(self, event: Event) -> None:
        """Queue an event."""
        self.emit_event_sync(event)

    def add_future(self, future: asyncio.Future) -> None:
        """Keep the launch going until a future is done; its exception ends the launch."""
        self._futures.append(future)
        future.add_done_callback(lambda _: self._wakeup.set())
