"""Removes what killed programs have left in shared memory.

Fast DDS keeps half a megabyte in /dev/shm for each program, and beside it a file that the program has locked. Both go
when the program ends in order; those of a killed one stay until the machine starts anew. Stock's `fastdds shm clean`
does the same as this.
"""

import fcntl
import os
import re
import time
from contextlib import suppress
from pathlib import Path

FOLDER = Path('/dev/shm')
_SEGMENT = re.compile(r'fastrtps_[0-9a-f]{16}')
_LOCK = '_el'
_YOUNG = 60.0  # seconds: a program may have made the file, and not locked it yet


def tidy(folder: Path = FOLDER) -> int:
    """Remove the segments of this user's programs that have ended; returns how many. Never raises."""
    removed = 0
    for lock in sorted(folder.glob(f'fastrtps_*{_LOCK}')):
        segment = folder / lock.name.removesuffix(_LOCK)
        if _SEGMENT.fullmatch(segment.name):
            with suppress(OSError):
                removed += _remove(segment, lock)
    return removed


def _remove(segment: Path, lock: Path) -> bool:
    """Remove both files if nobody holds the lock; returns whether that was so.

    :raises OSError: somebody holds it, or the files have just gone.
    """
    descriptor = os.open(lock, os.O_RDONLY | os.O_NOFOLLOW)
    try:
        facts = os.fstat(descriptor)
        if facts.st_uid != os.geteuid() or time.time() - facts.st_mtime < _YOUNG:
            return False
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        segment.unlink(missing_ok=True)
        lock.unlink()
        return True
    finally:
        os.close(descriptor)
