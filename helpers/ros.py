"""Starting and stopping ROS in a kernel: idempotent, without signal handlers, and clean at the end of the process.

``start()`` initialises rclpy's default context, so plain ``Node('x')`` and ``rclpy.create_node('x')`` work as in every
tutorial. rclpy's own signal handlers are left out: in a kernel they would shut ROS down when the stop button is
pressed, and they keep the button from interrupting a wait.

Importing this module also begins to track nodes (see `helpers.nodes`): in a kernel, a cell that creates a node destroys
the node of the same name that an earlier cell run left.
"""

import atexit
import os

import rclpy
from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options, uninstall_signal_handlers
from rclpy.utilities import get_default_context

from helpers import journal, nodes, spinning as _spinning_loaded  # noqa: F401  (at exit its handles are stopped)

_process = os.getpid()


def start(domain_id: int | None = None):
    """Initialise ROS if it is not running, and return rclpy's default context.

    Safe to call again, and after ``rclpy.shutdown()``. If ROS runs in another domain than the one asked for, it is
    stopped, with all nodes, and started again.

    :param domain_id: 0 to 101; by default the environment's ``ROS_DOMAIN_ID``, or 0.
    """
    context = get_default_context()
    if context.ok() and domain_id is not None and context.get_domain_id() != domain_id:
        stop()
        context = get_default_context()
    if not context.ok():
        _clear_remains()
        rclpy.init(domain_id=domain_id, signal_handler_options=SignalHandlerOptions.NO)
    tame_signals()
    return get_default_context()


def stop() -> None:
    """Stop background spinning, destroy all nodes and shut rclpy's default context down; idempotent."""
    _stop(timeout=5.0)


def tame_signals() -> None:
    """In a kernel, take away the signal handlers that a plain ``rclpy.init()`` installed."""
    if journal.in_kernel() and get_current_signal_handlers_options() != SignalHandlerOptions.NO:
        uninstall_signal_handlers()


def _stop(timeout: float) -> None:
    from helpers.spinning import stop_all

    stop_all(timeout)
    context = get_default_context()
    for node in nodes.living(context):
        nodes.destroy(node)
    _clear_remains()
    uninstall_signal_handlers()


def _clear_remains() -> None:
    """Shut the default context down; also one that something else (a signal) has shut down half."""
    from helpers.spinning import stop_all

    stop_all()
    context = get_default_context()
    for node in nodes.living(context):
        nodes.destroy(node)
    was_ok = context.ok()
    rclpy.try_shutdown()
    # rclpy forgets its global executor only when the shutdown itself goes through rclpy.
    executor = vars(rclpy).get('__executor')
    if not was_ok and executor is not None:
        executor.shutdown(timeout_sec=0)
        vars(rclpy)['__executor'] = None


@atexit.register
def _at_exit() -> None:
    """An executor thread that still spins when the interpreter goes away aborts the process, so it ends here."""
    if os.getpid() != _process:  # a forked child owns none of this
        return
    from helpers.spinning import stop_all

    stop_all(timeout=1.0)
    for node in nodes.living():
        nodes.destroy(node)
    rclpy.try_shutdown()


nodes.track()
