"""What programs ask of the daemon that stock's commands have: there is none here, and none is needed."""

from typing import Any


def is_daemon_running(args: Any) -> bool:
    """Return whether it runs."""
    return False


def spawn_daemon(args: Any, timeout: float | None = None, debug: bool = False) -> bool:
    """Return whether it was started."""
    return False


def shutdown_daemon(args: Any, timeout: float | None = None) -> bool:
    """Return whether it was stopped."""
    return False
