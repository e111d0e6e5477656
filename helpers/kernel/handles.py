"""The handles of nodes that spin in the background (`helpers.kernel.spinning.Spinning`): those that are not stopped."""

from helpers.kernel.callback_errors import raise_failures

_handles: list = []


def add(handle) -> None:
    """Note a handle that begins to spin nodes."""
    _handles.append(handle)


def remove(handle) -> None:
    """Forget a handle that is stopped; idempotent."""
    if handle in _handles:
        _handles.remove(handle)


def handles() -> list:
    """Return the handles that are not stopped, oldest first."""
    return _handles.copy()


def is_spinning(node) -> bool:
    """Tell whether a background thread spins this node."""
    return any(node is mine for handle in handles() if handle.running for mine in handle.nodes)


def raise_pending() -> None:
    """Raise what callbacks of any handle have raised since the last wait, as a CallbackError."""
    __tracebackhide__ = True
    raise_failures([failure for handle in handles() for failure in handle.take_failures()])


def stop_all(timeout: float = 5.0) -> None:
    """Stop every handle; ``timeout`` as in `Spinning.stop`, for each."""
    for handle in handles():
        handle.stop(timeout)
