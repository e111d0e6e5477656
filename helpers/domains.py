"""Free ROS domain ids, so that programs on one machine do not hear each other.

Fast DDS derives its UDP ports from the domain: 7400 + 250 * id and upwards. Linux hands out ports from 32768 on to
anybody, so ids above 101 may collide with them; 0 is everybody's default. That leaves 1 to 101.

A claimed id is a locked file in ``/tmp/ros-domains`` (``COURSE_DOMAINS_DIR`` names another folder). The lock ends with
the process that holds it, however it ends. The folder is writable for every user and sticky, as /tmp itself is.

Programs that claim nothing speak in a domain, too: one that a terminal was given, or a child that has not ended yet. So
the ids in which somebody of this machine has a port open come last.
"""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from filelock import FileLock, Timeout

FIRST, LAST = 1, 101
# DDSI-RTPS 9.6.2.3: where the ports of a domain are.
_PORT_BASE, _PORTS_PER_DOMAIN = 7400, 250
_held: list[FileLock] = []  # by `hold`


@contextmanager
def claim() -> Iterator[int]:
    """Hold a free ROS domain id from 1 to 101 for the duration of the block, and return it.

    It is nobody else's who asks here, in any process of any user, and nobody speaks in it as long as there is such a
    one. The environment is not changed:
    set ``ROS_DOMAIN_ID`` or pass the id to ``helpers.ros.start``.

    :raises RuntimeError: all ids are claimed.
    """
    folder, taken = _folder(), _spoken_in()
    for domain_id in sorted(range(FIRST, LAST + 1), key=taken.__contains__):
        lock = FileLock(folder / f'{domain_id}.lock', mode=0o666, timeout=0, thread_local=False)
        try:
            lock.acquire()
        except (Timeout, PermissionError):  # in use, or made by somebody whose files are private
            continue
        try:
            yield domain_id
        finally:
            lock.release()
        return
    raise RuntimeError(f'all ROS domain ids {FIRST} to {LAST} are in use: end programs that lock files in {folder}')


def hold(domain_id: int) -> None:
    """Keep an id from `claim` until this process ends: for a sandbox, which does not see the locks outside of it.

    Nothing happens if somebody holds it already.
    """
    lock = FileLock(_folder() / f'{domain_id}.lock', mode=0o666, timeout=0, thread_local=False)
    with suppress(Timeout, PermissionError):
        lock.acquire()
        _held.append(lock)


def _spoken_in() -> set[int]:
    """The domains of which some process of this machine has bound a UDP port; empty if the system does not tell."""
    ports = set()
    for table in ('/proc/net/udp', '/proc/net/udp6'):
        with suppress(OSError):
            ports |= {int(line.split()[1].rpartition(':')[2], 16) for line in Path(table).read_text().splitlines()[1:]}
    return {(port - _PORT_BASE) // _PORTS_PER_DOMAIN for port in ports if port >= _PORT_BASE}


def _folder() -> Path:
    folder = Path(os.environ.get('COURSE_DOMAINS_DIR') or Path(tempfile.gettempdir()) / 'ros-domains')
    folder.mkdir(parents=True, exist_ok=True)
    with suppress(PermissionError):  # another user's folder already has the mode
        folder.chmod(0o1777)
    return folder
