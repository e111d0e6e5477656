"""What the views' web server answers: the page of each view, its files, and a web socket for each browser."""

import json
import time
from pathlib import Path

from tornado.web import Application, RequestHandler
from tornado.websocket import WebSocketClosedError, WebSocketHandler

from helpers.show.views import view_pages

_PING = 20.0  # s between two signs of life of a browser
_AHEAD = 3  # messages on their way to a browser; it acknowledges each one that it has drawn
_ENDED = 4000  # the code of a socket's end that tells the page not to connect again


def application(secret: str, channels: dict) -> Application:
    """Return the application of the server.

    :param secret: the first part of every address.
    :param channels: the open channels (`helpers.show.views.view_server.ViewerChannel`) by name.
    """
    scripts = {'meshcat.js': view_pages.library(), **{path.name: path for path in view_pages.WEB.glob('*.js')}}
    return Application(
        [
            (f'/{secret}/ping', PingHandler),
            *(
                (f'/{secret}/{name}', FileHandler, {'path': path, 'kind': 'text/javascript'})
                for name, path in scripts.items()
            ),
            (f'/{secret}/viewer.css', FileHandler, {'path': view_pages.WEB / 'viewer.css', 'kind': 'text/css'}),
            (f'/{secret}/([0-9]+)/', PageHandler, {'channels': channels}),
            (f'/{secret}/([0-9]+)/picture', PictureHandler, {'channels': channels}),
            (f'/{secret}/([0-9]+)/socket', BrowserHandler, {'channels': channels}),
        ],
        websocket_ping_interval=_PING,
        log_function=lambda handler: None,
    )


class FileHandler(RequestHandler):
    """A file as it is."""

    def initialize(self, path: Path, kind: str) -> None:
        self.path, self.kind = path, kind

    def get(self) -> None:
        self.set_header('Content-Type', f'{self.kind}; charset=utf-8')
        self.set_header('Cache-Control', 'no-cache')
        self.write(self.path.read_bytes())


class _ViewHandler(RequestHandler):
    """Answers for one view, as long as there is one of this name."""

    def initialize(self, channels: dict) -> None:
        self.channels = channels

    def get(self, name: str) -> None:
        if name not in self.channels:
            self.send_error(404)
            return
        self.set_header('Cache-Control', 'no-cache')
        self.answer(self.channels[name])

    def answer(self, channel) -> None:
        raise NotImplementedError


class PageHandler(_ViewHandler):
    """The page of one view."""

    def answer(self, channel) -> None:
        self.write(view_pages.page())


class PictureHandler(_ViewHandler):
    """What one view shows now, as an SVG, for a browser without WebGL."""

    def answer(self, channel) -> None:
        self.set_header('Content-Type', 'image/svg+xml; charset=utf-8')
        self.write(channel.picture())


class PingHandler(RequestHandler):
    """Tells the cell's script, which another server has sent, that this port can be reached."""

    def get(self) -> None:
        self.set_header('Access-Control-Allow-Origin', '*')
        self.write('ok')


class BrowserHandler(WebSocketHandler):
    """The socket of one browser. It gets no more messages than it draws: one that is behind gets everything later."""

    def initialize(self, channels: dict) -> None:
        self.channels = channels

    def check_origin(self, origin: str) -> bool:
        return True  # the secret in the address is what counts; a proxy changes the origin

    def open(self, name: str) -> None:
        self.channel = self.channels.get(name)
        self.on_way, self.behind, self.last, self.number = 0, False, time.monotonic(), -1
        if self.channel is None:
            self.end()
            return
        self.set_nodelay(True)
        self.channel.sockets.add(self)
        self.offer(*self.channel.everything())

    @property
    def ready(self) -> bool:
        """Whether the browser has drawn nearly all that it was sent."""
        return self.on_way < _AHEAD

    @property
    def idle(self) -> float:
        """Seconds since the browser last acknowledged a message."""
        return time.monotonic() - self.last

    def offer(self, message: bytes, number: int) -> None:
        """Send a message, unless the browser has it already or is not ready."""
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

    def end(self) -> None:
        """Close the socket; the page does not connect again."""
        self.close(_ENDED)

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
