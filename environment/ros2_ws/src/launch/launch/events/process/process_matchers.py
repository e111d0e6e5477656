"""Which processes an event is for."""

from collections.abc import Callable
from typing import Any


def matches_pid(pid: int) -> Callable[[Any], bool]:
    """Return a matcher for the process of that number."""
    return lambda action: _detail(action, 'pid') == pid


def matches_name(name: str) -> Callable[[Any], bool]:
    """Return a matcher for the process that the log calls so, e.g. ``talker-1``."""
    return lambda action: _detail(action, 'name') == name


def matches_executable(executable: str) -> Callable[[Any], bool]:
    """Return a matcher for the processes whose program has this path, or a path that ends so."""
    return lambda action: (_detail(action, 'cmd') or [''])[0].endswith(executable)


def _detail(action: Any, key: str) -> Any:
    """Return what is known of a process; None before it has been started."""
    return (action.process_details or {}).get(key)
