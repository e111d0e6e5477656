"""Handlers of events for launch files and tests."""

from launch_testing.event_handlers.stdout_ready_listener import StdoutReadyListener

__all__ = ['StdoutReadyListener']
