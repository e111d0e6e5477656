"""What a notebook must not leave behind: valid rclpy contexts, threads, child processes.

CI puts a cell with ``note()`` before a notebook's first cell and one with ``check()`` after its last (see `repeated`).
Both run inside the kernel. Nothing is imported here that the notebook itself might not have imported.
"""

import gc
import sys
import threading
import time

import psutil
from IPython import get_ipython

PATIENCE = 3.0  # seconds for what is just ending
_threads: set[int | None] = set()
_children: set[int] = set()


def note() -> None:
    """Remember the threads and children that the kernel itself has."""
    get_ipython().run_cell_magic('script', 'cat', ' ')  # starts the thread that IPython keeps for %%bash
    _threads.update(thread.ident for thread in threading.enumerate())
    _children.update(child.pid for child in psutil.Process().children(recursive=True))


def check() -> None:
    """Wait until nothing is left over, for at most PATIENCE seconds.

    :raises AssertionError: naming what is left.
    """
    if tests_process := sys.modules.get('helpers.runner.tests_process'):
        tests_process.close()  # it waits for a next check
    end = time.monotonic() + PATIENCE
    while (left := _left()) and time.monotonic() < end:
        time.sleep(0.05)
    if left:
        raise AssertionError('left over at the end of the notebook: ' + '; '.join(left))


def _left() -> list[str]:
    return [*_contexts(), *_new_threads(), *_new_children()]


def _contexts():
    module = sys.modules.get('rclpy.context')
    if module is None:
        return
    for context in gc.get_objects():
        if type(context) is module.Context and context.ok():
            yield f'a valid rclpy context with {_nodes(context)} (call helpers.ros.stop() or rclpy.shutdown())'


def _nodes(context) -> str:
    node_type = sys.modules['rclpy.node'].Node if 'rclpy.node' in sys.modules else ()
    names = []
    for node in gc.get_objects():
        if isinstance(node, node_type) and node.context is context:
            try:
                names.append(node.get_name())
            except Exception:  # its handle is already destroyed: no node any more
                continue
    return f'node {", ".join(sorted(names))}' if names else 'no node'


def _new_threads():
    for thread in threading.enumerate():
        if thread.ident not in _threads and not isinstance(thread, threading._DummyThread):
            yield f'thread {thread.name}'


def _new_children():
    for child in psutil.Process().children(recursive=True):
        if child.pid in _children:
            continue
        try:
            command = child.cmdline()
            # the reaper lives as long as the kernel
            reaper = any(part.endswith('helpers/programs/reaper.py') for part in command)
            if child.status() != psutil.STATUS_ZOMBIE and not reaper:
                yield f'process {" ".join(command)[:80]}'
        except psutil.NoSuchProcess:
            continue
