"""Runs a program that tests."""

from __future__ import annotations

import sys

from launch import LaunchContext, LaunchDescriptionEntity, SomeSubstitutionsType
from launch.actions import EmitEvent, ExecuteProcess, TimerAction
from launch.event_handlers import OnProcessExit
from launch.events import matches_action
from launch.events.process import ShutdownProcess
from launch.substitutions import FindExecutable


class Test(ExecuteProcess):
    """
    Runs a program that tests, and ends it if it takes too long.

    Further keyword arguments are those of ``ExecuteProcess``.

    :param timeout: seconds; None for ever
    """

    __test__ = False  # for pytest: this is no class of cases

    def __init__(self, *, timeout: float | SomeSubstitutionsType | None = None, **kwargs):
        super().__init__(**kwargs)
        self._timeout = timeout

    @property
    def timeout(self) -> float | SomeSubstitutionsType | None:
        """Seconds that the program may take."""
        return self._timeout

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        entities = list(super().execute(context) or [])
        if not self._timeout:
            return entities
        end = EmitEvent(event=ShutdownProcess(process_matcher=matches_action(self)))
        timer = TimerAction(period=self._timeout, actions=[end])
        context.register_event_handler(
            OnProcessExit(target_action=self, on_exit=lambda event, context: timer.cancel(), handle_once=True)
        )
        return [*entities, timer]


class GTest(Test):
    """
    Runs a program that GoogleTest has made.

    :param path: the program
    """

    def __init__(self, *, path: SomeSubstitutionsType, **kwargs):
        super().__init__(cmd=[FindExecutable(name=path)], **kwargs)
        self._path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """The program."""
        return self._path


class PyTest(Test):
    """
    Runs tests with pytest.

    :param path: their file or folder
    """

    def __init__(self, *, path: SomeSubstitutionsType, **kwargs):
        super().__init__(cmd=[sys.executable, '-m', 'pytest', path], **kwargs)
        self._path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """The file or folder."""
        return self._path
