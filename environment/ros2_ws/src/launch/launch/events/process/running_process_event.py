"""Something about a process."""

from __future__ import annotations

from launch.event import Event


class RunningProcessEvent(Event):
    """Something happened to a process."""

    name = 'launch.events.process.RunningProcessEvent'

    def __init__(self, *, action, name: str, cmd: list[str], cwd: str | None, env: dict | None, pid: int):
        self.action, self.process_name, self.cmd, self.cwd, self.env, self.pid = action, name, cmd, cwd, env, pid

    @property
    def execute_process_action(self):
        """The action that started the process."""
        return self.action
