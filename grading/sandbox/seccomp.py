"""The filter of system calls under which a learner's program runs, as a program for the kernel's classic BPF machine.

What programs, compilers and DDS never need is refused with EPERM: namespaces, mounts, tracing, keys, kernel modules,
clocks, sockets of kinds that are not bound to the network namespace, and memory of the kernel's that nobody counts
(`kernel_memory` says what is left of it). The list is by numbers of x86-64, the only processor for which the course has
a ROS; on another one `install` raises.
"""

import ctypes
import errno
import platform
import struct
from collections.abc import Iterable

from grading.sandbox import namespaces

# Numbers from the kernel's arch/x86/entry/syscalls/syscall_64.tbl.
DENIED = {
    'ptrace': 101,
    'process_vm_readv': 310,
    'process_vm_writev': 311,
    'kcmp': 312,
    'pidfd_getfd': 438,
    'process_madvise': 440,
    'perf_event_open': 298,
    'bpf': 321,
    'userfaultfd': 323,
    'mount': 165,
    'umount2': 166,
    'pivot_root': 155,
    'chroot': 161,
    'swapon': 167,
    'swapoff': 168,
    'open_tree': 428,
    'move_mount': 429,
    'fsopen': 430,
    'fsconfig': 431,
    'fsmount': 432,
    'fspick': 433,
    'mount_setattr': 442,
    'unshare': 272,
    'setns': 308,
    'name_to_handle_at': 303,
    'open_by_handle_at': 304,
    'quotactl': 179,
    'quotactl_fd': 443,
    'fanotify_init': 300,
    'lookup_dcookie': 212,
    # Memory that no process shows as its own: without these, what a sandbox holds can be counted.
    'memfd_create': 319,
    'memfd_secret': 447,
    'shmget': 29,
    'semget': 64,
    'msgget': 68,
    'vmsplice': 278,  # pages that stay in a pipe when they are not mapped any more
    # Objects of the kernel's that are counted for a user, thus for all submissions together, or not at all.
    'inotify_init': 253,
    'inotify_init1': 294,
    'io_setup': 206,
    'landlock_create_ruleset': 444,
    'landlock_add_rule': 445,
    'landlock_restrict_self': 446,
    'seccomp': 317,
    'keyctl': 250,
    'add_key': 248,
    'request_key': 249,
    'io_uring_setup': 425,
    'io_uring_enter': 426,
    'io_uring_register': 427,
    'kexec_load': 246,
    'kexec_file_load': 320,
    'init_module': 175,
    'finit_module': 313,
    'delete_module': 176,
    'create_module': 174,
    'reboot': 169,
    'acct': 163,
    'syslog': 103,
    'vhangup': 153,
    'sethostname': 170,
    'setdomainname': 171,
    'iopl': 172,
    'ioperm': 173,
    'modify_ldt': 154,
    'settimeofday': 164,
    'clock_settime': 227,
    'adjtimex': 159,
    'clock_adjtime': 305,
    'nfsservctl': 180,
    'uselib': 134,
    '_sysctl': 156,
    'ustat': 136,
    'sysfs': 139,
}
_CLONE, _CLONE3, _SOCKET, _IOCTL, _MMAP, _PRLIMIT = 56, 435, 41, 16, 9, 302
_FCNTL, _PRCTL, _SETSOCKOPT = 72, 157, 54
_PIPE_SIZE, _LOCKS = 1031, (37, 38)  # F_SETPIPE_SZ; F_OFD_SETLK and F_OFD_SETLKW, which /proc/locks shows to everybody
# F_SETLEASE, F_NOTIFY, F_SETDELEG: who asks is told what others do with a file or in a folder, as inotify would.
_TOLD_OF_OTHERS = (1024, 1026, 1040)
_SOL_SOCKET, _BUFFERS = 1, (7, 8)  # SO_SNDBUF, SO_RCVBUF
_PROGRAMS = (26, 50, 51, 52)  # SO_ATTACH_FILTER, _BPF, _REUSEPORT_CBPF, _REUSEPORT_EBPF
_SHARED, _ANONYMOUS = 1, 0x20
_NEW_NAMESPACES = namespaces.ALL | 0x00000080  # NEWTIME
_TERMINAL_INPUT = (0x5412, 0x541C)  # TIOCSTI, TIOCLINUX
_FAMILIES = (1, 2, 10)  # unix, IPv4, IPv6
_NETLINK = 16  # of which only routing, which getifaddrs asks

_X86_64 = 0xC000003E
_LOAD, _EQUAL, _ABOVE, _ANY_BIT, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
_ALLOW, _KILL = 0x7FFF0000, 0x80000000
_NUMBER, _ARCH = 0, 4
_PR_SET_SECCOMP, _MODE_FILTER = 22, 2


def _refuse(error: int) -> tuple[int, int, int, int]:
    return _RETURN, 0, 0, 0x00050000 | error


def _argument(index: int) -> tuple[int, int, int, int]:
    return _LOAD, 0, 0, 16 + 8 * index  # its lower half


def program() -> bytes:
    """The filter, as an array of `struct sock_filter`."""
    no = _refuse(errno.EPERM)
    lines = [
        (_LOAD, 0, 0, _ARCH),
        (_EQUAL, 1, 0, _X86_64),
        (_RETURN, 0, 0, _KILL),
        (_LOAD, 0, 0, _NUMBER),
        (_ABOVE, 0, 1, 0x40000000),
        no,
    ]  # the numbers of x32
    for number in sorted(DENIED.values()):
        lines += [(_EQUAL, 0, 1, number), no]
    # Flags of clone3 lie in memory, where no filter reads them: the C library falls back to clone.
    lines += [(_EQUAL, 0, 1, _CLONE3), _refuse(errno.ENOSYS)]
    lines += _guarded(_CLONE, [_argument(0), (_ANY_BIT, 0, 1, _NEW_NAMESPACES), no])
    lines += _guarded(_IOCTL, [_argument(1), *_unless(_TERMINAL_INPUT, no)])
    lines += _guarded(_FCNTL, [_argument(1), *_unless((_PIPE_SIZE, *_LOCKS, *_TOLD_OF_OTHERS), no)])
    lines += _guarded(_PRCTL, [_argument(0), *_unless((_PR_SET_SECCOMP,), no)])
    # A socket keeps the buffers that the kernel gives to all, whatever the machine would allow besides: success is
    # told, as the kernel tells it when it takes less than is asked for.
    lines += _guarded(
        _SETSOCKOPT,
        [
            _argument(1),
            (_EQUAL, 1, 0, _SOL_SOCKET),
            (_RETURN, 0, 0, _ALLOW),
            _argument(2),
            *_unless(_BUFFERS, _refuse(0)),
            *_unless(_PROGRAMS, no),
        ],
    )
    # Of the calling process only: process 1 is of the same user, and others set its limits.
    lines += _guarded(_PRLIMIT, [_argument(0), (_EQUAL, 1, 0, 0), no])
    # Shared memory without a file stays when it is not mapped any more; /dev/shm has files for it, with a bound.
    lines += _guarded(
        _MMAP,
        [
            _argument(3),
            (_ANY_BIT, 1, 0, _SHARED),
            (_RETURN, 0, 0, _ALLOW),
            (_ANY_BIT, 0, 1, _ANONYMOUS),
            _refuse(errno.ENOMEM),
        ],
    )
    socket = [_argument(0)]
    for family in _FAMILIES:
        socket += [(_EQUAL, 0, 1, family), (_RETURN, 0, 0, _ALLOW)]
    socket += [(_EQUAL, 1, 0, _NETLINK), no, _argument(2), (_EQUAL, 1, 0, 0), no]
    lines += _guarded(_SOCKET, socket)
    lines.append((_RETURN, 0, 0, _ALLOW))
    return b''.join(struct.pack('=HBBI', *line) for line in lines)


def _guarded(number: int, lines: list) -> list:
    """`lines`, for one system call only; what they let through is allowed."""
    return [(_EQUAL, 0, len(lines) + 1, number), *lines, (_RETURN, 0, 0, _ALLOW)]


def _unless(values: Iterable[int], answer: tuple) -> list:
    """Lines that give this answer if what was loaded is one of the values."""
    return [line for value in values for line in ((_EQUAL, 0, 1, value), answer)]


class _Program(ctypes.Structure):
    _fields_ = [('length', ctypes.c_ushort), ('filter', ctypes.c_char_p)]


def install() -> None:
    """Put this process and all that it will start under the filter. Needs no_new_privs. Raises OSError."""
    if platform.machine() != 'x86_64':
        raise OSError(errno.ENOSYS, f'no list of system calls for {platform.machine()}')
    filter_ = program()
    namespaces.call(
        'prctl', _PR_SET_SECCOMP, ctypes.c_ulong(_MODE_FILTER), ctypes.byref(_Program(len(filter_) // 8, filter_)), 0, 0
    )
