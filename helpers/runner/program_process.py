"""The tests' side of the learner's process: starts it, asks it, and raises what goes wrong as a LearnerError."""

import itertools
import os
import signal
import time
from contextlib import suppress

from helpers.runner import allowed_replies, preloading, program_errors, spent, values
from helpers.runner.arguments import Changed
from helpers.runner.channel import Channel, ChannelClosed, ChannelError, ChannelTimeout
from helpers.runner.fork_client import ForkServer, Output
from helpers.runner.load import busy
from helpers.runner.program_errors import ProgramErrors
from helpers.runner.verdicts import LearnerCrashed, LearnerError, LearnerTimeout

MAX_EARLY = 100  # answers that are kept for later
WHERE_TIMEOUT = 3.0  # seconds; a program that cannot tell where it is holds the interpreter's lock


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
        self._title = program['title']
        texts = [cell['source'] for cell in program['cells']]
        self._errors = ProgramErrors(self._title, program.get('absent', {}), program.get('answer', ''), texts)
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
            self.kill()
            raise program_errors.hanging(op, limit, arguments, lines or [], self._title) from None
        except ChannelClosed:
            raise self._gone(op) from None
        except ChannelError as error:
            self.kill()
            raise LearnerCrashed(f'Your program disturbed its connection to the tests ({error}).') from None
        return self._unless_at_fault(answer, arguments)

    def _unless_at_fault(self, answer: dict, arguments: dict) -> dict:
        if 'error' in answer:
            raise self._errors.of(answer['error'], arguments)
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
                    return program_errors.lines_of(answer)
                if len(self._early) >= MAX_EARLY:
                    raise ChannelError('answers that nobody has asked for')
                self._early.append(answer)
        except (ChannelTimeout, ChannelClosed, ChannelError):
            return None

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
