"""What the sandboxes see of the machine: the arguments of bubblewrap.

A submission has two of them. The outer one is the tests': it has a network of its own, in which nothing is but
loopback. The inner one is the learner's: it shares that network and nothing else. Both see the system, `.venv`,
`environment/` and `helpers/`, all read-only. Only the tests' one sees tests.
"""

import os
import shutil
import sys
from collections.abc import Iterable
from pathlib import Path

from helpers.paths import ROOT
from helpers.runner.start_processes import Limits

HOME = Path('/home/learner')
UID = 1000  # inside; outside it is whoever grades, or an unprivileged user in place of root
# Keeps a sandbox alive until its standard input closes. It is the first process, and parent of what others leave
# behind: as it ignores the end of children, none of them stays as a zombie, which would count as a process of the
# learner's.
KEEPER = '/keep'  # see keeper()
HOLDER = ('/usr/bin/env', '--ignore-signal=CHLD', KEEPER)

# Of /etc: shared libraries, the compiler's links, fonts and time zone. Nothing that tells about the machine's users.
_ETC = (
    'ld.so.cache',
    'ld.so.conf',
    'ld.so.conf.d',
    'alternatives',
    'fonts',
    'glvnd',
    'localtime',
    'nsswitch.conf',
    'locale.alias',
)
_HELD_BACK = ROOT / 'helpers' / 'checks'  # the visible tests


def bwrap() -> str | None:
    """The bubblewrap program; None if there is none."""
    return shutil.which('bwrap')


def keeper(program: int) -> list[str]:
    """The program of process 1: a copy of what the descriptor `program` reads, in the memory of the sandbox.

    Nobody can read it, so the kernel lets nobody write into the process that runs it.
    """
    return ['--perms', '0111', '--ro-bind-data', str(program), KEEPER]


def readable() -> list[Path]:
    """The trees outside of the system's own that both sandboxes need."""
    found = [Path(sys.prefix), Path(sys.base_prefix), *map(Path, os.environ.get('AMENT_PREFIX_PATH', '').split(':'))]
    found += [ROOT / 'helpers', ROOT / 'environment']
    trees = [path for path in dict.fromkeys(map(_plain, found)) if path.is_dir() and path != Path('/')]
    return [path for path in trees if path.parts[1:2] != ('usr',)]


def _plain(path: Path) -> Path:
    return Path(os.path.abspath(path)) if str(path) else Path('/')


def _system() -> list[str]:
    arguments = ['--ro-bind', '/usr', '/usr']
    for name in ('bin', 'sbin', 'lib', 'lib32', 'lib64', 'libx32'):
        path = Path('/', name)
        if path.is_symlink():
            arguments += ['--symlink', os.readlink(path).lstrip('/'), str(path)]
        elif path.is_dir():
            arguments += ['--ro-bind', str(path), str(path)]
    for name in _ETC:
        arguments += ['--ro-bind-try', f'/etc/{name}', f'/etc/{name}']
    return arguments


def _own(*, tmp: int, shared: int) -> list[str]:
    return [
        '--proc',
        '/proc',
        '--dev',
        '/dev',
        '--size',
        str(shared),
        '--tmpfs',
        '/dev/shm',
        '--size',
        str(tmp),
        '--tmpfs',
        '/tmp',
    ]


def _apart() -> list[str]:
    """What both have: namespaces of their own, no way back, no environment, an end together with their starter."""
    return [
        bwrap() or 'bwrap',
        '--unshare-user',
        '--unshare-pid',
        '--unshare-ipc',
        '--unshare-uts',
        '--unshare-cgroup-try',
        '--uid',
        str(UID),
        '--gid',
        str(UID),
        '--hostname',
        'sandbox',
        '--die-with-parent',
        '--new-session',
        '--as-pid-1',
        '--clearenv',
    ]


def _bind(trees: Iterable[Path]) -> list[str]:
    return [word for tree in sorted(trees) for word in ('--ro-bind', str(tree), str(tree))]


def tests(folders: Iterable[Path]) -> list[str]:
    """The tests' sandbox; `folders` hold the tests."""
    return [
        *_apart(),
        '--unshare-net',
        *_system(),
        *_own(tmp=64 * 2**20, shared=8 * 2**20),
        *_bind(readable()),
        *_bind(folders),
        '--remount-ro',
        '/dev',
        '--remount-ro',
        '/',
        '--chdir',
        '/tmp',
        '--',
        *HOLDER,
    ]


def programs(limits: Limits) -> list[str]:
    """The learner's sandbox, to be started inside of the tests' network."""
    return [
        *_apart(),
        *_system(),
        *_own(tmp=limits.tmp, shared=limits.shared),
        *_bind(readable()),
        '--tmpfs',
        str(_HELD_BACK),
        '--remount-ro',
        str(_HELD_BACK),
        '--size',
        str(limits.home),
        '--tmpfs',
        str(HOME),
        '--remount-ro',
        '/dev',
        '--remount-ro',
        '/',
        '--chdir',
        str(HOME),
        '--',
        *HOLDER,
    ]
