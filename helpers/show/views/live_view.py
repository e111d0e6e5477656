"""The live renderer: a scene in meshcat's viewer, in the output of a cell; flat pictures where there is no WebGL.

One message for each update carries everything that has changed: a little JSON, and all numbers as one block of binary
data. What it says is in `encode`, who reads it in ``web/nodes.js``. Without a browser nothing is encoded.
"""

import base64
import json
import secrets
import struct
import threading
from collections.abc import Callable
from dataclasses import fields

import numpy as np
from jinja2 import Environment

from helpers.show.views import view_pages, view_server
from helpers.show.views.scene import Changes, Scene

_CELL = Environment(autoescape=True).from_string((view_pages.WEB / 'cell.html').read_text(encoding='utf-8'))


class LiveRenderer:
    """Shows a scene to all browsers that look, from its making until `close`.

    :param scene: what to show; no other code may take its changes.
    :param state: returns what the page shows beside the scene (see `tf_view`), fit for JSON.
    :param on_message: called with what the page's controls say, a dict, in the server's thread.
    :param picture: returns the scene as an SVG, for browsers without WebGL; called in the server's thread.
    :raises OSError: no port can be had.
    """

    def __init__(
        self, scene: Scene, state: Callable[[], dict], on_message: Callable[[dict], None], picture: Callable[[], str]
    ):
        self._scene, self._state = scene, state
        self._shown: dict | None = None
        self._sent = 0  # updates so far
        self._order = threading.Lock()  # between an update and the whole for a new page
        self._channel = view_server.open_channel(self._everything, on_message, picture)

    @property
    def address(self) -> str:
        """The page, as a program on this machine opens it."""
        return f'http://127.0.0.1:{self._channel.port}{self._channel.path}'

    @property
    def watched(self) -> bool:
        """Whether a browser shows it."""
        return self._channel.watched

    def update(self, final: bool = False) -> None:
        """Send what has changed since the last time, if the browsers are ready; otherwise send it later.

        :param final: it is the last time, so a browser that is not ready gets everything once it is.
        """
        if not self._channel.watched:
            self._scene.changes()
            self._shown = None
            return
        if not self._channel.ready and not final:
            return
        state = self._state()
        with self._order:
            changes = self._scene.changes()
            if changes or state != self._shown:
                self._sent += 1
                self._channel.send(encode(changes, None if state == self._shown else state), self._sent)
                self._shown = state

    def html(self, picture: str, height: int) -> str:
        """Return the output of the cell: a picture, which becomes the live view where that can be reached.

        :param picture: an SVG.
        :param height: in pixels.
        """
        return _CELL.render(
            name=secrets.token_hex(4),
            port=self._channel.port,
            path=self._channel.path,
            height=height,
            picture=base64.b64encode(picture.encode()).decode(),
        )

    def close(self) -> None:
        """Close the browsers' sockets; idempotent."""
        self._channel.close()

    def _everything(self) -> tuple[bytes, int]:
        state = self._state()
        with self._order:
            return encode(self._scene.everything(), state, reset=True), self._sent


def encode(changes: Changes, state: dict | None = None, reset: bool = False) -> bytes:
    """Return one message: uint32 length of the JSON, the JSON, the binary block; little endian.

    In the JSON an array is ``[offset in the block in bytes, number of values]``; ``faces`` and ids are uint32, all else
    is float32. Matrices are stored column after column, as three.js has them.
    """
    blocks, size = [], 0

    def put(array: np.ndarray, kind: str) -> list[int]:
        nonlocal size
        data = np.ascontiguousarray(array, dtype=kind).tobytes()
        blocks.append(data)
        size += len(data)
        return [size - len(data), array.size]

    def describe(node) -> list:
        path, shape = node.path, node.shape
        if shape is None:
            return [node.id, path, None]
        content = {'type': type(shape).__name__}
        for field in fields(shape):
            value = getattr(shape, field.name)
            if isinstance(value, np.ndarray):
                value = put(value, '<u4' if value.dtype.kind == 'u' else '<f4')
            content[field.name] = value
        return [node.id, path, content]

    message = {}
    if reset:
        message['reset'] = True
    if changes.deleted:
        message['deleted'] = changes.deleted
    if changes.shapes:
        message['shapes'] = [describe(node) for node in changes.shapes]
    if changes.appearances:
        message['appearances'] = [[node.id, node.visible, node.opacity] for node in changes.appearances]
    if changes.poses:
        ids = np.array([node.id for node in changes.poses])
        matrices = np.array([node.pose for node in changes.poses]).transpose(0, 2, 1)
        message['poses'] = [put(ids, '<u4'), put(matrices, '<f4')]
    if state is not None:
        message['state'] = state
    text = json.dumps(message, separators=(',', ':')).encode()
    return b''.join([struct.pack('<I', len(text)), text, *blocks])
