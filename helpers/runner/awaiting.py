"""Callbacks whose `await` cannot end: what would end it waits for the callback group that they occupy themselves.

In rclpy an `async def` callback keeps its mutually exclusive group occupied until it has ended, also while it awaits.
In the learner's process this looks at the executor's unfinished tasks; what it finds is said where a test has failed.
"""

import inspect
import traceback
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Any

from rclpy.action import ActionClient
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.exceptions import InvalidHandle
from rclpy.node import Node
from rclpy.task import Future, Task

# Where rclpy's action client keeps the futures that it has given out and not yet answered.
_ACTION_FUTURES = '_pending_goal_requests', '_pending_cancel_requests', '_pending_result_requests'


def deadlocks(
    tasks: list[tuple], nodes: list[Node], lines: Callable[[traceback.StackSummary], list[dict]]
) -> list[str]:
    """A sentence for each callback that waits for its own callback group.

    :param tasks: of an executor: (task, whose callback it is, its node).
    :param lines: those of a stack that are the learner's (`LoadedProgram.lines`).
    """
    found: list[str] = []
    for task, entity, _ in list(tasks):
        group = getattr(entity, 'callback_group', None)
        if task.done() or not isinstance(group, MutuallyExclusiveCallbackGroup) or group._active_entity is not entity:
            continue
        stack, future = _suspended(task)
        if stack and future is not None and (own := lines(stack)):
            at = f'{own[-1]["cell"]}, line {own[-1]["line"]}: `{own[-1]["code"]:.100}`'
            found += _sentences(at, future, group, nodes)
    return found


def _sentences(at: str, future: Future, group: MutuallyExclusiveCallbackGroup, nodes: list[Node]) -> Iterator[str]:
    client = next((client for client, pending in _pending(nodes) if future in pending), None)
    if client is None:
        if any(_is_due(timer) for node in nodes for timer in node.timers if timer.callback_group is group):
            yield (
                f'A callback awaits at {at}. It occupies its callback group until it ends, and a timer of the same '
                'group is due and cannot run. What an `await` waits for needs a callback group of its own.'
            )
    elif client.callback_group is group:
        yield (
            f'A deadlock at {at}. A callback that awaits occupies its callback group until it ends, and the answer '
            'waits in the same group, so it is never taken. Give the client a callback group of its own.'
        )


def _suspended(task: Task) -> tuple[traceback.StackSummary | None, Future | None]:
    """The stack of a task's coroutine, and the future that it awaits; a task that it awaits is looked into."""
    stack: list[tuple] = []
    seen = []  # tasks that were looked into: some await each other in a circle
    coroutine: Any = task._handler
    while inspect.iscoroutine(coroutine) and coroutine.cr_await is not None:
        frame: Any = coroutine.cr_frame
        stack.append((frame, frame.f_lineno))
        coroutine = coroutine.cr_await
        if inspect.isgenerator(coroutine):  # that of `Future.__await__`
            future = inspect.getgeneratorlocals(coroutine).get('self')
            if not isinstance(future, Task) or not inspect.iscoroutine(future._handler) or future in seen:
                return traceback.StackSummary.extract(iter(stack)), future if isinstance(future, Future) else None
            seen.append(future)
            coroutine = future._handler
    return None, None


def _pending(nodes: list[Node]) -> Iterator[tuple[Any, list]]:
    """Each client of services and actions, with the futures that it has not answered."""
    for node in nodes:
        for client in node.clients:
            yield client, list(client._pending_requests.values())
        for waitable in node.waitables:
            if isinstance(waitable, ActionClient):
                yield waitable, [future for name in _ACTION_FUTURES for future in getattr(waitable, name).values()]


def _is_due(timer) -> bool:
    with suppress(InvalidHandle):  # one that was destroyed, but not by its node, is still in the node's list
        left = None if timer.is_canceled() else timer.time_until_next_call()
        return left is not None and left <= 0
    return False
