"""Records what a view shows as a page of its own, which replays it in a browser: no kernel, no server, no network.

If the environment variable `VARIABLE` names a folder, every `TfView` of a notebook writes its recording there when it
stops, and opens no live view. ``./course build --html`` does so. A page holds the messages of `live.encode`,
each with its time; ``web/replay.js`` plays them. What all pages share is written beside them once.

A recording's bytes are, one message after the other: float64 time in s since the first, uint32 length, the message;
little endian. They are packed with zlib and stand as base64 in the page.
"""

import base64
import re
import struct
import time
import zlib
from collections.abc import Callable
from pathlib import Path

from helpers.show.views import view_pages
from helpers.show.views.live_view import encode
from helpers.show.views.scene import Scene

VARIABLE = 'COURSE_SCENES'
RATE = 10.0  # updates a second, at most
LENGTH = 20.0  # s; what comes later is left out
SIZE = 1_000_000  # bytes of a packed recording; the same
SHARED = ('viewer.js', 'viewer.css', 'viewer.js.LICENSE.txt')
_IMPORT = re.compile(r"^import \{([\w, ]+)\} from '\./(\w+\.js)';$", re.MULTILINE)
_EXPORT = re.compile(r'^export ((?:const|class|function) (\w+))', re.MULTILINE)


class Recording:
    """Takes a scene's changes from its making until `write`.

    :param scene: what to record; no other code may take its changes.
    :param state: returns what the page shows beside the scene (see `tf_view`), fit for JSON.
    :param clock: returns s.
    """

    def __init__(self, scene: Scene, state: Callable[[], dict], clock: Callable[[], float] = time.monotonic):
        self._scene, self._state, self._clock = scene, state, clock
        self._shown: dict | None = None
        self._begin = self._last = 0.0
        self._packer, self._packed = zlib.compressobj(9), bytearray()
        self._full = False
        self.count = 0  #: messages so far

    def update(self, final: bool = False) -> None:
        """Record what has changed since the last time, if that is long enough ago, or with `final`, anyhow."""
        now = self._clock()
        if self._full or (self.count and not final and now - self._last < 1 / RATE):
            return
        changes, state = self._scene.changes(), self._state()
        if not self.count:
            if not self._scene.items():
                return  # it begins when there is something to be seen
            self._begin = now
            message = encode(self._scene.everything(), state, reset=True)
        elif changes or state != self._shown:
            message = encode(changes, None if state == self._shown else state)
        else:
            return
        packed = self._packer.copy()
        more = packed.compress(struct.pack('<dI', now - self._begin, len(message)) + message)
        more += packed.flush(zlib.Z_SYNC_FLUSH)
        if now - self._begin > LENGTH or len(self._packed) + len(more) > SIZE:
            self._full = True
            return
        self._packer, self._shown, self._last = packed, state, now
        self._packed += more
        self.count += 1

    def write(self, folder: Path) -> str | None:
        """Write the page, and what all pages share if it is missing; returns its name, None if nothing was seen.

        :raises OSError: the folder cannot be written.
        """
        if not self.count:
            return None
        folder.mkdir(parents=True, exist_ok=True)
        _write_shared(folder)
        text = view_pages.page(base64.b64encode(bytes(self._packed) + self._packer.copy().flush()).decode())
        number = 1
        while True:
            name = f'scene-{number:02}.html'
            try:
                with open(folder / name, 'x', encoding='utf-8') as file:
                    file.write(text)
                return name
            except FileExistsError:
                number += 1


def bundled(entry: str) -> str:
    """Return a module of ``web/`` and all that it imports as one plain script: a file:// page cannot load modules.

    :raises ValueError: an import or export is written in another way than those that are there.
    """
    parts: dict[str, str] = {}

    def add(name: str) -> None:
        if name in parts:
            return
        source = (view_pages.WEB / name).read_text(encoding='utf-8')
        for _, needed in _IMPORT.findall(source):
            add(needed)
        exports = [found for _, found in _EXPORT.findall(source)]
        source = _EXPORT.sub(r'\1', _IMPORT.sub(r"const {\1} = modules['\2'];", source))
        if left := re.search(r'^\s*(import|export)\b.*', source, re.MULTILINE):
            raise ValueError(f'{name}: cannot bundle: {left[0].strip()}')
        parts[name] = f"modules['{name}'] = (() => {{\n{source}\nreturn {{{', '.join(exports)}}};\n}})();\n"

    add(entry)
    return f'(() => {{\nconst modules = {{}};\n{"".join(parts.values())}}})();\n'


def _write_shared(folder: Path) -> None:
    script, style, licences = (folder / name for name in SHARED)
    if script.exists():
        return
    library = view_pages.library()
    licences.write_bytes(library.with_name(f'{library.name}.LICENSE.txt').read_bytes())
    style.write_bytes((view_pages.WEB / 'viewer.css').read_bytes())
    script.write_text(f'{library.read_text(encoding="utf-8")}\n{bundled("replay.js")}', encoding='utf-8')
