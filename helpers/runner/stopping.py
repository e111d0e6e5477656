"""Ends the tests of a session from another thread than those that wait for them.

Ctrl+C reaches the main thread only. A pool of threads that wait for tests would go on until the last one is through.
"""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager


class Stopped(Exception):
    """The session was stopped: there are no results."""


class Stop:
    """The stop of one session: whoever has it can end what runs, and then nothing begins any more."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._stopped = False
        self._kills: list[Callable[[], None]] = []

    def __enter__(self) -> 'Stop':
        with _changed:
            _sessions.append(self)
        return self

    def __exit__(self, *_) -> None:
        with _changed:
            _sessions.remove(self)
            _changed.notify_all()

    @contextmanager
    def watching(self, kill: Callable[[], None]) -> Iterator[None]:
        """While a process runs that `kill`, which any thread may call, would end.

        :raises Stopped: the session was stopped before, or meanwhile.
        """
        with self._lock:
            self._kills.append(kill)
        try:
            self._refuse()
            yield
        finally:
            with self._lock:
                self._kills.remove(kill)
        self._refuse()

    def now(self) -> None:
        """Stop the session. Its threads end with `Stopped`, as soon as their processes have ended."""
        with self._lock:
            self._stopped = True
            for kill in self._kills:
                kill()

    def _refuse(self) -> None:
        if self._stopped:
            raise Stopped


_sessions: list[Stop] = []
_changed = threading.Condition()


def everything(patience: float) -> None:
    """Stop all sessions of this process. Returns when they have tidied up, or after so many seconds."""
    with _changed:
        for session in _sessions:
            session.now()
        _changed.wait_for(lambda: not _sessions, patience)
