"""The notebook's stop button ends a wait of rclpy, too, such as ``rclpy.spin(node)`` of a node that has nothing to do.

Such a wait is in C and has no end, and Python raises KeyboardInterrupt only when it comes back from there. So a thread
hears of the signal, and wakes the executor that the main thread spins.
"""

import signal
import socket
import sys
import threading

from rclpy.executors import Executor

from helpers.kernel import journal

_listening: tuple[socket.socket, socket.socket] | None = None


def listen() -> None:
    """Begin to listen, in a kernel; does nothing outside of the main thread, and where something else listens."""
    global _listening
    if _listening or not journal.in_kernel() or threading.current_thread() is not threading.main_thread():
        return
    reader, writer = socket.socketpair()
    writer.setblocking(False)
    before = signal.set_wakeup_fd(writer.fileno(), warn_on_full_buffer=False)
    if before != -1:
        signal.set_wakeup_fd(before)
        reader.close()
        writer.close()
        return
    _listening = reader, writer
    threading.Thread(target=_listen, args=(reader,), daemon=True, name='stop button').start()


def end() -> None:
    """End listening; nothing is spun any more. Idempotent."""
    global _listening
    if _listening is None or threading.current_thread() is not threading.main_thread():
        return
    (_, writer), _listening = _listening, None
    now = signal.set_wakeup_fd(-1)
    if now != writer.fileno():  # somebody has taken its place
        signal.set_wakeup_fd(now)
    writer.close()  # the thread reads the end, and ends


def _listen(reader: socket.socket) -> None:
    with reader:
        while received := reader.recv(16):
            if signal.SIGINT in received:
                wake(threading.main_thread())


def wake(thread: threading.Thread) -> None:
    """Wake each executor that the thread spins."""
    frame = sys._current_frames().get(thread.ident or 0)
    while frame is not None:
        executor = frame.f_locals.get('self')
        if isinstance(executor, Executor):
            executor.wake()
        frame = frame.f_back
