"""The time of a timer action."""

from __future__ import annotations

from launch.event import Event


class TimerEvent(Event):
    """The time of a timer action has come."""

    name = 'launch.events.TimerEvent'

    def __init__(self, timer_action, local_variables: dict | None = None, launch_configurations: dict | None = None):
        self.timer_action, self.local_variables = timer_action, local_variables or {}
        self.launch_configurations = launch_configurations or {}
