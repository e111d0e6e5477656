"""Single keys from a terminal, without waiting."""

import os
import select
import sys
from contextlib import contextmanager

_ARROWS = {b'\x1b[A': 'up', b'\x1b[B': 'down', b'\x1b[C': 'right', b'\x1b[D': 'left'}


@contextmanager
def keys(enabled: bool = True):
    """Give a function that returns the next key pressed (`' '`, `'up'` …) or None; without a terminal always None."""
    if not enabled or not sys.stdin.isatty():
        yield lambda: None
        return
    import termios
    import tty

    descriptor = sys.stdin.fileno()
    before = termios.tcgetattr(descriptor)
    try:
        tty.setcbreak(descriptor)
        yield lambda: _pressed(descriptor)
    finally:
        termios.tcsetattr(descriptor, termios.TCSADRAIN, before)


def _pressed(descriptor: int) -> str | None:
    if not _ready(descriptor):
        return None
    data = os.read(descriptor, 1)
    if data == b'\x1b' and _ready(descriptor):
        data += os.read(descriptor, 2)
    return _ARROWS.get(data) or data[:1].decode(errors='replace')


def _ready(descriptor: int) -> bool:
    return bool(select.select([descriptor], [], [], 0)[0])
