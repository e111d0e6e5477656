"""Free ROS domain ids, so that programs on one machine do not hear each other.

Fast DDS derives its UDP ports from the domain: 7400 + 250 * id and upwards. Linux gives ports from 32768 on to
any program, so ids above 101 may collide with them; 0 is the default of all programs. That leaves 1 to 101.

A claimed id is a locked file in ``/tmp/ros-domains`` (``COURSE_DOMAINS_DIR`` names another folder). The lock ends with
the process that holds it, however it ends. The folder is writable for every user and sticky, as /tmp itself is.

Some programs use a domain without a claim: one that was set in a terminal, or a child process that has not ended yet.
So `claim` prefers ids in which no process of this machine has a port open, and then those that no copy keeps.

A copy of the course keeps an id of its own (`of_copy`): the file ``N.copy`` beside the locks holds the copy's folder.
"""

import os
import tempfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from filelock import FileLock, Timeout

FIRST, LAST = 1, 101
# DDSI-RTPS 9.6.2.3: where the ports of a domain are.
_PORT_BASE, _PORTS_PER_DOMAIN, _FIRST_UNICAST_PORT = 7400, 250, 10
_held: list[FileLock] = []  # by `hold`


@contextmanager
def claim(highest: bool = False) -> Iterator[int]:
    """Hold a free ROS domain id from 1 to 101 for the duration of the block, and return it: the lowest, or the highest.

    No other block of any process or user holds the same id at that time. An id in which no program communicates is
    preferred. The environment is not changed: set ``ROS_DOMAIN_ID`` or pass the id to ``helpers.ros.start``.

    :raises RuntimeError: all ids are claimed.
    """
    folder, taken = _folder(), _spoken_in()
    kept = {int(path.stem) for path in folder.glob('*.copy') if path.stem.isdecimal()}
    every = range(LAST, FIRST - 1, -1) if highest else range(FIRST, LAST + 1)
    for domain_id in sorted(every, key=lambda one: (one in taken, one in kept)):
        lock = FileLock(folder / f'{domain_id}.lock', mode=0o666, timeout=0, thread_local=False)
        try:
            lock.acquire()
        except (Timeout, PermissionError):  # in use, or made by another user whose files are private
            continue
        try:
            yield domain_id
        finally:
            lock.release()
        return
    raise RuntimeError(f'all ROS domain ids {FIRST} to {LAST} are in use: end programs that lock files in {folder}')


def hold(domain_id: int) -> None:
    """Keep an id from `claim` until this process ends: for a sandbox, which does not see the locks outside of it.

    Nothing happens if a process holds it already.
    """
    lock = FileLock(_folder() / f'{domain_id}.lock', mode=0o666, timeout=0, thread_local=False)
    with suppress(Timeout, PermissionError):
        lock.acquire()
        _held.append(lock)


def of_copy(root: Path, memory: Path) -> int:
    """The id that the copy of the course in `root` keeps: always the same, and no other copy's on this machine.

    :param memory: the file that remembers it; written here.
    """
    try:
        before = int(memory.read_text())
    except (OSError, ValueError):
        before = None
    domain_id = _keep(root.resolve(), before)
    if domain_id != before:
        with suppress(OSError):  # somebody else's course: the same search finds the same id the next time
            memory.write_text(f'{domain_id}\n')
    return domain_id


def _keep(root: Path, before: int | None) -> int:
    folder = _folder()
    # One after another: who looks whether an id is free locks it for a moment, and would seem to use it.
    turn = FileLock(folder / 'copies.lock', mode=0o666, timeout=10, thread_local=False)
    with suppress(Timeout, PermissionError), turn:
        return _search(folder, root, before)
    return _search(folder, root, before)


def _search(folder: Path, root: Path, before: int | None) -> int:
    span = LAST - FIRST + 1
    # Where the search begins follows from the folder's name: so that the id stays, also where /tmp is emptied.
    begin = zlib.crc32(os.fsencode(root)) % span
    order = [FIRST + (begin + step) % span for step in range(span)]
    if before in order:
        order.insert(0, before)
    for domain_id in order:
        if _keeper(folder, domain_id) == str(root):
            return domain_id
    spoken = _spoken_in()
    for domain_id in order:
        free = domain_id == before or domain_id not in spoken and not _locked(folder, domain_id)
        if free and _reserve(folder, domain_id, root):
            return domain_id
    return order[0]  # all are kept by others: then as good as any


def _keeper(folder: Path, domain_id: int) -> str | None:
    """The folder of the copy that keeps an id; None if none does, or if that copy is gone."""
    mark = folder / f'{domain_id}.copy'
    try:
        keeper = mark.read_text(errors='replace')
        if mark.stat().st_uid == os.geteuid() and not Path(keeper).is_dir():
            mark.unlink()
            return None
    except FileNotFoundError:
        return None
    except OSError:
        return ''  # somebody's
    return keeper


def _reserve(folder: Path, domain_id: int, root: Path) -> bool:
    """Keep an id for a copy; False if another one has it. The mark appears with its content, as others may look."""
    if _keeper(folder, domain_id) is not None:
        return False
    with tempfile.NamedTemporaryFile('w', dir=folder, suffix='.new') as file:
        file.write(str(root))
        file.flush()
        os.chmod(file.name, 0o644)
        with suppress(FileExistsError):
            os.link(file.name, folder / f'{domain_id}.copy')
    return _keeper(folder, domain_id) == str(root)


def _locked(folder: Path, domain_id: int) -> bool:
    lock = FileLock(folder / f'{domain_id}.lock', mode=0o666, timeout=0, thread_local=False)
    try:
        lock.acquire()
    except (Timeout, PermissionError):
        return True
    lock.release()
    return False


def participants(domain_id: int) -> int:
    """Count the participants of Fast DDS in a domain on this machine, by the ports at which they listen.

    0 if the system does not list ports. One that is there may be missing in an answer, as the system's list changes
    while it is read: ask again before you rely on it.
    """
    first = _PORT_BASE + _PORTS_PER_DOMAIN * domain_id
    return len(_ports().intersection(range(first + _FIRST_UNICAST_PORT, first + _PORTS_PER_DOMAIN, 2)))


def _spoken_in() -> set[int]:
    """The domains in which a process of this machine has bound a UDP port; empty if the system does not list them."""
    return {(port - _PORT_BASE) // _PORTS_PER_DOMAIN for port in _ports() if port >= _PORT_BASE}


def _ports() -> set[int]:
    """The UDP ports that processes of this machine have bound."""
    ports = set()
    for table in ('/proc/net/udp', '/proc/net/udp6'):
        with suppress(OSError):
            ports |= {int(line.split()[1].rpartition(':')[2], 16) for line in Path(table).read_text().splitlines()[1:]}
    return ports


def _folder() -> Path:
    # /tmp also where TMPDIR names another place: that is often one user's or one job's, and the ids are the machine's.
    public = '/tmp' if os.access('/tmp', os.W_OK) else tempfile.gettempdir()
    folder = Path(os.environ.get('COURSE_DOMAINS_DIR') or Path(public, 'ros-domains'))
    folder.mkdir(parents=True, exist_ok=True)
    with suppress(PermissionError):  # another user's folder already has the mode
        folder.chmod(0o1777)
    return folder
