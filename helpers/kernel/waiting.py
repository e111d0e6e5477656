"""Bounded waits for a notebook cell. The stop button interrupts each of them, and ROS goes on."""

import itertools
import signal
import threading
import time
from contextlib import contextmanager

from helpers.kernel import conditions
from helpers.kernel import nodes as node_list
from helpers.kernel.callback_errors import Failure, raise_failures
from helpers.kernel.executors import ExecutorWatch, StopSignal, activity, refuse_in_callback
from helpers.kernel.handles import handles, is_spinning, raise_pending

_SLICE = 0.05  # s; the longest time between two looks at the condition, and to answer the stop button
_numbers = itertools.count(1)


def spin_for(seconds: float, *nodes) -> None:
    """Let callbacks run for a while.

    With nodes, spins them in this thread for that long, as ``rclpy.spin`` does without an end. Without nodes, waits
    while those of `spinning` go on in the background; a node given here that spins there already just goes on.

    :param seconds: how long, in seconds.
    :raises CallbackError: a callback raised.
    """
    __tracebackhide__ = True
    refuse_in_callback('spin_for()')
    deadline = time.monotonic() + seconds
    here = [node for node in nodes if not is_spinning(node)]
    if here:
        _spin_here(here, _never, deadline)
    else:
        _wait(_never, deadline)


def wait_for(condition, timeout: float = 5.0, *, message: str = ''):
    """Wait until ``condition()`` is true, while nodes spin in the background, and return its value.

    :param condition: a function without arguments; called after each callback, and at least every 0.05 s.
    :param timeout: seconds.
    :param message: what is awaited, for the error text.
    :raises TimeoutError: the condition did not become true in time; says what it lacks, and names the living nodes.
    :raises CallbackError: a callback raised.
    """
    __tracebackhide__ = True
    refuse_in_callback('wait_for()')
    if not callable(condition):
        raise TypeError('wait_for() takes a function, as in wait_for(lambda: listener.count >= 3)')
    value = _wait(condition, time.monotonic() + timeout)
    if not value:
        raise TimeoutError(_in_vain(condition, timeout, message))
    return value


def _in_vain(condition, timeout: float, message: str) -> str:
    """What is said of a wait whose condition did not become true."""
    lacking = '' if message else conditions.lacking(condition)
    parts = [f'waited {timeout:g} s for {message or conditions.source(condition)}', lacking, _situation()]
    return '; '.join(part for part in parts if part)


def collect(topic: str, msg_type, count: int = 1, timeout: float = 5.0, qos=10) -> list:
    """Subscribe to a topic with a node of its own, return the first ``count`` messages, and destroy that node.

    :param topic: such as ``'/chatter'``.
    :param msg_type: message class, such as ``std_msgs.msg.String``.
    :param timeout: seconds.
    :param qos: history depth, or a ``QoSProfile``.
    :raises TimeoutError: fewer messages came in time; says how many, and what is known about the publishers.
    :raises TypeError: the topic is known to carry another type.
    :raises CallbackError: a callback of a background node raised.
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
        others = _types(node, topic)
        if others and _type_name(msg_type) not in others:  # Fast DDS would fail with an obscure message
            raise TypeError(f'{topic} carries {" and ".join(others)}, not {_type_name(msg_type)}')
        subscription = node.create_subscription(msg_type, topic, messages.append, qos)
        if not _spin_here([node], lambda: len(messages) >= count, time.monotonic() + timeout):
            came = f'{len(messages)} of {count} messages came on {topic} in {timeout:g} s'
            raise TimeoutError(f'{came}; {_publishers(node, subscription)}')
    finally:
        node_list.destroy(node)
    return messages[:count]


def _never() -> bool:
    return False


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
    """Spin nodes in this thread until the condition or the deadline; the first callback that raises ends it."""
    __tracebackhide__ = True
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.utilities import get_default_context

    from helpers import ros  # cleans up at the end of the process

    ros.tame_signals()
    context = nodes[0].context
    # rclpy's own executor, as in rclpy.spin: a coroutine that awaits something goes on in the next spin.
    own = context is not get_default_context()
    executor = SingleThreadedExecutor(context=context) if own else rclpy.get_global_executor()
    failures: list[Failure] = []
    watch = ExecutorWatch(executor, failures.append)
    watch.spinner = threading.get_ident()
    try:
        with _interrupts_deferred() as raise_interrupt:
            for node in nodes:
                executor.add_node(node)
            while True:
                raise_interrupt()
                raise_pending()
                raise_failures(failures)
                value = condition()
                left = deadline - time.monotonic()
                if value or left <= 0 or not context.ok():
                    return value
                executor.spin_once_until_future_complete(StopSignal(), min(_SLICE, left))
    finally:
        watch.end()
        for node in nodes:
            executor.remove_node(node)
        if own:
            executor.shutdown(timeout_sec=0)


@contextmanager
def _interrupts_deferred():
    """While this thread spins, let the stop button interrupt callbacks and waits, but not rclpy's own code.

    An exception at the wrong place in rclpy's executor leaves a callback group locked: its callbacks never run again.
    Yields a function that raises the KeyboardInterrupt that was put off, if any.
    """
    from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options

    pressed = []

    def handler(number, frame):
        while frame is not None:
            if frame.f_code.co_name == 'await_or_execute':  # rclpy's step from its own code into a callback
                raise KeyboardInterrupt
            frame = frame.f_back
        pressed.append(number)

    def raise_interrupt():
        __tracebackhide__ = True
        if pressed:
            raise KeyboardInterrupt

    in_main_thread = threading.current_thread() is threading.main_thread()
    if not in_main_thread or get_current_signal_handlers_options() != SignalHandlerOptions.NO:
        yield raise_interrupt
        return
    before = signal.signal(signal.SIGINT, handler)
    try:
        yield raise_interrupt
    finally:
        signal.signal(signal.SIGINT, before)


def _situation() -> str:
    """Say, for a wait that failed, which nodes live and whether something runs their callbacks."""
    living = [node for node in node_list.living() if node.context.ok()]
    if not living:
        return 'no node is alive'
    spun = sorted(node_list.full_name(node) for node in living if is_spinning(node))
    idle = sorted(node_list.full_name(node) for node in living if not is_spinning(node))
    parts = [sentence for handle in handles() for sentence in handle.stuck()]
    if spun:
        parts.append(f'spinning: {", ".join(spun)}')
    if idle:
        parts.append(f'alive but not spinning, so that no callback runs: {", ".join(idle)}')
    return '; '.join(parts)


def _publishers(node, subscription) -> str:
    """Say why messages may not have come: no publisher, another type, a QoS that does not fit, or nobody spins it."""
    from rclpy.qos import QoSCompatibility, qos_check_compatible

    infos = node.get_publishers_info_by_topic(subscription.topic_name)
    if not infos:
        return 'nobody publishes on it'
    wanted = _type_name(subscription.msg_type)
    notes = []
    for info in infos:
        name = f'{info.node_namespace.rstrip("/")}/{info.node_name}'
        verdict, reason = qos_check_compatible(info.qos_profile, subscription.qos_profile)
        ours = [node for node in node_list.living() if node_list.full_name(node) == name]
        if info.topic_type != wanted:
            notes.append(f'{name} publishes {info.topic_type}, not {wanted}')
        elif verdict == QoSCompatibility.ERROR:
            notes.append(f'the QoS of {name} does not fit: {_reason(reason)}')
        elif ours and not any(is_spinning(node) for node in ours):
            notes.append(f'{name} is connected, but does not spin, so that no timer runs')
        else:
            notes.append(f'{name} is connected')
    return '; '.join(notes)


def _types(node, topic: str) -> list[str]:
    """Return the types that are known to be used on a topic."""
    return dict(node.get_topic_names_and_types()).get(node.resolve_topic_name(topic), [])


def _type_name(msg_type) -> str:
    """Return a message class's ROS name, such as ``std_msgs/msg/String``."""
    package, kind = msg_type.__module__.split('.')[:2]
    return f'{package}/{kind}/{msg_type.__name__}'


def _reason(text: str) -> str:
    """Turn rclpy's ``ERROR: Best effort publisher and reliable subscription;`` into a part of a sentence."""
    return text.removeprefix('ERROR: ').strip(' ;').replace(';', ',')
