"""The tests' side of the fork server: asks it for programs and commands, and follows them until they end."""

import itertools
import json
import os
import re
import select
import socket
import threading
import time
from collections.abc import Sequence
from dataclasses import asdict

from helpers.runner import start_processes
from helpers.runner.text import LEFT_OUT

# rcl's own remark on two nodes of one name: tests make them on purpose.
_NOISE = re.compile(r'^\[WARN\] \[rcl\.logging_rosout\]: Publisher already registered .*\n?', re.MULTILINE)
START_TIMEOUT = 30.0  # seconds until the fork server has imported ROS, on a machine under load


class RunnerError(Exception):
    """The runner itself does not work: an error of the grader's side."""


class ServerEnded(RunnerError):
    """The fork server has gone."""


class ForkServer:
    """The learner's side, ready to start programs."""

    def __init__(
        self, started: start_processes.StartedForkServer, limits: start_processes.Limits = start_processes.LIMITS
    ):
        """`started` comes from a launcher: `start_processes.start`, or a sandbox's. Waits until it is ready."""
        self.limits = limits
        self._started = started
        self.sandbox = self._started.sandbox
        self.home = self._started.home_folder  # of what runs there, as that sees it
        self._control = self._started.control
        self._keys = itertools.count(1)
        self._ended: dict[str, int] = {}
        self.why: dict[str, str] = {}  # programs were ended from outside
        self.workspaces: dict = {}  # what `helpers.runner.workspaces` has written and built in this session
        if self._event(START_TIMEOUT).get('event') != 'ready':
            raise RunnerError("the learner's side did not start")

    def _event(self, timeout: float) -> dict:
        if not select.select([self._control], [], [], timeout)[0]:
            raise RunnerError(f"the learner's side did not answer in {timeout:g} s")
        try:
            data = self._control.recv(65536)
        except OSError:
            data = b''
        if not data:
            raise ServerEnded("the learner's side has ended")
        return json.loads(data)

    def fork(self, modules: Sequence[str] = ()) -> tuple[str, socket.socket, int]:
        """Start a process for one program, within `limits`: (its key, its channel, the read end of its output).

        `modules`: what it imports, as far as the server may import it for all (`preloading.on_demand`).
        """
        key = str(next(self._keys))
        ours, theirs = socket.socketpair()
        output_read, output_write = os.pipe()
        with theirs:
            request = {'op': 'fork', 'key': key, 'limits': asdict(self.limits), 'modules': list(modules)}
            socket.send_fds(self._control, [json.dumps(request).encode()], [theirs.fileno(), output_write])
        os.close(output_write)
        self._until(lambda event: event.get('event') == 'forked' and event.get('key') == key, START_TIMEOUT)
        return key, ours, output_read

    def _until(self, wanted, timeout: float) -> None:
        deadline = time.monotonic() + timeout
        while True:
            event = self._event(max(0.0, deadline - time.monotonic()))
            if event.get('event') == 'ended':
                self._ended[event['key']] = event['status']
                if event.get('why'):
                    self.why[event['key']] = event['why']
            if wanted(event):
                return

    def task(self, op: str, place: str, *given: int, keep: int, **arguments) -> 'Task':
        """Start a task of `helpers.runner.commands` in a place; the last `keep` bytes that it prints are kept."""
        key = str(next(self._keys))
        output_read, output_write = os.pipe()
        request = {'op': op, 'key': key, 'limits': asdict(self.limits), 'place': place, **arguments}
        socket.send_fds(self._control, [json.dumps(request).encode()], [output_write, *given])
        os.close(output_write)
        self._until(lambda event: event.get('event') == 'forked' and event.get('key') == key, START_TIMEOUT)
        return Task(self, key, place, Output(output_read, keep, last=True))

    def kill(self, key: str) -> None:
        self._control.send(json.dumps({'op': 'kill', 'key': key}).encode())

    def signal(self, key: str, number: int) -> None:
        """Send a signal to the process of a task."""
        self._control.send(json.dumps({'op': 'signal', 'key': key, 'number': number}).encode())

    def wait(self, key: str, timeout: float) -> int | None:
        """The wait status of a program's process once it has ended; None if it still runs after `timeout` s."""
        try:
            if key not in self._ended:
                self._until(lambda event: key in self._ended, timeout)
        except ServerEnded:
            raise
        except RunnerError:
            return None
        return self._ended[key]

    def used(self, place: str) -> float | None:
        """The processor time of what runs in a place, in seconds; None if that is not known."""
        return self._ask('used', place)['seconds']

    def programs(self, place: str) -> int:
        """How many programs run in a place that its tasks have started, as is seen from outside of it."""
        return self._ask('programs', place)['count']

    def _ask(self, what: str, place: str) -> dict:
        """The answer to a question about a place: the event of the same name."""
        found: list[dict] = []
        self._control.send(json.dumps({'op': what, 'place': place}).encode())

        def told(event: dict) -> bool:
            if event.get('event') == what:
                found.append(event)
            return bool(found)

        self._until(told, START_TIMEOUT)
        return found[0]

    def clear(self, place: str | None = None) -> None:
        """End all that programs and tasks have left behind; or those in a place."""
        self._control.send(json.dumps({'op': 'clear', 'place': place}).encode())
        self._until(lambda event: event.get('event') == 'cleared', START_TIMEOUT)

    def forget(self, place: str) -> None:
        """Remove a place and all that is in it."""
        self._control.send(json.dumps({'op': 'forget', 'place': place}).encode())
        self._until(lambda event: event.get('event') == 'cleared', START_TIMEOUT)

    def close(self) -> None:
        self._started.close()


class Task:
    """A command that runs in a place of its own. Status and output are taken outside of it."""

    def __init__(self, server: ForkServer, key: str, place: str, output: 'Output'):
        self._server, self.key, self.place, self._output = server, key, place, output

    @property
    def output(self) -> str:
        """What it has printed so far, or the end of that."""
        return self._output.text

    def wait(self, timeout: float) -> int | None:
        """Its exit status, negative for a signal; None if it still runs after `timeout` seconds."""
        status = self._server.wait(self.key, timeout)
        if status is None:
            return None
        self._output.finish()
        return os.waitstatus_to_exitcode(status)

    def signal(self, number: int) -> None:
        """Send a signal to it."""
        self._server.signal(self.key, number)

    @property
    def programs(self) -> int:
        """How many programs it has started that run just now: nobody prints this, it is seen from outside."""
        return self._server.programs(self.place)

    def end(self) -> None:
        """Kill it, and all that runs in its place."""
        self._server.clear(self.place)
        self.wait(5.0)


class Output:
    """What a program prints: read in the background until it ends, and kept up to a limit."""

    def __init__(self, descriptor: int, limit: int, last: bool = False):
        """`last`: the end is kept, not the beginning."""
        self.limit, self.last = limit, last
        self._descriptor = descriptor
        self._kept = bytearray()
        self.truncated = False
        self._thread = threading.Thread(target=self._drain, daemon=True)
        self._thread.start()

    def _drain(self) -> None:
        while chunk := os.read(self._descriptor, 65536):
            if self.last:
                self._kept += chunk
                del self._kept[: -self.limit]
                continue
            room = self.limit - len(self._kept)
            self._kept += chunk[:room]
            self.truncated |= len(chunk) > room
        os.close(self._descriptor)

    @property
    def text(self) -> str:
        text = _NOISE.sub('', bytes(self._kept).decode(errors='replace'))
        return text + (f'\n{LEFT_OUT}' if self.truncated else '')

    def finish(self, timeout: float = 1.0) -> None:
        """Wait until the program has closed its end."""
        self._thread.join(timeout)
