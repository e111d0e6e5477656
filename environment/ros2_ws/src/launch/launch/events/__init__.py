"""Events."""

from __future__ import annotations

from launch.event import Event
from launch.events import process
from launch.events.process import matches_action

__all__ = ['ExecutionComplete', 'IncludeLaunchDescription', 'Shutdown', 'TimerEvent', 'matches_action', 'process']


class IncludeLaunchDescription(Event):
    """A launch description is to be visited."""

    name = 'launch.events.IncludeLaunchDescription'

    def __init__(self, launch_description):
        self.launch_description = launch_description


class TimerEvent(Event):
    """The time of a timer action has come."""

    name = 'launch.events.TimerEvent'

    def __init__(self, timer_action, local_variables: dict):
        self.timer_action, self.local_variables = timer_action, local_variables


class ExecutionComplete(Event):
    """An action has been executed."""

    name = 'launch.events.ExecutionComplete'

    def __init__(self, *, action):
        self.action = action


class Shutdown(Event):
    """The launched system is to end."""

    name = 'launch.events.Shutdown'

    def __init__(self, *, reason: str = 'reason not given', due_to_sigint: bool = False):
        self.reason, self.due_to_sigint = reason, due_to_sigint
