"""The tests' side of the learner's process: starts it, asks it, and turns what goes wrong into a LearnerError."""

import itertools
import json
import os
import re
import select
import signal
import socket
import threading
import time
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict

from helpers.runner import allowed_replies, explanations, preloading, spent, start_processes, values
from helpers.runner.arguments import Changed
from helpers.runner.channel import Channel, ChannelClosed, ChannelError, ChannelTimeout
from helpers.runner.load import busy
from helpers.runner.text import LEFT_OUT
from helpers.runner.verdicts import InvalidProgram, LearnerCrashed, LearnerError, LearnerTimeout, Unheard

# rcl's own remark on two nodes of one name: tests make them on purpose.
_NOISE = re.compile(r'^\[WARN\] \[rcl\.logging_rosout\]: Publisher already registered .*\n?', re.MULTILINE)
# Functions in which the callback of a deadlock waits for the answer of a service or an action.
_WAITS_FOR_ANSWER = ('.call(', 'until_future_complete', '.done()', '.send_goal(', '.get_result(', 'spin_once(')
MAX_EARLY = 100  # answers that are kept for later
WHERE_TIMEOUT = 3.0  # seconds; a program that cannot tell where it is holds the interpreter's lock
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
        found: list[float | None] = []
        self._control.send(json.dumps({'op': 'used', 'place': place}).encode())

        def told(event: dict) -> bool:
            if event.get('event') == 'used':
                found.append(event['seconds'])
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


def _imports(lines: list[dict] | None) -> bool:
    """Whether a program stands in an import: how long that takes is up to the machine's disk and processor."""
    return lines is not None and lines != [] and lines[-1]['code'].lstrip().startswith(('import ', 'from '))


class ProgramProcess:
    """One process of the learner's with their program loaded."""

    @spent.part('load')
    def __init__(
        self,
        server: ForkServer,
        program: dict,
        *,
        ros_args=(),
        token: str,
        now: int,
        timeout: float,
        join: bool = False,
    ):
        """Load `program` (see `helpers.exercises.program`). Raises LearnerError if it cannot be loaded.

        :param join: nodes will be started in it.
        """
        self.server = server
        self.title = program['title']
        self.absent = program.get('absent', {})
        self.answer = program.get('answer', '')
        self.key, sock, output = server.fork(preloading.on_demand(program['cells']))
        self.channel = Channel(sock)
        self.output = Output(output, server.limits.output)
        self._ids = itertools.count(1)
        self.ended = False
        self.changed: list[Changed] = []
        self._early: list[dict] = []  # answers that came while another one was awaited
        try:
            self.ask('load', timeout, cells=program['cells'], ros_args=list(ros_args), token=token, now=now, join=join)
        except BaseException:
            self.kill()
            raise

    def ask(self, op: str, limit: float, **arguments) -> dict:
        """Ask and wait at most `limit` seconds for the answer. Raises LearnerError for what the learner's code did."""
        number = next(self._ids)
        lines: list[dict] | None = []
        try:
            self.channel.send({'id': number, 'op': op, 'with': arguments})
            try:
                answer = self._answer(number, limit)
            except ChannelTimeout:
                if busy():  # a right program may be late: judged are those that get the processor
                    with suppress(ChannelTimeout):
                        answer = self._answer(number, 3 * limit)
                        allowed_replies.check(op, answer)
                        return self._unless_at_fault(answer, arguments)
                lines = self._where()
                if lines != [] and not _imports(lines):
                    raise
                # No line of the learner's is running, or one that loads a module: the machine is slow, not the program.
                answer = self._answer(number, 3 * limit)
            allowed_replies.check(op, answer)
        except ChannelTimeout:
            raise self._hanging(op, limit, arguments, lines or []) from None
        except ChannelClosed:
            raise self._gone(op) from None
        except ChannelError as error:
            self.kill()
            raise LearnerCrashed(f'Your program disturbed its connection to the tests ({error}).') from None
        return self._unless_at_fault(answer, arguments)

    def _unless_at_fault(self, answer: dict, arguments: dict) -> dict:
        if 'error' in answer:
            raise self._error(answer['error'], arguments)
        return answer

    def _answer(self, number: int, timeout: float) -> dict:
        deadline = time.monotonic() + timeout
        while True:
            answer = self._early.pop(0) if self._early else self.channel.receive(max(0.0, deadline - time.monotonic()))
            if answer.get('id') == number:
                return answer

    def _where(self) -> list[dict] | None:
        """The learner's lines that the program is at; None if not even that is answered."""
        number = next(self._ids)
        try:
            self.channel.send({'id': number, 'op': 'where'})
            deadline = time.monotonic() + WHERE_TIMEOUT
            while True:
                answer = self.channel.receive(max(0.0, deadline - time.monotonic()))
                if answer.get('id') == number:
                    return _lines(answer)
                if len(self._early) >= MAX_EARLY:
                    raise ChannelError('answers that nobody has asked for')
                self._early.append(answer)
        except (ChannelTimeout, ChannelClosed, ChannelError):
            return None

    def _hanging(self, op: str, limit: float, arguments: dict, lines: list[dict]) -> LearnerError:
        self.kill()
        doing = {
            'load': 'The cell',
            'start': f'`{arguments.get("name")}(…)`',
            'call': f'`{arguments.get("name")}(…)`',
        }.get(op, 'A callback')
        where = ''
        if lines:
            last = lines[-1]
            where = f' It was still at {last["cell"]}, line {last["line"]}: `{last["code"]}`.'
        asks = any(waiting in line['code'] for line in lines for waiting in _WAITS_FOR_ANSWER)
        hint = (
            ' It waits for an answer, which only another callback can receive, and none runs before this one has '
            'returned: a deadlock. Use call_async, and go on in a done-callback or after `await`.'
            if op == 'step' and asks
            else ' A callback must return at once; what has to wait belongs into a timer.'
            if op == 'step'
            else " Spinning and waiting are not the node's business: leave them to the program that runs it."
            if op in ('start', 'load')
            else ''
        )
        return LearnerTimeout(f'{doing} did not return within {limit:g} s.{where}{hint}', _stack(lines))

    def _gone(self, op: str) -> LearnerError:
        status = self.server.wait(self.key, 5.0)
        self.ended = True
        self.output.finish()
        how = 'ended'
        if self.server.why.get(self.key) == 'memory':
            return LearnerCrashed('Your program used more memory than it may.')
        if status is not None and os.WIFEXITED(status):
            how = f'ended by itself (exit status {os.WEXITSTATUS(status)})'
        elif status is not None and os.WIFSIGNALED(status):
            number = os.WTERMSIG(status)
            if number == signal.SIGXCPU:
                return LearnerTimeout('Your program used up its computing time.')
            if number in (signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS):
                return LearnerCrashed(
                    f'The process of your program crashed ({signal.Signals(number).name}). In Python this happens when '
                    'something is destroyed that ROS still uses: does a callback call destroy_node() on its own node, '
                    'or rclpy.shutdown()?'
                )
            how = f'was ended by {signal.Signals(number).name}'
        return LearnerCrashed(
            f'The process of your program {how}. A node must not end its process: do not call exit().'
        )

    def _error(self, problem: dict, arguments: dict) -> LearnerError:
        name = str(problem.get('name', arguments.get('name', '')))[:200]
        match problem.get('kind'):
            case 'missing':
                return InvalidProgram(self.absent.get(name) or f'{self.title} does not define `{name}`.')
            case 'waits':
                return self._waits(problem)
            case 'no_node':
                return LearnerError(
                    f'`{name}(…)` gives {_a(str(problem.get("got"))[:100])}, not a node. '
                    'A class must inherit from `Node`; a function must return the node.'
                )
            case 'no_super':
                return LearnerError(
                    f"`{name}` is not initialised as a node: call `super().__init__('…')` first in `__init__`."
                )
            case 'not_callable':
                return LearnerError(f'`{name}` is {_a(str(problem.get("got"))[:100])}, not a function.')
            case 'busy':
                return LearnerError(
                    f'Your node never comes to rest: {problem.get("count")} callbacks ran at one '
                    'moment of simulated time. Has a timer the period 0, or does a node answer its own '
                    'messages?'
                )
            case 'too_long':
                return LearnerError(f'What `{name}(…)` returns is too long to be read.')
            case 'sleeps':
                return LearnerError(
                    f'A callback sleeps with time.sleep{_at(problem)}: that is the clock on the wall. '
                    "While it sleeps, no time passes for the robot. Wait on the node's clock: "
                    'self.get_clock().sleep_for(…), a rate, or a timer.',
                    _stack(_lines(problem)),
                )
            case 'exception':
                return self._exception(problem, name)
            case 'deaf':
                return Unheard(
                    'Your program did not hear in time what was sent to it. Does it do something else '
                    'meanwhile, in a thread of its own?'
                )
        return LearnerCrashed('Your program disturbed its connection to the tests (an error of an unknown kind).')

    def _waits(self, problem: dict) -> LearnerError:
        """A callback waits for another callback."""
        call, lines = str(problem.get('call'))[:100], _lines(problem)
        what = 'spins' if 'spin' in call else 'waits for an answer'
        return LearnerTimeout(
            f'A callback {what}{_at(problem)}. Only another callback can receive what it waits for, and none runs '
            'before this one has returned: a deadlock, with or without a timeout. Use call_async (or send_goal_async), '
            'and go on in a done-callback or after `await`.',
            _stack(lines),
        )

    def _exception(self, problem: dict, name: str) -> LearnerError:
        where: dict[str | None, str] = {
            'load': 'While the cell was run',
            'constructor': f'While `{name}(…)` was made',
            'call': f'While `{name}(…)` ran',
            'execute': 'In an execute callback',
            'callback': _callback(problem),
        }
        lines = _lines(problem)
        kind, text = str(problem.get('type'))[:100], str(problem.get('text'))[:1000]
        text = re.sub(r' \(<cell \d+>, line \d+\)$', '', text)  # where it is stands in `lines`
        at = f' at {lines[-1]["cell"]}, line {lines[-1]["line"]}' if lines else ''
        if kind == 'SystemExit':
            return LearnerCrashed(
                f'{where.get(problem.get("where"), "Then")} your code called exit(){at}. '
                'A node must not end its process.',
                _stack(lines),
            )
        if kind == 'EOFError' and 'reading a line' in text:
            return LearnerCrashed(
                f'Your code called input(){at}. Nobody is at a keyboard while it is tested: take '
                'what you need as an argument or a parameter.',
                _stack(lines),
            )
        error = f'{kind}: {text}' if text else kind
        notes = problem.get('notes')
        notes = notes[:5] if isinstance(notes, list) and kind in ('NameError', 'ImportError') else []
        called = '' if lines else str(problem.get('callback', ''))[:100]
        early = str(problem.get('early', ''))[:200]
        code = lines[-1]['code'] if lines else ''
        more = explanations.explain(kind, text, early, self.absent, called, notes, self.answer, code)
        return LearnerCrashed(
            f'{where.get(problem.get("where"), "Then")} your code raised {error}{at}. {more}'.strip(),
            '\n'.join([_stack(lines), error, *(f'Not loaded: {note}' for note in notes)]),
        )

    def call(self, name: str, args, kwargs, timeout: float, index: int | None = None):
        """Call the learner's function (or a method of what start number `index` made) and decode what it returns.

        `changed` tells then which of its arguments it has changed.
        """
        answer = self.ask(
            'call',
            timeout,
            name=name,
            args=[values.encode(a) for a in args],
            kwargs={k: values.encode(v) for k, v in kwargs.items()},
            index=index,
        )
        for kind in ('given', 'defaults'):
            new = [Changed(name, argument[:50], kind == 'given') for argument in answer[kind][:10]]
            self.changed += [one for one in dict.fromkeys(new) if one not in self.changed]
        try:
            return values.decode(answer.get('result'))
        except ValueError as error:
            raise LearnerCrashed(f'`{name}(…)` returned {error}.') from None

    def stop(self, timeout: float = 2.0) -> None:
        """Ask the program to leave the graph and end; kill it if it does not. Idempotent."""
        if not self.ended:
            try:
                self.ask('stop', timeout)
                if self.server.wait(self.key, timeout) is None:
                    self.kill()
            except LearnerError:
                self.kill()
            self.ended = True
        self.output.finish()
        self.channel.close()

    def kill(self) -> None:
        """End the process at once."""
        if not self.ended:
            self.server.kill(self.key)
            self.server.wait(self.key, 5.0)
            self.ended = True
            self.output.finish()


def _a(kind: str) -> str:
    return 'nothing (None)' if kind == 'NoneType' else f'an object of type `{kind}`'


def _lines(message: dict) -> list[dict]:
    """The learner's lines in a message, whatever else it may hold."""
    found = message.get('lines')
    return (
        [
            {key: str(line.get(key, ''))[:300] for key in ('cell', 'line', 'function', 'code')}
            for line in found[:20]
            if isinstance(line, dict)
        ]
        if isinstance(found, list)
        else []
    )


def _callback(problem: dict) -> str:
    """In which callback it was. A done-callback of a future belongs to no node."""
    if not problem.get('callback'):
        return 'In a done-callback, or in a task of the executor,'
    return f'In a callback ({problem["callback"]} of node `{problem.get("node")}`)'


def _at(problem: dict) -> str:
    """Where the innermost of the learner's lines is, to be put into a sentence."""
    lines = _lines(problem)
    return f' at {lines[-1]["cell"]}, line {lines[-1]["line"]}: `{lines[-1]["code"]}`' if lines else ''


def _stack(lines: list[dict]) -> str:
    """The learner's lines as a traceback."""
    return '\n'.join(
        f'{line["cell"]}, line {line["line"]}{", in " + line["function"] if line["function"] else ""}\n'
        f'    {line["code"]}'
        for line in lines
    )
