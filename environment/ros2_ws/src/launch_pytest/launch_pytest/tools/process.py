"""
Waiting for what processes do, from a test (``…_sync``) or in a coroutine.

``wait_for_…`` return whether it has happened in time; ``assert_…`` show in the end why it has not. The function that
validates an output gets all of it so far, and may return a truth value or use assertions. The action needs
``cached_output=True``. A timeout is in seconds; None waits without end.
"""

from __future__ import annotations

import asyncio
import threading
import time
from collections.abc import Callable
from contextlib import contextmanager

from launch import LaunchContext
from launch.actions import ExecuteProcess
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart

Validate = Callable[[str], object]


async def wait_for_start(
    launch_context: LaunchContext, execute_process_action: ExecuteProcess, timeout: float | None = None
) -> bool:
    """Wait until a process has started."""
    return await _wait(launch_context, execute_process_action, _has_started(execute_process_action), timeout)


def wait_for_start_sync(
    launch_context: LaunchContext, execute_process_action: ExecuteProcess, timeout: float | None = None
) -> bool:
    """Wait until a process has started."""
    return _wait_sync(launch_context, execute_process_action, _has_started(execute_process_action), timeout)


async def wait_for_exit(
    launch_context: LaunchContext, execute_process_action: ExecuteProcess, timeout: float | None = None
) -> bool:
    """Wait until a process has ended."""
    return await _wait(launch_context, execute_process_action, _has_ended(execute_process_action), timeout)


def wait_for_exit_sync(
    launch_context: LaunchContext, execute_process_action: ExecuteProcess, timeout: float | None = None
) -> bool:
    """Wait until a process has ended."""
    return _wait_sync(launch_context, execute_process_action, _has_ended(execute_process_action), timeout)


async def wait_for_output(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> bool:
    """Wait until the standard output is valid."""
    condition = _valid(execute_process_action.get_stdout, validate_output)
    return await _wait(launch_context, execute_process_action, condition, timeout)


def wait_for_output_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> bool:
    """Wait until the standard output is valid."""
    condition = _valid(execute_process_action.get_stdout, validate_output)
    return _wait_sync(launch_context, execute_process_action, condition, timeout)


async def wait_for_stderr(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> bool:
    """Wait until the standard error is valid."""
    condition = _valid(execute_process_action.get_stderr, validate_output)
    return await _wait(launch_context, execute_process_action, condition, timeout)


def wait_for_stderr_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> bool:
    """Wait until the standard error is valid."""
    condition = _valid(execute_process_action.get_stderr, validate_output)
    return _wait_sync(launch_context, execute_process_action, condition, timeout)


async def assert_output(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until the standard output is valid; otherwise fail with the last word of ``validate_output``."""
    if not await wait_for_output(launch_context, execute_process_action, validate_output, timeout):
        _fail(validate_output, execute_process_action.get_stdout())


def assert_output_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until the standard output is valid; otherwise fail with the last word of ``validate_output``."""
    if not wait_for_output_sync(launch_context, execute_process_action, validate_output, timeout):
        _fail(validate_output, execute_process_action.get_stdout())


async def assert_stderr(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until the standard error is valid; otherwise fail with the last word of ``validate_output``."""
    if not await wait_for_stderr(launch_context, execute_process_action, validate_output, timeout):
        _fail(validate_output, execute_process_action.get_stderr())


def assert_stderr_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until the standard error is valid; otherwise fail with the last word of ``validate_output``."""
    if not wait_for_stderr_sync(launch_context, execute_process_action, validate_output, timeout):
        _fail(validate_output, execute_process_action.get_stderr())


def _fail(validate_output: Validate, output: str) -> None:
    valid = validate_output(output)
    assert valid or valid is None, f'the output is not as expected: {output!r}'


def _valid(read: Callable[[], str], validate_output: Validate) -> Callable[[], bool]:
    def condition() -> bool:
        try:
            valid = validate_output(read())
        except AssertionError:
            return False
        return valid is None or bool(valid)

    return condition


def _has_started(action: ExecuteProcess) -> Callable[[], bool]:
    return lambda: 'pid' in (action.process_details or {})


def _has_ended(action: ExecuteProcess) -> Callable[[], bool]:
    return lambda: action.return_code is not None


@contextmanager
def _told(context: LaunchContext, action: ExecuteProcess, tell: Callable[[], None]):
    """Call a function whenever a process starts, writes or ends."""

    def on_output(_event):
        tell()

    def on_change(_event, _context):
        tell()

    handlers = [
        OnProcessStart(target_action=action, on_start=on_change),
        OnProcessIO(target_action=action, on_stdout=on_output, on_stderr=on_output),
        OnProcessExit(target_action=action, on_exit=on_change),
    ]
    for handler in handlers:
        context.register_event_handler(handler, append=True)
    try:
        yield
    finally:
        for handler in handlers:
            context.unregister_event_handler(handler)


def _wait_sync(
    context: LaunchContext, action: ExecuteProcess, condition: Callable[[], bool], timeout: float | None
) -> bool:
    changed = threading.Event()
    end = None if timeout is None else time.monotonic() + timeout
    with _told(context, action, changed.set):
        while not condition():
            left = None if end is None else end - time.monotonic()
            if left is not None and left <= 0.0:
                return False
            changed.wait(left)
            changed.clear()
    return True


async def _wait(
    context: LaunchContext, action: ExecuteProcess, condition: Callable[[], bool], timeout: float | None
) -> bool:
    changed = asyncio.Event()
    end = None if timeout is None else time.monotonic() + timeout
    with _told(context, action, changed.set):
        while not condition():
            left = None if end is None else end - time.monotonic()
            if left is not None and left <= 0.0:
                return False
            try:
                await asyncio.wait_for(changed.wait(), left)
            except asyncio.TimeoutError:
                continue
            changed.clear()
    return True
