"""The programs of one submission, in the learner's sandbox.

The fork server itself stays outside, where no program sees it. Each program's process enters the sandbox, gives up
every privilege, gets its limits and the filter of system calls, and only then reads its first line of the learner's
code.
"""

import os
import signal
import socket
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from grading.sandbox import layout, namespaces, seccomp
from grading.sandbox.holder import Holder
from helpers.runner import zygote
from helpers.runner.launch import Limits
from helpers.runner.lifetime import die_with_parent

INODES = 20_000  # files and folders in each place that can be written
_PAGE = os.sysconf('SC_PAGESIZE')


def warm_up() -> None:
    """Nothing more than what every fork server imports."""


def run(request: dict, control: int, printed: int) -> None:
    """Serve one submission's tests. The first message brings the limits, and the tests' process as a pidfd."""
    os.dup2(printed, 1)
    os.dup2(printed, 2)
    os.close(printed)
    os.environ['ROS_DOMAIN_ID'] = str(request['domain'])
    tests = socket.socket(fileno=control)
    data, descriptors, _, _ = socket.recv_fds(tests, 65536, 1)
    if not data:
        return
    programs = Sandboxed(descriptors[0])
    tests.send(b'{"event": "ready"}')
    zygote.serve(tests, programs)


class Sandboxed(zygote.Programs):
    """Programs in a sandbox, which is made for the first one and stays for the submission's other ones."""

    patience = 0.1

    def __init__(self, tests: int):
        """`tests`: a pidfd of the process of tests, whose network the programs share."""
        self._tests = tests
        self._holder: Holder | None = None
        self._places: tuple | None = None  # the sizes of the places that can be written
        self._limits = Limits()

    def fork(self, limits: Limits, channel: int, output: int) -> int:
        if self._holder is None or self._holder.process.poll() is not None:
            self.close()
            self._holder = Holder(layout.programs(limits), self._tests)
        self._limits = limits
        places = (limits.tmp, limits.home, limits.shared)
        if places != self._places:
            self._inside(lambda: _resize(limits), namespaces.NEWNS)
            self._places = places
        pid = os.fork()
        if pid == 0:
            zygote.leave_server()
            self._enter(limits, channel, output)
        return pid

    def _enter(self, limits: Limits, channel: int, output: int) -> None:
        """In a forked child: start the program's process inside and end as it does. Never returns."""
        try:
            die_with_parent()
            namespaces.join(self._holder.pidfd, namespaces.ALL)
            namespaces.close_all_but([channel, output])
            pid = os.fork()
            if pid:
                namespaces.give_up_privileges()
                die_with_parent()  # a change of privileges has undone it
                os.close(channel)
                os.close(output)
                namespaces.mirror(pid)
            namespaces.give_up_privileges()
            die_with_parent()
            os.chdir(layout.HOME)
            with open('/dev/null') as null:
                os.dup2(null.fileno(), 0)
            os.dup2(output, 1)
            os.dup2(output, 2)
            limits.apply(sandboxed=True)
            seccomp.install()
            zygote.become_program(channel, output)
        except BaseException:  # noqa: BLE001 - the child must not return into the server's loop
            import traceback
            traceback.print_exc()
        finally:
            os._exit(1)

    def kill(self, pid: int) -> None:
        with suppress(ProcessLookupError):
            os.kill(pid, signal.SIGTERM)  # it kills the program's group, see namespaces.mirror

    def ended(self, pid: int) -> None:
        """Its group has been killed already."""

    def clear(self) -> None:
        if self._holder is not None:
            self._inside(_kill_all, namespaces.ALL)

    def look(self) -> str:
        most = self._limits.total_memory
        # What forked processes still share counts once, but that takes longer to find out.
        if self._holder is None or _memory(self._holder.pid, _own) < most or _memory(self._holder.pid, _share) < most:
            return ''
        self._inside(_kill_all, namespaces.ALL)
        return 'memory'

    def close(self) -> None:
        if self._holder is not None:
            self._holder.close()
            self._holder = self._places = None

    def _inside(self, act, kinds: int) -> None:
        """Have a child enter these namespaces, with all privileges there, and act."""
        pid = os.fork()
        if pid == 0:
            code = 1
            try:
                zygote.leave_server()
                if kinds == namespaces.ALL:
                    namespaces.join(self._holder.pidfd, kinds)
                else:
                    opened = os.open(f'/proc/{self._holder.pid}/ns/mnt', os.O_RDONLY)
                    namespaces.join(namespaces.owner(opened), namespaces.NEWUSER)
                    namespaces.join(opened, kinds)
                act()
                code = 0
            except BaseException:  # noqa: BLE001 - the child must not return into the server's loop
                import traceback
                traceback.print_exc()
            finally:
                os._exit(code)
        _, status = os.waitpid(pid, 0)
        if status:
            raise RuntimeError('the sandbox cannot be looked after')


def _resize(limits: Limits) -> None:
    for place, size in (('/tmp', limits.tmp), (str(layout.HOME), limits.home), ('/dev/shm', limits.shared)):
        namespaces.mount('tmpfs', place, None, namespaces.MS_REMOUNT | namespaces.MS_NOSUID | namespaces.MS_NODEV,
                         f'size={size},nr_inodes={INODES}')


def _kill_all() -> None:
    """Kill every process of the sandbox but its first, from a process inside: no fork is quicker than that."""
    pid = os.fork()
    if pid == 0:
        with suppress(ProcessLookupError):
            os.kill(-1, signal.SIGKILL)
        os._exit(0)
    os.waitpid(pid, 0)


def _memory(pid: int, measure: Callable[[str], int]) -> int:
    """Bytes of RAM of the processes in the sandbox whose first process is `pid`."""
    total = 0
    with suppress(OSError):
        for entry in os.scandir(f'/proc/{pid}/root/proc'):
            if entry.name.isdecimal() and entry.name != '1':
                with suppress(OSError, ValueError, IndexError):
                    total += measure(entry.path)
    return total


def _own(process: str) -> int:
    """What is not a file's, and may still be shared with a process that was forked."""
    _, resident, shared, *_ = Path(process, 'statm').read_text().split()
    return (int(resident) - int(shared)) * _PAGE


def _share(process: str) -> int:
    """Its part of what it shares, and all that it does not share."""
    for line in Path(process, 'smaps_rollup').read_text().splitlines():
        if line.startswith('Pss_Anon:'):
            return int(line.split()[1]) * 1024
    raise ValueError('no Pss_Anon')
