"""Control groups of Linux (version 2): the kernel's own bounds on memory and processes, where the grader may set them.

The grader may where a group is its own: as root, or in a scope that is delegated to it and holds nothing else:

    systemd-run --user --scope -p Delegate=yes ./course grade …

Then the servers move into a group of theirs, and each sandbox gets one beside it. Elsewhere, and if anything fails,
there are no groups. What the sandboxes use is counted in any case, see `learners_side`: a group only adds a bound.

    GROUP/                 ours; memory and pids are enabled below it
        servers            the servers, and all that they fork
        1234-1, 1234-2 …   the processes of a sandbox
"""

import itertools
import os
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path

import psutil

from helpers.runner.start_processes import Limits

ROOT = Path('/sys/fs/cgroup')
SERVERS = 'servers'
CONTROLLERS = 'memory', 'pids'
OWN = 8  # processes of ours in a sandbox's group, beside the program's
_numbers = itertools.count(1)


def own(root: Path = ROOT, process: str = 'self') -> Path | None:
    """The group of a process; None where there are no control groups of version 2."""
    with suppress(OSError):
        for line in Path(f'/proc/{process}/cgroup').read_text().splitlines():
            if line.startswith('0::/'):
                found = root / line[4:]
                return found if (found / 'cgroup.procs').is_file() else None
    return None


def settle(group: Path, ours: Iterable[int], user: int | None = None) -> bool:
    """Make `group` one for sandboxes; the calling process and what the group holds move into one for servers below it.

    :param ours: processes that are the grader's own. If the group holds others, it is left alone.
    :param user: who may make groups there afterwards; else the caller.
    :return: whether it can be had.
    """
    with suppress(OSError, ValueError):
        offered = (group / 'cgroup.controllers').read_text().split()
        inside = [int(pid) for pid in (group / 'cgroup.procs').read_text().split()]
        if not set(CONTROLLERS) <= set(offered) or not set(inside) <= {*ours, os.getpid()}:
            return False
        servers = group / SERVERS
        servers.mkdir(exist_ok=True)
        for pid in {*inside, os.getpid()}:  # a group with members has no bounds for what is below it
            (servers / 'cgroup.procs').write_text(str(pid))
        (group / 'cgroup.subtree_control').write_text(' '.join(f'+{name}' for name in CONTROLLERS))
        if user is not None:
            for path in (group, group / 'cgroup.procs', servers, servers / 'cgroup.procs'):
                os.chown(path, user, -1)
        return True
    return False


def release(group: Path, back: Path) -> None:
    """Undo `settle`: what the group for servers holds goes back to where it was."""
    with suppress(OSError):
        (group / 'cgroup.subtree_control').write_text(' '.join(f'-{name}' for name in CONTROLLERS))
    with suppress(OSError):
        for pid in (group / SERVERS / 'cgroup.procs').read_text().split():
            (back / 'cgroup.procs').write_text(pid)
    for path in (group / SERVERS, group):
        if path != back:
            with suppress(OSError):
                path.rmdir()


def begin(user: int | None = None) -> Callable[[], None]:
    """Settle in a group, if one can be had; returns what undoes it.

    :param user: the ordinary user in whose place root asks; else the caller is one, and its own group is taken.
    """
    before = own()
    if before is None or before.name == SERVERS:
        return lambda: None
    if user is None:
        group, ours = before, [process.pid for process in (psutil.Process(), *psutil.Process().parents())]
    else:
        group, ours = ROOT / f'course-{os.getpid()}', []
        try:
            group.mkdir()
        except OSError:
            return lambda: None
    if not settle(group, ours, user) and user is None:
        return lambda: None
    return lambda: release(group, before)


def settled(group: Path | None) -> Path | None:
    """The group that `settle` has made, for a server whose own group is this one; None if there is none."""
    if group is None or group.name != SERVERS or not os.access(group.parent, os.W_OK):
        return None
    return group.parent


class Bounds:
    """The group of one sandbox; without a place for it, nothing happens."""

    def __init__(self, place: Path | None, limits: Limits):
        """:param place: what `settled` gives."""
        self.path: Path | None = None
        self._ended = 0
        if place is None:
            return
        path = place / f'{os.getpid()}-{next(_numbers)}'
        try:
            path.mkdir()
            self.path = path
            self.set(limits)
        except OSError:
            self.close()

    def set(self, limits: Limits) -> None:
        """Bound the sandbox. Its folders are in memory, and count as such here."""
        if self.path is None:
            return
        memory = limits.total_memory + limits.tmp + limits.home + limits.shared
        for name, value in (('memory.max', memory), ('pids.max', limits.processes + OWN)):
            (self.path / name).write_text(str(value))
        for name, value in (('memory.swap.max', 0), ('memory.oom.group', 1)):
            with suppress(OSError):  # a kernel without swap, or an old one
                (self.path / name).write_text(str(value))

    def join(self) -> None:
        """Move the calling process into the group; what it forks is there, too."""
        if self.path is not None:
            with suppress(OSError):
                (self.path / 'cgroup.procs').write_text(str(os.getpid()))

    def exceeded(self) -> bool:
        """Whether the kernel has ended processes because they used too much memory, since this was asked last."""
        if self.path is None:
            return False
        before = self._ended
        with suppress(OSError, ValueError):
            events = dict(line.split() for line in (self.path / 'memory.events').read_text().splitlines())
            self._ended = int(events.get('oom_kill', 0))
        return self._ended > before

    def close(self) -> None:
        """Remove the group, whose processes have ended. Idempotent."""
        if self.path is not None:
            with suppress(OSError):
                self.path.rmdir()
            self.path = None
