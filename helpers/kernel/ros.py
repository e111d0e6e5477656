"""Starting and stopping ROS in a kernel: idempotent, without signal handlers, and clean at the end of the process.

``start()`` initialises rclpy's default context, so plain ``Node('x')`` and ``rclpy.create_node('x')`` work as in every
tutorial. rclpy's own signal handlers are left out: in a kernel they would shut ROS down when the stop button is
pressed, and keep the button from interrupting a wait.

Importing this module also begins to track nodes (see `helpers.kernel.nodes`): in a kernel, a cell that creates a node
destroys the node of the same name that an earlier cell run left.
"""

import atexit
import os
from collections.abc import Callable

import rclpy
from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options, uninstall_signal_handlers
from rclpy.utilities import get_default_context

from helpers.kernel import journal, nodes, stop_button
from helpers.kernel.handles import stop_all

# Called when ROS is about to stop, for what is left in the notebook of something that has no node any more.
before_stop: list[Callable[[], None]] = []
_process = os.getpid()


def start(domain_id: int | None = None):
    """Initialise ROS if it is not running, and return rclpy's default context.

    Safe to call again, and after ``rclpy.shutdown()``. If ROS runs in another domain than the one asked for, it is
    stopped, with all nodes, and started again.

    :param domain_id: 0 to 101; by default the environment's ``ROS_DOMAIN_ID``, or 0.
    """
    context = get_default_context()
    if not context.ok() or domain_id not in (None, context.get_domain_id()):
        stop()
        rclpy.init(domain_id=domain_id, signal_handler_options=SignalHandlerOptions.NO)
    tame_signals()
    stop_button.listen()
    return get_default_context()


def stop(timeout: float = 5.0) -> None:
    """Stop all background spinning, destroy all nodes and shut rclpy's default context down; idempotent.

    :param timeout: seconds to wait for running callbacks, for each background thread.
    """
    for end in before_stop:
        end()
    stop_all(timeout)
    context = get_default_context()
    for node in nodes.living():
        if node.context is context or not node.context.ok():
            nodes.destroy(node)
    # rclpy forgets its global executor only if the shutdown goes through rclpy; a signal may have come before.
    executor = None if context.ok() else vars(rclpy).get('__executor')
    rclpy.try_shutdown()
    if executor is not None:
        executor.shutdown(timeout_sec=0)
        vars(rclpy)['__executor'] = None
    uninstall_signal_handlers()
    stop_button.end()


def tame_signals() -> None:
    """In a kernel, take away the signal handlers that a plain ``rclpy.init()`` has installed."""
    if journal.in_kernel() and get_current_signal_handlers_options() != SignalHandlerOptions.NO:
        uninstall_signal_handlers()


@atexit.register
def _at_exit() -> None:
    """Clean up: an executor thread that still spins when the interpreter goes away aborts the process."""
    if os.getpid() != _process:  # a forked child owns none of this
        return
    stop(timeout=1.0)
    for node in nodes.living():  # those of other contexts
        nodes.destroy(node)


nodes.track()
