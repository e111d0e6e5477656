"""Memory that the kernel holds for the processes of a sandbox, and that no process shows as its own.

Each object is small, and the kernel bounds their number for a process, for a user or not at all: the maps of a
process's memory, what it watches with epoll, its locks on parts of files, what stands in its pipes. Control groups
count most of it; where there are none, it is counted here. Other kinds are refused (`seccomp`) or bounded (`Limits`,
`learners_side`).
"""

import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

MAP, WATCH, PIPE = 512, 192, 64 * 2**10  # bytes, rounded up
MAX_WATCHES = 100_000  # of epoll: the kernel bounds their number for a user, and so for all submissions together
MAX_LOCKS = 20_000  # more of them are too many in any case: to list them all would take the kernel longer and longer
_CHUNK = 2**18  # bytes of a file of /proc


def held(processes: Path, most: int) -> int:
    """The bytes that the kernel holds for the processes below a /proc but its first; it stops counting at `most`.

    :param processes: the /proc of a process namespace.
    """
    pipes: set[str] = set()
    total = locks = watches = 0
    for part in _lines(processes / 'locks', b' POSIX '):
        locks += part
        if locks > MAX_LOCKS:
            return most
    for size, count in _parts(processes, pipes):
        total += size * count
        watches += count if size == WATCH else 0
        if watches > MAX_WATCHES:
            return most
        if total + PIPE * len(pipes) >= most:
            break
    return total + PIPE * len(pipes)


def _parts(processes: Path, pipes: set[str]) -> Iterator[tuple[int, int]]:
    """Sizes of objects, and how many of these there are; pipes are put into `pipes`."""
    for name in os.listdir(processes):
        if name.isdecimal() and name != '1':
            for part in _lines(processes / name / 'maps', b'\n'):
                yield MAP, part
            for link, number in _open_files(processes / name):
                if link.startswith('pipe:'):
                    pipes.add(link)
                elif link == 'anon_inode:[eventpoll]':
                    for part in _lines(processes / name / 'fdinfo' / number, b'tfd:'):
                        yield WATCH, part


def _open_files(process: Path) -> Iterator[tuple[str, str]]:
    """What the descriptors of a process stand for, and their numbers."""
    with suppress(OSError):
        for number in os.listdir(process / 'fd'):
            with suppress(OSError):
                yield os.readlink(process / 'fd' / number), number


def _lines(path: Path, mark: bytes) -> Iterator[int]:
    """How often a mark is in each chunk of a file; one that lies across two chunks is missed."""
    with suppress(OSError), open(path, 'rb', buffering=0) as file:
        while chunk := file.read(_CHUNK):
            yield chunk.count(mark)
