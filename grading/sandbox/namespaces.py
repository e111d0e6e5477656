"""System calls of Linux that Python 3.10 lacks: enter namespaces, give up capabilities, change a mount.

The numbers are those of the kernel's headers (linux/sched.h, linux/prctl.h, linux/capability.h, linux/mount.h).
"""

import contextlib
import ctypes
import os
import signal
from pathlib import Path

NEWNS, NEWCGROUP, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET = (
    0x00020000,
    0x02000000,
    0x04000000,
    0x08000000,
    0x10000000,
    0x20000000,
    0x40000000,
)
ALL = NEWNS | NEWCGROUP | NEWUTS | NEWIPC | NEWUSER | NEWPID | NEWNET

MS_NOSUID, MS_NODEV, MS_REMOUNT, MS_BIND, MS_REC, MS_PRIVATE = 2, 4, 32, 4096, 16384, 1 << 18

_PR_SET_DUMPABLE, _PR_CAPBSET_DROP, _PR_SET_NO_NEW_PRIVS, _PR_CAP_AMBIENT, _PR_CAP_AMBIENT_CLEAR_ALL = 4, 24, 38, 47, 4
_CAPABILITY_VERSION_3 = 0x20080522
_NS_GET_USERNS = 0xB701
_LAST_CAP = Path('/proc/sys/kernel/cap_last_cap')

_libc = ctypes.CDLL(None, use_errno=True)


def call(name: str, *arguments) -> int:
    """Call a function of the C library. Raises OSError if it gives -1."""
    result = getattr(_libc, name)(*arguments)
    if result == -1:
        number = ctypes.get_errno()
        raise OSError(number, f'{name}: {os.strerror(number)}')
    return result


def unshare(kinds: int) -> None:
    """Leave the namespaces of these kinds for new ones."""
    call('unshare', ctypes.c_int(kinds))


def join(descriptor: int, kinds: int) -> None:
    """Enter the namespaces of the process that a pidfd means (Linux 5.8), or the one namespace that is open there."""
    call('setns', ctypes.c_int(descriptor), ctypes.c_int(kinds))


def owner(descriptor: int) -> int:
    """Open the user namespace that owns an open namespace."""
    return call('ioctl', ctypes.c_int(descriptor), ctypes.c_ulong(_NS_GET_USERNS))


def mount(source: str | None, target: str, kind: str | None, flags: int, data: str | None = None) -> None:
    """mount(2)."""
    encoded = [text.encode() if text is not None else None for text in (source, target, kind)]
    call('mount', *encoded, ctypes.c_ulong(flags), data.encode() if data else None)


def give_up_privileges() -> None:
    """Drop every capability for good: the effective ones, those that an exec could bring back, and setuid programs."""
    for capability in range(int(_LAST_CAP.read_text()) + 1):
        call('prctl', _PR_CAPBSET_DROP, ctypes.c_ulong(capability), 0, 0, 0)
    call('prctl', _PR_CAP_AMBIENT, ctypes.c_ulong(_PR_CAP_AMBIENT_CLEAR_ALL), 0, 0, 0)
    call('prctl', _PR_SET_NO_NEW_PRIVS, ctypes.c_ulong(1), 0, 0, 0)
    header = (ctypes.c_uint32 * 2)(_CAPABILITY_VERSION_3, 0)
    call('capset', header, (ctypes.c_uint32 * 6)())
    # A process that changed its credentials cannot look at its own /proc/self otherwise.
    call('prctl', _PR_SET_DUMPABLE, ctypes.c_ulong(1), 0, 0, 0)


def mirror(pid: int) -> None:
    """Wait for a child and end as it does. Never returns.

    SIGTERM kills the whole process group of the child; SIGINT is passed on to it.
    """

    def kill(*_) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(pid, signal.SIGKILL)
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)

    def interrupt(*_) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGINT)

    signal.signal(signal.SIGTERM, kill)
    signal.signal(signal.SIGINT, interrupt)
    _, status = os.waitpid(pid, 0)
    kill_group = contextlib.suppress(ProcessLookupError)
    with kill_group:
        os.killpg(pid, signal.SIGKILL)  # what it has left behind in its group
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        if number not in (signal.SIGKILL, signal.SIGSTOP):
            signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)
        os._exit(128 + number)
    os._exit(os.WEXITSTATUS(status))
