"""The one web server of a kernel, which all views share: meshcat's viewer, and a web socket for each view.

It is a thread of the kernel, so nothing can outlive the kernel, not even a killed one. The port (a free one, on the
loopback only) is opened for the first view and closed with the last.

meshcat brings a server of its own, a child process. It is not used: it takes and answers each pose as a command of its
own, at 0.1 ms to 0.2 ms of a processor; here one message carries all poses of an update. And it serves anyone on this
machine; ours answers only to those who know a secret, which is part of the address.
"""

import asyncio
import atexit
import itertools
import json
import os
import secrets
import threading
import time
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

from jinja2 import Environment

WEB = Path(__file__).parent / 'web'
_PING = 20.0  # s between two signs of life of a browser
_WAIT = 5.0  # s for the thread to begin or end
_AHEAD = 3  # messages on their way to a browser; it acknowledges each one that it has drawn
_PATIENCE = 2.0  # s that others wait for a browser that does not
_ENDED = 4000  # the code of a socket's end that tells the page not to connect again
_lock = threading.RLock()
_running: '_Server | None' = None
_numbers = itertools.count(1)


class Channel:
    """The browsers that watch one view; made by `open_channel`.

    :param everything: returns the message that brings an empty page up to date, and the number of the latest message
        that it includes; called in the server's thread.
    :param on_message: called in the server's thread with what a page sent, a dict.
    """

    def __init__(self, everything: Callable[[], tuple[bytes, int]], on_message: Callable[[dict], None]):
        self.everything, self.on_message = everything, on_message
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
        """Whether all browsers keep up; but a hidden or hanging one is waited for only shortly."""
        return all(socket.ready or socket.idle > _PATIENCE for socket in self.sockets.copy())

    def send(self, message: bytes, number: int) -> None:
        """Send to all browsers. One that is not ready misses it, and gets everything once it is ready again.

        :param number: of the message; it grows.
        """
        if self.sockets and self._server is not None:
            self._server.call(self._send, message, number)

    def close(self) -> None:
        """Send the browsers away; the last channel closes the port. Idempotent."""
        with _lock:
            server, self._server = self._server, None
            if server is not None:
                server.remove(self)

    def _send(self, message: bytes, number: int) -> None:
        for socket in self.sockets.copy():
            socket.offer(message, number)


def open_channel(everything: Callable[[], tuple[bytes, int]], on_message: Callable[[dict], None]) -> Channel:
    """Open a channel, and the server's port with the first one.

    :raises OSError: no port can be had.
    """
    global _running
    channel = Channel(everything, on_message)
    with _lock:
        if _running is None:
            _running = _Server()
        channel._server = _running
        _running.channels[channel.name] = channel
    return channel


def library() -> Path:
    """Return meshcat's viewer, with three.js in it: one script."""
    package = Path(find_spec('meshcat').origin).parent  # to import it takes long, and only this file is needed
    return package / 'viewer' / 'dist' / 'main.min.js'


def page(recording: str = '') -> str:
    """Return the page of a view as HTML.

    :param recording: what it replays, as base64 (see `recording`); '' for the page of a live view.
    """
    template = Environment(autoescape=True, trim_blocks=True, keep_trailing_newline=True)
    return template.from_string((WEB / 'page.html').read_text(encoding='utf-8')).render(recording=recording)


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
        self.channels: dict[str, Channel] = {}
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

    def remove(self, channel: Channel) -> None:
        """Forget a channel; without any, end."""
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

    def _end(self, channel: Channel) -> None:
        self._http.stop()
        _hang_up(channel)
        self._loop.call_later(0.05, self._loop.stop)  # let the good-byes out

    def _run(self) -> None:
        from tornado.httpserver import HTTPServer

        asyncio.set_event_loop(self._loop)
        self._http = HTTPServer(_application(self))
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


def _hang_up(channel: Channel) -> None:
    for socket in channel.sockets.copy():
        socket.close(_ENDED)


def _application(server: _Server):
    from tornado.web import Application, RequestHandler
    from tornado.websocket import WebSocketClosedError, WebSocketHandler

    class File(RequestHandler):
        """A file as it is."""

        def initialize(self, path: Path, kind: str) -> None:
            self.path, self.kind = path, kind

        def get(self) -> None:
            self.set_header('Content-Type', f'{self.kind}; charset=utf-8')
            self.set_header('Cache-Control', 'no-cache')
            self.write(self.path.read_bytes())

    class Page(RequestHandler):
        """The page of one view."""

        def get(self, name: str) -> None:
            if name not in server.channels:
                self.send_error(404)
                return
            self.set_header('Cache-Control', 'no-cache')
            self.write(page())

    class Ping(RequestHandler):
        """Tells the cell's script, which another server has sent, that this port can be reached."""

        def get(self) -> None:
            self.set_header('Access-Control-Allow-Origin', '*')
            self.write('ok')

    class Socket(WebSocketHandler):
        """One browser."""

        def check_origin(self, origin: str) -> bool:
            return True  # the secret in the address is what counts; a proxy changes the origin

        def open(self, name: str) -> None:
            self.channel = server.channels.get(name)
            self.on_way, self.behind, self.last, self.number = 0, False, time.monotonic(), -1
            if self.channel is None:
                self.close(_ENDED)
                return
            self.set_nodelay(True)
            self.channel.sockets.add(self)
            self.offer(*self.channel.everything())

        @property
        def ready(self) -> bool:
            return self.on_way < _AHEAD

        @property
        def idle(self) -> float:
            """Seconds since the browser last acknowledged a message."""
            return time.monotonic() - self.last

        def offer(self, message: bytes, number: int) -> None:
            if number <= self.number:
                return  # included in what it has got
            if not self.ready:
                self.behind = True
                return
            self.number = number
            self.on_way += 1
            try:
                sent = self.write_message(message, binary=True)
            except WebSocketClosedError:
                return
            sent.add_done_callback(lambda done: done.exception())  # it may close meanwhile: nothing to tell

        def on_message(self, message) -> None:
            content = json.loads(message)
            if self.channel is None or not isinstance(content, dict):
                return
            if isinstance(drawn := content.get('drawn'), int):
                self.on_way, self.last = max(0, self.on_way - drawn), time.monotonic()
                if self.behind and self.on_way == 0:
                    self.behind = False
                    self.offer(*self.channel.everything())
            else:
                self.channel.on_message(content)

        def on_close(self) -> None:
            if self.channel is not None:
                self.channel.sockets.discard(self)

    root = f'/{server.secret}'
    return Application([
        (f'{root}/ping', Ping),
        (f'{root}/meshcat.js', File, {'path': library(), 'kind': 'text/javascript'}),
        *((f'{root}/{path.name}', File, {'path': path, 'kind': 'text/javascript'}) for path in WEB.glob('*.js')),
        (f'{root}/viewer.css', File, {'path': WEB / 'viewer.css', 'kind': 'text/css'}),
        (f'{root}/([0-9]+)/', Page),
        (f'{root}/([0-9]+)/socket', Socket),
    ], websocket_ping_interval=_PING, log_function=lambda handler: None)


@atexit.register
def _at_exit() -> None:
    if _running is not None and os.getpid() == _running.process:
        close_all()
