"""Bounded waits for a notebook cell. The stop button interrupts each of them, and ROS goes on."""

import inspect
import itertools
import signal
import sys
import threading
import time
from contextlib import contextmanager

from helpers import nodes as node_list
from helpers.errors import Failure, raise_failures
from helpers.executors import Watch, activity, refuse_in_callback
from helpers.spinning import _StopSignal, handles, is_spinning, raise_pending

_SLICE = 0.05  # s; the longest time between two looks at the condition, and to answer the stop button
_numbers = itertools.count(1)


def spin_for(seconds: float, *nodes) -> None:
    """Let callbacks run for a while.

    With nodes, spins them in this thread, as ``rclpy.spin`` would, for that long. Without, just waits while the nodes of
    `spinning` go on in the background (nodes given here that already spin there do so too).

    :param seconds: how long, in seconds.
    :raises CallbackError: a callback raised.
    :raises KeyboardInterrupt: the stop button was pressed; nodes and ROS stay as they are.
    """
    __tracebackhide__ = True
    refuse_in_callback('spin_for()')
    raise_pending()
    deadline = time.monotonic() + seconds
    here = [node for node in nodes if not is_spinning(node)]
    if here:
        _spin_here(here, lambda: False, deadline)
    else:
        _wait(lambda: False, deadline)


def wait_for(condition, timeout: float = 5.0, *, message: str = ''):
    """Wait until ``condition()`` is true, while nodes spin in the background, and return its value.

    :param condition: a function without arguments; it is called again after each callback, and every 0.05 s.
    :param timeout: seconds.
    :param message: what is awaited, for the error text.
    :raises TimeoutError: the condition did not become true in time; names the living nodes.
    :raises CallbackError: a callback raised meanwhile.
    """
    __tracebackhide__ = True
    refuse_in_callback('wait_for()')
    if not callable(condition):
        raise TypeError('wait_for() takes a function, as in wait_for(lambda: listener.count >= 3)')
    value = _wait(condition, time.monotonic() + timeout)
    if not value:
        raise TimeoutError(f'waited {timeout:g} s for {message or _source(condition)}; {_situation()}')
    return value


def collect(topic: str, msg_type, count: int = 1, timeout: float = 5.0, qos=10) -> list:
    """Subscribe to a topic with a node of its own, return the first ``count`` messages, and destroy that node.

    :param topic: such as ``'/chatter'``.
    :param msg_type: message class, such as ``std_msgs.msg.String``.
    :param timeout: seconds.
    :param qos: history depth, or a ``QoSProfile``.
    :raises TimeoutError: fewer messages came in time; says how many, and what is known about the publishers.
    :raises CallbackError: a callback of a background node raised meanwhile.
    :raises RuntimeError: ROS is not started.
    """
    __tracebackhide__ = True
    refuse_in_callback('collect()')
    import rclpy
    from rclpy.node import Node

    if not rclpy.ok():
        raise RuntimeError('ROS is not started: run helpers.ros.start() first')
    messages: list = []
    node = Node(f'_collect_{next(_numbers)}', enable_rosout=False, start_parameter_services=False)
    try:
        subscription = node.create_subscription(msg_type, topic, messages.append, qos)
        if not _spin_here([node], lambda: len(messages) >= count, time.monotonic() + timeout):
            raise TimeoutError(
                f'{len(messages)} of {count} messages came on {topic} in {timeout:g} s; {_publishers(node, subscription)}'
            )
    finally:
        node_list.destroy(node)
    return messages[:count]


def _wait(condition, deadline: float):
    __tracebackhide__ = True
    while True:
        raise_pending()
        value = condition()
        left = deadline - time.monotonic()
        if value or left <= 0:
            return value
        with activity:
            activity.wait(min(_SLICE, left))


def _spin_here(nodes, condition, deadline: float):
    """Spin nodes in this thread until the condition or the deadline. The first callback that raises ends it."""
    __tracebackhide__ = True
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.utilities import get_default_context

    context = nodes[0].context
    # rclpy's own executor, as in rclpy.spin: a coroutine that awaits something goes on in the next spin.
    default = context is get_default_context()
    executor = rclpy.get_global_executor() if default else SingleThreadedExecutor(context=context)
    failures: list[Failure] = []
    for node in nodes:
        executor.add_node(node)
    watch = Watch(executor, failures.append)
    watch.spinner = threading.get_ident()
    try:
        with _interrupt_only_callbacks() as interrupted:
            while True:
                if interrupted():
                    raise KeyboardInterrupt
                raise_pending()
                raise_failures(failures)
                value = condition()
                left = deadline - time.monotonic()
                if value or left <= 0 or not context.ok():
                    return value
                executor.spin_once_until_future_complete(_StopSignal(), min(_SLICE, left))
    finally:
        watch.end()
        for node in nodes:
            executor.remove_node(node)
        if not default:
            executor.shutdown(timeout_sec=0)


@contextmanager
def _interrupt_only_callbacks():
    """While spinning in the main thread, let KeyboardInterrupt strike in callbacks and waits, not inside rclpy.

    An exception at the wrong place in rclpy's executor leaves a callback group locked: its callbacks never run again.
    """
    pressed = False

    def handler(number, frame):
        nonlocal pressed
        pressed = True
        while frame is not None:
            if frame.f_code.co_name == 'await_or_execute':
                pressed = False
                raise KeyboardInterrupt
            frame = frame.f_back

    if threading.current_thread() is not threading.main_thread():
        yield lambda: False
        return
    before = signal.signal(signal.SIGINT, handler)
    try:
        yield lambda: pressed
    finally:
        signal.signal(signal.SIGINT, before)


def _situation() -> str:
    """Say, for a wait that failed, which nodes live and whether something runs their callbacks."""
    living = [node for node in node_list.living() if node.context.ok()]
    if not living:
        return 'no node is alive'
    spun = sorted(node_list.full_name(node) for node in living if is_spinning(node))
    idle = sorted(node_list.full_name(node) for node in living if not is_spinning(node))
    parts = []
    if spun:
        parts.append(f'spinning: {", ".join(spun)}')
    if idle:
        parts.append(f'alive but not spinning, so without callbacks: {", ".join(idle)}')
    for handle in handles():
        for work in handle._watch.running():
            if work.seconds > 1.0:
                parts.append(f'{work.callback} of node {work.node_name} has been running for {work.seconds:.1f} s')
    return '; '.join(parts)


def _source(condition) -> str:
    """Show a condition as it is written: a lambda's line, or the function's name."""
    name = getattr(condition, '__qualname__', repr(condition))
    if '<lambda>' not in name:
        return f'{name}()'
    try:
        return inspect.getsource(condition).strip().splitlines()[0]
    except (OSError, TypeError, IndexError):
        return 'the condition'


def _publishers(node, subscription) -> str:
    """Say why messages may not have come: no publisher, another type, or a QoS that does not fit."""
    from rclpy.qos import QoSCompatibility, qos_check_compatible

    infos = node.get_publishers_info_by_topic(subscription.topic_name)
    if not infos:
        return 'nobody publishes on it'
    wanted = '/'.join(_type_parts(subscription.msg_type))
    notes = []
    for info in infos:
        name = f'{info.node_namespace.rstrip("/")}/{info.node_name}'
        verdict, reason = qos_check_compatible(info.qos_profile, subscription.qos_profile)
        if info.topic_type != wanted:
            notes.append(f'{name} publishes {info.topic_type}, not {wanted}')
        elif verdict == QoSCompatibility.ERROR:
            notes.append(f'the QoS of {name} does not fit: {reason.strip()}')
        else:
            notes.append(f'{name} is connected' + ('' if _is_spun_or_foreign(name) else ', but nothing spins it'))
    return '; '.join(notes)


def _is_spun_or_foreign(name: str) -> bool:
    mine = [node for node in node_list.living() if node_list.full_name(node) == name]
    return not mine or any(is_spinning(node) for node in mine)


def _type_parts(msg_type) -> tuple[str, str, str]:
    package, kind = msg_type.__module__.split('.')[:2]
    return package, kind, msg_type.__name__


_ = sys
