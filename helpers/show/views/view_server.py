"""The one web server of a kernel, which all views share: meshcat's viewer, and a web socket for each view.

It is a thread of the kernel, so it ends with the kernel, also with one that is killed. The port (a free one, on the
loopback only) is opened for the first view and closed with the last.

meshcat brings a server of its own, a child process. It is not used: it takes and answers each pose as a command of its
own, at 0.1 ms to 0.2 ms of a processor; here one message carries all poses of an update. And it serves anyone on this
machine; ours answers only to those who know a secret, which is part of the address.
"""

import asyncio
import atexit
import itertools
import os
import secrets
import threading
from collections.abc import Callable

_WAIT = 5.0  # s for the thread to begin or end
_PATIENCE = 2.0  # s that others wait for a browser that does not
_lock = threading.RLock()
_running: '_Server | None' = None
_numbers = itertools.count(1)


class ViewerChannel:
    """The browsers that watch one view; made by `open_channel`.

    :param everything: returns the message that brings an empty page up to date, and the number of the latest message
        that it includes; called in the server's thread.
    :param on_message: called in the server's thread with what a page sent, a dict.
    :param picture: returns what the view shows as an SVG; called in the server's thread.
    """

    def __init__(
        self,
        everything: Callable[[], tuple[bytes, int]],
        on_message: Callable[[dict], None],
        picture: Callable[[], str],
    ):
        self.everything, self.on_message, self.picture = everything, on_message, picture
        self.name = str(next(_numbers))
        self.sockets: set = set()
        self._server = None

    @property
    def path(self) -> str:
        """Where the page is, below the root of the port."""
        return f'/{self._server.secret}/{self.name}/'

    @property
    def port(self) -> int:
        """The TCP port."""
        return self._server.port

    @property
    def watched(self) -> bool:
        """Whether any browser watches."""
        return bool(self.sockets)

    @property
    def ready(self) -> bool:
        """Whether all browsers have drawn what they got. One that is hidden or hangs is waited for 2 s only."""
        return all(socket.ready or socket.idle > _PATIENCE for socket in self.sockets.copy())

    def send(self, message: bytes, number: int) -> None:
        """Send to all browsers. One that is not ready misses it, and gets everything once it is ready again.

        :param number: of the message; it grows.
        """
        if self.sockets and self._server is not None:
            self._server.call(self._send, message, number)

    def close(self) -> None:
        """Close the browsers' sockets; the last channel closes the port. Idempotent."""
        with _lock:
            server, self._server = self._server, None
            if server is not None:
                server.remove(self)

    def _send(self, message: bytes, number: int) -> None:
        for socket in self.sockets.copy():
            socket.offer(message, number)


def open_channel(
    everything: Callable[[], tuple[bytes, int]], on_message: Callable[[dict], None], picture: Callable[[], str]
) -> ViewerChannel:
    """Open a channel (see `ViewerChannel`), and the server's port with the first one.

    :raises OSError: no port can be had.
    """
    global _running
    channel = ViewerChannel(everything, on_message, picture)
    with _lock:
        if _running is None:
            _running = _Server()
        channel._server = _running
        _running.channels[channel.name] = channel
    return channel


def close_all() -> None:
    """Close every channel and the port; idempotent."""
    with _lock:
        if _running is not None:
            for channel in list(_running.channels.values()):
                channel.close()


class _Server:
    """The thread with its event loop."""

    def __init__(self):
        from tornado.netutil import bind_sockets

        self.secret = secrets.token_urlsafe(12)
        self.channels: dict[str, ViewerChannel] = {}
        self.process = os.getpid()
        self._sockets = bind_sockets(0, '127.0.0.1')
        self.port = self._sockets[0].getsockname()[1]
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._run, daemon=True, name='views')
        self._thread.start()

    def call(self, function, *arguments) -> None:
        """Call in the thread of the server, if it still runs."""
        try:
            self._loop.call_soon_threadsafe(function, *arguments)
        except RuntimeError:  # closed meanwhile
            pass

    def remove(self, channel: ViewerChannel) -> None:
        """Remove a channel; after the last one, end the server."""
        global _running
        self.channels.pop(channel.name, None)
        if os.getpid() != self.process:  # a forked child: the thread is not here
            return
        if self.channels:
            self.call(_hang_up, channel)
            return
        if _running is self:
            _running = None
        self.call(self._end, channel)
        if threading.current_thread() is not self._thread:
            self._thread.join(_WAIT)

    def _end(self, channel: ViewerChannel) -> None:
        self._http.stop()
        _hang_up(channel)
        self._loop.call_later(0.05, self._loop.stop)  # time to send the closing messages

    def _run(self) -> None:
        from tornado.httpserver import HTTPServer

        from helpers.show.views import handlers  # with tornado, which takes long to import

        asyncio.set_event_loop(self._loop)
        self._http = HTTPServer(handlers.application(self.secret, self.channels))
        self._http.add_sockets(self._sockets)
        try:
            self._loop.run_forever()
        finally:
            self._loop.run_until_complete(self._http.close_all_connections())
            pending = asyncio.all_tasks(self._loop)
            for task in pending:
                task.cancel()
            self._loop.run_until_complete(asyncio.gather(*pending, return_exceptions=True))
            self._loop.close()


def _hang_up(channel: ViewerChannel) -> None:
    for socket in channel.sockets.copy():
        socket.end()


@atexit.register
def _at_exit() -> None:
    if _running is not None and os.getpid() == _running.process:
        close_all()
