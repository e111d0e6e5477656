"""One JSON object per line over a socket, with bounds on line length and waiting.

JSON only, never pickle: the other end may be hostile, and nothing it sends is executed here.
"""

import json
import select
import socket
import time

MAX_LINE = 4 * 1024 * 1024  # bytes
SEND_TIMEOUT = 60.0  # seconds until the other end must have read what is sent


class ChannelClosed(Exception):
    """The other end has gone."""


class ChannelTimeout(Exception):
    """No complete line came in time."""


class ChannelError(Exception):
    """The other end sent something that is not a JSON object in one bounded line."""


class Channel:
    """A line of JSON objects in each direction over a connected stream socket."""

    def __init__(self, sock: socket.socket):
        self.socket = sock
        sock.settimeout(SEND_TIMEOUT)
        self._buffer = bytearray()

    def send(self, message: dict) -> None:
        """Send one object. Raises ChannelClosed, or ChannelError if it is longer than MAX_LINE."""
        line = json.dumps(message, separators=(',', ':')).encode() + b'\n'
        if len(line) > MAX_LINE:
            raise ChannelError(f'a message of {len(line)} bytes is too long')
        try:
            self.socket.sendall(line)
        except OSError as error:
            raise ChannelClosed(str(error)) from None

    def receive(self, timeout: float | None = None) -> dict:
        """Wait at most `timeout` seconds (None: for ever) for one object.

        Raises ChannelTimeout, ChannelClosed, ChannelError.
        """
        deadline = None if timeout is None else time.monotonic() + timeout
        while (end := self._buffer.find(b'\n')) < 0:
            if len(self._buffer) > MAX_LINE:
                raise ChannelError('a line without end')
            remaining = None if deadline is None else deadline - time.monotonic()
            if remaining is not None and remaining < 0:
                raise ChannelTimeout()
            if not select.select([self.socket], [], [], remaining)[0]:
                raise ChannelTimeout()
            try:
                chunk = self.socket.recv(65536)
            except OSError as error:
                raise ChannelClosed(str(error)) from None
            if not chunk:
                raise ChannelClosed('end of stream')
            self._buffer += chunk
        line = bytes(self._buffer[:end])
        del self._buffer[: end + 1]
        try:
            message = json.loads(line)
        except (ValueError, RecursionError):
            raise ChannelError('a line that is not JSON') from None
        if not isinstance(message, dict):
            raise ChannelError('a line that is not a JSON object')
        return message

    def close(self) -> None:
        self.socket.close()
