"""Progress on standard error: a live line on a terminal, plain lines elsewhere."""

import shutil
import sys
import time


class Console:
    """Says what the set-up is doing."""

    def __init__(self, stream=None):
        self.stream = stream or sys.stderr
        self.live = self.stream.isatty()
        self._label = ''
        self._started = 0.0
        self._drawn = 0.0

    def line(self, text: str) -> None:
        self._clear()
        print(text, file=self.stream, flush=True)

    def begin(self, label: str) -> None:
        self._label, self._started = label, time.monotonic()
        if self.live:
            self.update('')
        else:
            self.line(f'{label} ...')

    def update(self, detail: str) -> None:
        """Show the latest line of output of the step under way; nothing happens off a terminal."""
        now = time.monotonic()
        if not self.live or (detail and now - self._drawn < 0.1):
            return
        self._drawn = now
        text = f'{self._label} ... {now - self._started:.0f} s  {detail.strip()}'
        width = max(shutil.get_terminal_size().columns - 1, 20)
        print('\r\x1b[K' + text[:width], end='', file=self.stream, flush=True)

    def end(self, result: str = '') -> None:
        took = f'{time.monotonic() - self._started:.1f} s'
        self.line(f'{self._label}: {result}, {took}' if result else f'{self._label}: {took}')

    def _clear(self) -> None:
        if self.live:
            print('\r\x1b[K', end='', file=self.stream, flush=True)
