"""Fork server of the learner's side: forks one process per program, from one that has imported ROS.

It reads requests from its control socket; each `fork` request carries two file descriptors, the program's JSON
channel and its output pipe. It never runs learner's code itself and never opens a DDS participant, so a forked
process is in the same state as a new one. When the control socket closes, it kills what it forked and ends.

Programs run the learner's cells. A task (`helpers.runner.commands`) runs in a place that no cell has run in.

    {"op": "fork", "key": k, "limits": {}} + 2 fds   ->  {"event": "forked", "key": k, "pid": p}
    {"op": a task, "key": k, "limits": {}, "place": name, …} + output, others
                                                     ->  {"event": "forked", "key": k, "pid": p}
    {"op": "kill", "key": k}                         ->  (none)
    {"op": "signal", "key": k, "number": n}          ->  (none)
    {"op": "used", "place": name}                    ->  {"event": "used", "seconds": s}, of processor time, for all
                                                         that runs in the place; null if that is not known
    {"op": "programs", "place": name}                ->  {"event": "programs", "count": n}: how many programs run in the
                                                         place that its tasks have started, see `process_tree.programs`
    {"op": "clear", "place": name}                   ->  {"event": "cleared"}, when nothing of the place runs; without a
                                                         place nothing at all
    {"op": "forget", "place": name}                  ->  {"event": "cleared"}, when the place is gone
    (a child ended)                                  ->  {"event": "ended", "key": k, "status": wait status, "why": ""}
"""

import array
import functools
import json
import os
import select
import signal
import socket
import sys
from collections.abc import Callable
from contextlib import suppress

from helpers import process_tree
from helpers.runner import commands, forked, preloading, sourced_environment
from helpers.runner.lifetime import die_with_parent
from helpers.runner.start_processes import Limits


class ProgramProcesses:
    """How a program's process is made and ended; a sandbox has its own way."""

    patience: float | None = None  # seconds between two looks at what the programs use; None: no look

    def fork(self, limits: Limits, channel: int, output: int) -> int:
        """Start a program's process; returns its pid."""
        pid = os.fork()
        if pid == 0:
            leave_server()
            die_with_parent()
            limits.apply()
            become_program(channel, output)
        return pid

    def task(self, limits: Limits, place: str, output: int, given: list[int], act: Callable[[], int]) -> int:
        """Start a process that does a task in a place; returns its pid."""
        pid = os.fork()
        if pid == 0:
            leave_server()
            die_with_parent()
            limits.apply()
            become_task(output, given, act)
        return pid

    def kill(self, pid: int) -> None:
        """End a program's process and what it has started."""
        process_tree.kill_family(pid)

    def signal(self, pid: int, number: int) -> None:
        """Send a signal to the process of a task."""
        with suppress(ProcessLookupError):
            os.kill(pid, number)

    def ended(self, pid: int) -> None:
        """A program's process has ended: end what it has left in its group. `clear` ends the rest."""
        process_tree.kill_group(pid)

    def clear(self, place: str | None = None) -> None:
        """End whatever is left of the programs, all of which have ended; or of the tasks in a place.

        An orphan in a session of its own does not tell from which place it is: it ends when all places are cleared.
        """
        if place is None:
            self.close()

    def forget(self, place: str) -> None:
        """Remove a place."""

    def used(self, place: str) -> float | None:
        """The processor time of what runs in a place, in seconds; None if that is not known."""
        return None

    def programs(self, place: str, tasks: list[int]) -> int:
        """How many programs run in a place that its tasks, of which these are the pids, have started."""
        return sum(process_tree.programs(process_tree.parents(pid), pid) for pid in tasks)

    def look(self) -> str:
        """End programs that use too much; returns why, or nothing."""
        return ''

    def close(self) -> None:
        """End all that this process has started, or taken over; also the last call."""
        for pid in process_tree.children(os.getpid()):
            process_tree.kill_family(pid)


def serve(control: socket.socket, programs: ProgramProcesses) -> None:
    """Tell that the server is ready, and serve requests until the control socket closes."""
    control.send(b'{"event": "ready"}')
    _Server(control, programs).serve()


class _Server:
    """Answers the requests that come from a control socket, and tells it which processes have ended."""

    def __init__(self, control: socket.socket, programs: ProgramProcesses):
        self._control, self._programs = control, programs
        self._children: dict[int, tuple[str, str | None]] = {}  # pid -> key, place
        self._why = ''  # the programs were ended

    def serve(self) -> None:
        """Serve requests until the control socket closes; end then what still runs."""
        # A signal wakes the select below; its handler has nothing else to do.
        woken, wake = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)
        signal.signal(signal.SIGCHLD, lambda *_: None)
        signal.set_wakeup_fd(wake, warn_on_full_buffer=False)
        try:
            self._serve([self._control, woken], woken)
        except ConnectionError:  # the tests' process was killed while it was told something
            pass
        for pid in self._children:
            self._programs.kill(pid)
        self._programs.close()

    def _serve(self, sources: list[socket.socket | int], woken: int) -> None:
        """Answer until the control socket closes. `woken` is the one of the sources that signals write to."""
        while True:
            ready, _, _ = select.select(sources, [], [], self._programs.patience if self._children else None)
            if woken in ready:
                os.read(woken, 4096)
            self._look_at_children()
            if self._control not in ready:
                continue
            data, ancillary, _, _ = socket_receive(self._control)
            if not data:
                return
            self._answer(json.loads(data), ancillary)
            for descriptor in ancillary:
                os.close(descriptor)

    def _tell(self, **event) -> None:
        self._control.sendall(json.dumps(event).encode())

    def _look_at_children(self) -> None:
        """End those that use too much, and tell of those that have ended."""
        if self._children:
            self._why = self._programs.look() or self._why
        for pid, (key, _) in list(self._children.items()):
            ended, status = os.waitpid(pid, os.WNOHANG)
            if ended:
                del self._children[pid]
                self._programs.ended(pid)
                self._tell(event='ended', key=key, status=status, why=self._why)

    def _answer(self, request: dict, descriptors: list[int]) -> None:
        """Do what a request says. Its descriptors stay open."""
        match request['op']:
            case 'kill' | 'signal':
                for pid, (key, _) in self._children.items():
                    if key == request['key']:
                        if 'number' in request:
                            self._programs.signal(pid, request['number'])
                        else:
                            self._programs.kill(pid)
            case 'clear' | 'forget':
                place = request['place']
                for pid, (_, where) in self._children.items():
                    if place in (None, where):
                        self._programs.kill(pid)
                self._programs.clear(place) if request['op'] == 'clear' else self._programs.forget(place)
                self._why = ''
                self._tell(event='cleared')
            case 'used':
                self._tell(event='used', seconds=self._programs.used(request['place']))
            case 'programs':
                tasks = [pid for pid, (_, where) in self._children.items() if where == request['place']]
                self._tell(event='programs', count=self._programs.programs(request['place'], tasks))
            case 'fork':
                self._fork(request, descriptors)
            case _:
                self._start_task(request, descriptors)

    def _fork(self, request: dict, descriptors: list[int]) -> None:
        channel, output = descriptors
        preloading.warm_up_for(request.get('modules', []))
        pid = self._programs.fork(Limits(**request['limits']), channel, output)
        self._children[pid] = request['key'], None
        self._tell(event='forked', key=request['key'], pid=pid)

    def _start_task(self, request: dict, descriptors: list[int]) -> None:
        output, *given = descriptors
        place = request['place']
        if request['op'] == 'pytest':
            preloading.warm_up_for_pytest(request.get('modules', []))
        elif request['op'] in ('command', 'shadows'):
            sourced_environment.warm_up()
        pid = self._programs.task(
            Limits(**request['limits']), place, output, given, functools.partial(commands.perform, request, given)
        )
        self._children[pid] = request['key'], place
        self._tell(event='forked', key=request['key'], pid=pid)


def leave_server() -> None:
    """In a forked child: undo what the server has set for itself."""
    signal.set_wakeup_fd(-1)
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)


def socket_receive(control: socket.socket):
    """One request with the file descriptors it carries (the control socket keeps message boundaries)."""
    data, ancillary, flags, address = control.recvmsg(65536, socket.CMSG_SPACE(3 * array.array('i').itemsize))
    descriptors = array.array('i')
    for level, kind, content in ancillary:
        if level == socket.SOL_SOCKET and kind == socket.SCM_RIGHTS:
            descriptors.frombytes(content[: len(content) - len(content) % descriptors.itemsize])
    return data, list(descriptors), flags, address


def become_program(channel: int, output: int) -> None:
    """In the forked child: make `output` the standard streams and run the worker. Never returns."""
    from helpers.runner import worker

    become_task(output, [channel], lambda: worker.run(socket.socket(fileno=channel)))


def become_task(output: int, given: list[int], act: Callable[[], int]) -> None:
    """In the forked child: make `output` the standard streams, keep `given` open, and act. Never returns."""
    code = 1
    try:
        forked.stand_alone(output, given)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        code = act()
    except BaseException:  # noqa: BLE001 - the child must not return into the server's loop
        import traceback

        traceback.print_exc()
    finally:
        try:
            sys.stdout.flush()
            sys.stderr.flush()
        finally:
            os._exit(code)
