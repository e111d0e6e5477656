"""The programs of one submission, in the learner's sandbox: a side for `helpers.runner.warm`.

The fork server itself stays outside, where no program sees it. Each program's process enters the sandbox, gives up
every privilege, gets its limits and the filter of system calls, and only then reads its first line of the learner's
code.
"""

import os
import signal
import socket
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from grading.sandbox import control_groups, kernel_memory, mounts, namespaces, seccomp
from grading.sandbox.holder import Holder
from helpers import process_tree
from helpers.runner import fork_server, forked, sourced_environment
from helpers.runner.lifetime import die_with_parent
from helpers.runner.start_processes import Limits

INODES = 20_000  # files and folders in each place that can be written
TERMINALS = 32  # pseudo-terminals; the kernel has room for some thousands of them, of all users together
_BUFFERS = 2 * 212_992  # bytes: what one socket sends and receives, by the kernel's usual settings
_KERNEL = 0.5  # seconds between two looks at what the kernel holds


def warm_up() -> None:
    """What is the same for the workspaces of all submissions. The server is an ordinary user's."""
    os.umask(0o077)
    sourced_environment.warm_up()


def prepare(request: dict) -> None:
    """Nothing: the server knows no submission."""


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
    fork_server.serve(tests, programs)


class Sandboxed(fork_server.ProgramProcesses):
    """Programs in a sandbox, which is made for the first one and stays for the submission's other ones.

    Each place of tasks is a sandbox of its own.
    """

    patience = 0.1

    def __init__(self, tests: int):
        """`tests`: a pidfd of the process of tests, whose network the programs share."""
        self._tests = tests
        self._cells = Sandbox(tests)
        self._places: dict[str, Sandbox] = {}

    def fork(self, limits: Limits, channel: int, output: int) -> int:
        return self._cells.start(limits, [channel, output], lambda: fork_server.become_program(channel, output))

    def task(self, limits: Limits, place: str, output: int, given: list[int], act: Callable[[], int]) -> int:
        if place not in self._places:
            self._places[place] = Sandbox(self._tests)
        return self._places[place].start(limits, [output, *given], lambda: fork_server.become_task(output, given, act))

    def kill(self, pid: int) -> None:
        with suppress(ProcessLookupError):
            os.kill(pid, signal.SIGTERM)  # it kills the program's group, see namespaces.mirror

    def ended(self, pid: int) -> None:
        """Its group has been killed already."""

    def clear(self, place: str | None = None) -> None:
        for sandbox in self._all() if place is None else self._named(place):
            sandbox.clear()

    def forget(self, place: str) -> None:
        for sandbox in self._named(place):
            sandbox.close()
        self._places.pop(place, None)

    def used(self, place: str) -> float | None:
        return sum(sandbox.used() for sandbox in self._named(place))

    def programs(self, place: str, tasks: list[int]) -> int:
        return sum(sandbox.programs() for sandbox in self._named(place))

    def look(self) -> str:
        return next((why for sandbox in self._all() if (why := sandbox.look())), '')

    def close(self) -> None:
        for sandbox in self._all():
            sandbox.close()

    def _all(self) -> list['Sandbox']:
        return [self._cells, *self._places.values()]

    def _named(self, place: str) -> list['Sandbox']:
        return [self._places[place]] if place in self._places else []


class Sandbox:
    """One sandbox within the network of the tests; made when the first process is started in it."""

    def __init__(self, tests: int):
        self._tests = tests
        self._holder: Holder | None = None
        self._processes = -1  # its /proc, open
        self._sizes: tuple | None = None  # of the places that can be written
        self._limits = Limits()
        self._used = False  # since the last `clear`
        self._kernel = (0.0, 0)  # when it was asked last what the kernel holds, and the answer
        self._bounds = control_groups.Bounds(None, self._limits)

    def start(self, limits: Limits, kept: list[int], act: Callable[[], None]) -> int:
        """Start a process inside that acts, with these open files; returns the pid of one outside that mirrors it."""
        if self._holder is None or self._holder.process.poll() is not None:
            self.close()
            self._holder = Holder(mounts.programs(limits), self._tests, seccomp.program())
            # Opened before anything of the learner's runs: what these mean cannot be changed from inside.
            self._processes = os.open(f'/proc/{self._holder.pid}/root/proc', os.O_PATH | os.O_DIRECTORY)
            self._mounts = os.open(f'/proc/{self._holder.pid}/ns/mnt', os.O_RDONLY)
            self._sizes = None
            self._bounds = control_groups.Bounds(control_groups.settled(control_groups.own()), limits)
        if limits != self._limits:
            self._bounds.set(limits)
        self._limits, self._used = limits, True
        sizes = (limits.tmp, limits.home, limits.shared)
        if sizes != self._sizes:
            self._inside(lambda: _resize(limits), namespaces.NEWNS)
            self._sizes = sizes
        pid = os.fork()
        if pid == 0:
            fork_server.leave_server()
            self._enter(limits, kept, act)
        return pid

    def _enter(self, limits: Limits, kept: list[int], act: Callable[[], None]) -> None:
        """In a forked child: start the process inside and end as it does. Never returns."""
        try:
            die_with_parent()
            assert self._holder is not None  # `start` has made it
            self._bounds.join()
            namespaces.join(self._holder.pidfd, namespaces.ALL)
            forked.close_all_but(kept)
            pid = os.fork()
            if pid:
                namespaces.give_up_privileges()
                die_with_parent()  # a change of privileges has undone it
                for descriptor in kept:
                    os.close(descriptor)
                namespaces.mirror(pid)
            namespaces.give_up_privileges()
            die_with_parent()
            os.chdir(mounts.HOME)
            limits.apply(sandboxed=True)
            seccomp.install()
            act()
        except BaseException:  # noqa: BLE001 - the child must not return into the server's loop
            import traceback

            traceback.print_exc()
        finally:
            os._exit(1)

    def clear(self) -> None:
        """Kill all that runs inside."""
        if self._holder is not None and self._used:
            self._end_all()
            self._used = False

    def look(self) -> str:
        """Kill all that runs inside if it uses too much memory; returns why, or nothing."""
        most = self._limits.total_memory
        if self._holder is None or not self._used:
            return ''
        if self._bounds.exceeded():
            self._end_all()
            return 'memory'
        # What forked processes still share counts once, but that takes longer to find out.
        kernel = _socket_buffers(self._holder.pid) + self._kernel_memory(most)
        if self._sum(_own) + kernel < most or self._sum(_share) + kernel < most:
            return ''
        self._end_all()
        return 'memory'

    def _end_all(self) -> None:
        self._inside(_kill_all, namespaces.ALL)
        self._kernel = 0.0, 0  # what it held for them it does not hold any more

    def used(self) -> float:
        """The processor time of what runs inside, and of its children that have ended, in seconds."""
        return self._sum(_ticks) / os.sysconf('SC_CLK_TCK')

    def programs(self) -> int:
        """How many programs run that tasks have started: their parents are inside, orphans' is process 1."""
        parents: dict[int, int] = {}

        def add(process: str) -> int:
            letter, parent = process_tree.state(process)
            if letter not in process_tree.ENDED:
                parents[int(Path(process).name)] = parent
            return 0

        self._sum(add)
        return process_tree.programs(parents, *(pid for pid, parent in parents.items() if parent == 0))

    def close(self) -> None:
        """End it. Idempotent."""
        if self._holder is not None:
            self._holder.close()
            self._bounds.close()
            os.close(self._processes)
            os.close(self._mounts)
            self._holder = self._sizes = None

    def _kernel_memory(self, most: int) -> int:
        """What the kernel holds for the processes inside: nearly always little, so it is asked less often."""
        asked, answer = self._kernel
        if (now := time.monotonic()) > asked + _KERNEL:
            with suppress(OSError):
                answer = kernel_memory.held(Path(f'/proc/self/fd/{self._processes}'), most)
            self._kernel = now, answer
        return answer

    def _sum(self, measure: Callable[[str], int]) -> int:
        """The sum of a measure over the processes inside."""
        total = 0
        with suppress(OSError):
            for name in os.listdir(f'/proc/self/fd/{self._processes}'):
                if name.isdecimal() and name != '1':
                    with suppress(OSError, LookupError, ValueError):
                        total += measure(f'/proc/self/fd/{self._processes}/{name}')
        return total

    def _inside(self, act, kinds: int) -> None:
        """Have a child enter these namespaces, with all privileges there, and act."""
        pid = os.fork()
        if pid == 0:
            code = 1
            try:
                fork_server.leave_server()
                if kinds == namespaces.ALL:
                    assert self._holder is not None  # who calls this has looked
                    namespaces.join(self._holder.pidfd, kinds)
                else:
                    namespaces.join(namespaces.owner(self._mounts), namespaces.NEWUSER)
                    namespaces.join(self._mounts, kinds)
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
    for place, size in (('/tmp', limits.tmp), (str(mounts.HOME), limits.home), ('/dev/shm', limits.shared)):
        namespaces.mount(
            'tmpfs',
            place,
            None,
            namespaces.MS_REMOUNT | namespaces.MS_NOSUID | namespaces.MS_NODEV,
            f'size={size},nr_inodes={INODES}',
        )
    namespaces.mount(
        'devpts',
        '/dev/pts',
        None,
        namespaces.MS_REMOUNT | namespaces.MS_NOSUID,
        f'ptmxmode=666,mode=620,max={TERMINALS}',
    )


def _kill_all() -> None:
    """Kill every process of the sandbox but its first, from a process inside: no fork is quicker than that."""
    pid = os.fork()
    if pid == 0:
        with suppress(ProcessLookupError):
            os.kill(-1, signal.SIGKILL)
        os._exit(0)
    os.waitpid(pid, 0)


def _ticks(process: str) -> int:
    """Processor time of a process and of its children that have ended."""
    return sum(map(int, Path(process, 'stat').read_text().rpartition(')')[2].split()[11:15]))


def _own(process: str) -> int:
    """What is not a file's that is only mapped, and may still be shared with a process that was forked."""
    return _status(process, 'RssAnon:', 'RssShmem:', 'VmPTE:')


def _status(process: str, *names: str) -> int:
    """The sum of these lines of a process's status, in bytes."""
    lines = Path(process, 'status').read_text().splitlines()
    return sum(int(line.split()[1]) * 1024 for line in lines if line.startswith(names))


def _share(process: str) -> int:
    """Its part of what it shares, shared memory included, and all that it does not share."""
    total = _status(process, 'VmPTE:')  # the kernel's tables for it: they grow with memory that is only read, too
    for line in Path(process, 'smaps_rollup').read_text().splitlines():
        if line.startswith(('Pss_Anon:', 'Pss_Shmem:')):
            total += int(line.split()[1]) * 1024
    return total


def _socket_buffers(pid: int) -> int:
    """The most bytes that the sockets in the network of a process can hold."""
    with suppress(OSError, LookupError, ValueError):
        first = Path(f'/proc/{pid}/net/sockstat').read_text().splitlines()[0]
        return int(first.split()[2]) * _BUFFERS
    return 0
