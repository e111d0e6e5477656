"""Temporary folders of a run, which the next run removes if this one is killed before it can."""

import fcntl
import functools
import os
import re
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

_NAME = re.compile(r'course-(tests-)?[a-z0-9_]{8}')  # as `tempfile` names them; other programs' names are longer
# s: younger ones are let alone: their owner may be about to lock them, or be of a release that does not.
_OLD = 3600.0


@contextmanager
def folder(prefix: str, place: str | None = None) -> Iterator[str]:
    """A new folder in `place`, or in the system's for temporary files, that is removed at the end.

    It is locked as long as this process lives, so that others know that it is in use.

    :param prefix: ``course-`` or ``course-tests-``
    """
    _remove_abandoned_once(place or tempfile.gettempdir())
    with tempfile.TemporaryDirectory(prefix=prefix, dir=place, ignore_cleanup_errors=True) as path:
        lock = os.open(path, os.O_RDONLY | os.O_DIRECTORY)
        try:
            with suppress(OSError):  # a file system without locks
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            yield path
        finally:
            os.close(lock)


@functools.cache
def _remove_abandoned_once(place: str) -> None:
    remove_abandoned(place)


def remove_abandoned(place: str) -> None:
    """Remove this user's folders in `place` that nobody has locked, and that nobody has written to for an hour."""
    for path in Path(place).glob('course-*'):
        with suppress(OSError):  # another one removes it just now, or it is not ours
            about = path.lstat()
            if not _NAME.fullmatch(path.name) or not path.is_dir() or path.is_symlink() or about.st_uid != os.geteuid():
                continue
            if time.time() - about.st_mtime > _OLD and not _is_locked(path):
                shutil.rmtree(path, ignore_errors=True)


def _is_locked(path: Path) -> bool:
    lock = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    finally:
        os.close(lock)
    return False
