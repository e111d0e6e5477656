"""A process says on its standard output that it is ready."""

from __future__ import annotations

from collections.abc import Iterable

from launch.actions import ExecuteProcess
from launch.event_handlers import OnProcessIO
from launch.events.process import ProcessIO
from launch.launch_description_entity import LaunchDescriptionEntity


class StdoutReadyListener(OnProcessIO):
    """
    Gives actions when a process has written a text.

    :param target_action: the process; any, if None
    :param ready_txt: the text, anywhere in what is written
    :param actions: what shall be done
    """

    def __init__(
        self, *, target_action: ExecuteProcess | None = None, ready_txt: str, actions: Iterable[LaunchDescriptionEntity]
    ):
        self._text, self._actions = ready_txt, list(actions)
        self._begun: dict[str, str] = {}  # by process: the end of what was read, which may begin the text
        super().__init__(target_action=target_action, on_stdout=self._look)

    def _look(self, event: ProcessIO) -> list[LaunchDescriptionEntity] | None:
        written = self._begun.get(event.process_name, '') + event.text.decode(errors='replace')
        found = self._text in written
        self._begun[event.process_name] = '' if found or len(self._text) < 2 else written[1 - len(self._text) :]
        return self._actions if found else None

    def describe(self) -> tuple[str, list[LaunchDescriptionEntity]]:
        return super().describe()[0], self._actions
