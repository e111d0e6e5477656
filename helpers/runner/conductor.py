"""The hidden node of a learner's process: it runs the callbacks of one step after the other."""

import os
import time
import traceback
from collections.abc import Callable, Coroutine
from typing import Any

from rclpy.clock import ROSClock
from rclpy.executors import SingleThreadedExecutor, TimeoutException
from rclpy.node import Node
from std_msgs.msg import UInt64

from helpers.runner import silent_endpoints as silent
from helpers.runner import sleeping_threads
from helpers.runner.loaded_program import LoadedProgram, RequestError
from helpers.runner.mistakes import CALLBACK_WORK, STEADY_WORK
from helpers.runner.rclpy_changes import Outgoing, watch_actions
from helpers.runner.threads import Sleeps, ThreadPool

MAX_CALLBACKS = 5000  # in one step: more means that it never becomes idle
_SPARE_ROUNDS = 3  # rounds in which only unfinished coroutines made progress: they wait for something else


class Conductor:
    """The hidden node for the tests' side: it keeps messages in order and reports when no callback is left to run."""

    def __init__(
        self,
        token: str,
        program: LoadedProgram,
        executor: SingleThreadedExecutor,
        sleepers: sleeping_threads.Sleepers,
        outgoing: Outgoing,
    ):
        self.program, self.sleepers, self.outgoing = program, sleepers, outgoing
        self.executor = executor
        self.pool: ThreadPool | None = None  # where callbacks run in threads
        self.in_callback = False  # one of the learner's runs in the main thread
        self.raised: list[Exception] = []  # by execute callbacks of actions
        self.accepted: list[Callable[[], None]] = []  # executions of goals that have not begun
        watch_actions(self.raised.append, self.accepted.append)
        self.node = Node(f'_{token}', start_parameter_services=False, enable_rosout=False, use_global_arguments=False)
        # Numbers seen: what was sent before them has arrived, too.
        self.step_seen = self.echo_seen = 0
        self.echo_sent = 0
        own, echo = f'/_{token}', f'/_{token}/echo_{os.getpid()}'
        self.node.create_subscription(UInt64, f'{own}/step', self._on_step, 10, event_callbacks=silent.SUBSCRIPTION)
        self.node.create_subscription(UInt64, echo, self._on_echo, 10, event_callbacks=silent.SUBSCRIPTION)
        self.done = self.node.create_publisher(UInt64, f'{own}/done', 10, event_callbacks=silent.PUBLISHER)
        self.echo = self.node.create_publisher(UInt64, echo, 10, event_callbacks=silent.PUBLISHER)
        executor.add_node(self.node)

    def _on_step(self, message: UInt64) -> None:
        self.step_seen = message.data

    def _on_echo(self, message: UInt64) -> None:
        self.echo_seen = message.data

    def step(self, number: int, now: int, nodes: list[Node], timeout: float) -> tuple[int, bool]:
        """Run callbacks until step `number` has come and nothing more is ready.

        Returns the number of the learner's callbacks that ran, and whether the time `now` (ns) has come, too.
        RequestErrors: `busy` (never idle), `deaf` (a message needs more than `timeout` s), `exception` in a callback.
        """
        # No callback of the learner's runs before all has arrived that was sent before the step.
        self._hear(lambda: self.step_seen >= number, timeout)
        count = 0
        quiet = False
        while not quiet:
            ran = self._drain(count)
            count += ran
            woken = self.sleepers.rest()
            self._sent_since_echo |= woken  # what their threads have sent belongs to this step, too
            # What its nodes have sent to each other may still be on its way: it arrives before this echo.
            quiet = ran == 0 and self.echo_sent > 0 and not self._sent_since_echo
            if not quiet and not self.outgoing.reaches(nodes):
                # Nothing that it sends arrives here; only a thread of its own may have made something else ready.
                quiet, self._sent_since_echo = not woken, False
                continue
            if not quiet:
                self._sent_since_echo = False
                self.echo_sent += 1
                self.echo.publish(UInt64(data=self.echo_sent))
                self._hear(lambda: self.echo_seen >= self.echo_sent, timeout)
        reached = all(
            clock.now().nanoseconds >= now
            for clock in (node.get_clock() for node in nodes)
            if isinstance(clock, ROSClock) and clock.ros_time_is_active
        )
        if self.raised:
            raise self.program.error('execute', self.raised.pop(0))
        self.done.publish(UInt64(data=number))
        return count, reached

    def waiting(self) -> list[dict]:
        """The learner's line at which each callback waits."""
        found: list[dict] = []
        if self.pool is None:
            return found
        for thread in self.pool.waiting:
            lines = self.program.lines(traceback.extract_stack(self.pool.frame(thread)))
            found += lines[-1:]
        return found

    def _hear(self, came: Callable[[], bool], timeout: float) -> None:
        """Receive messages to the conductor itself until `came()`; the RequestError `deaf` after `timeout` seconds.

        The bound is on this one message's way: the time that callbacks have taken before does not count.
        """
        deadline = time.monotonic() + timeout
        while not came():
            # Looked at before the wait: a process that had no computing time still takes what has arrived.
            late = time.monotonic() > deadline
            try:
                handler, _, node = self.executor.wait_for_ready_callbacks(timeout_sec=0.05, nodes=[self.node])
            except TimeoutException:
                node = None
            if node is self.node:  # tasks of the learner's are offered, too: their turn comes later
                handler()
            elif late:
                raise RequestError('deaf')

    _sent_since_echo = True

    def _drain(self, before: int) -> int:
        """Run what is ready until nothing is; returns how many of the learner's callbacks ran.

        A goal begins to execute when nothing else is ready: all goals of one moment are answered before. With several
        threads rclpy does so at times, and no program may rely on the contrary.
        """
        total = spare = 0
        while True:
            ran, progressed = self._pass()
            total += ran
            if total + before > MAX_CALLBACKS:
                raise RequestError('busy', count=total + before)
            spare = 0 if ran else spare + 1
            if progressed and spare < _SPARE_ROUNDS:
                continue
            if not self.accepted:
                return total
            self.accepted.pop(0)()
            spare = 0

    def _pass(self) -> tuple[int, bool]:
        """One pass over all that is ready now: (finished callbacks of the learner's, anything at all)."""
        entity: Any  # whose callback it is: a timer, a subscription, …
        ran, progressed = 0, False
        while True:
            try:
                handler, entity, node = self.executor.wait_for_ready_callbacks(timeout_sec=0)
            except TimeoutException:
                if not self._resume():
                    return ran, progressed
                ran += 1
            else:
                ran += self._run(handler, entity, node)
            progressed = True
            if ran > MAX_CALLBACKS:
                return ran, progressed

    def _resume(self) -> bool:
        """Let callbacks go on that wait in threads, if what they wait for has come."""
        if self.pool is None:
            return False
        try:
            went_on = self.pool.resume()
        except Sleeps as sleeps:
            lines = self.program.lines(traceback.extract_stack(sleeps.frame))
            raise RequestError('sleeps', lines=lines) from None
        self._sent_since_echo |= went_on
        self._count_ended(self.pool)
        return went_on

    def _count_ended(self, pool: ThreadPool) -> int:
        """Look at the callbacks that have ended in threads; returns how many were the learner's and have finished."""
        count = 0
        while pool.ended:
            handler, entity, node = pool.ended.pop(0)
            error = pool.raised.pop(id(handler), None)
            if error is not None or handler.done():
                count += self._count(error or handler.exception(), entity, node)
        return count

    def _run(self, handler, entity, node) -> int:
        """Run one ready callback; returns 1 if it is the learner's and has finished, else 0."""
        if self.program.watch:
            self.program.watch.begins()
        if self.pool and node is not self.node and getattr(entity, 'topic_name', None) != '/clock':
            self._sent_since_echo |= self.pool.run(handler, entity, node)  # it may have sent something before it waits
            return self._count_ended(self.pool)
        self.in_callback = node is not self.node
        watch = self.program.watch
        begin = watch.processor_time() if watch else 0.0
        try:
            handler()
            if not handler.done():
                return 0
            error = handler.exception()
        except BaseException as raised:  # noqa: BLE001 - SystemExit passes through rclpy's own handling
            error = raised
        finally:
            self.in_callback = False
            if watch and node is not self.node:
                watch.worked(_named(entity), watch.processor_time() - begin, CALLBACK_WORK, STEADY_WORK)
        return self._count(error, entity, node)

    def _count(self, error: BaseException | None, entity, node) -> int:
        """1 for a callback of the learner's that has ended, 0 for another one; RequestError if it has raised."""
        if error is not None:
            raise self.program.error(
                'callback', _explained(error), node=node.get_name() if node else '', callback=_describe(entity)
            ) from None
        if node is self.node or getattr(entity, 'topic_name', None) == '/clock':
            return 0
        self._sent_since_echo = True
        return 1


def _explained(error: BaseException) -> BaseException:
    """The error with words of its own: rclpy raises a bare TypeError for a response of the wrong type."""
    last = error.__traceback__
    while last is not None and last.tb_next is not None:
        last = last.tb_next
    if last is None or not isinstance(error, TypeError) or str(error):
        return error
    if last.tb_frame.f_code.co_name != 'send_response':
        return error
    response = last.tb_frame.f_locals.get('response')
    if isinstance(response, Coroutine):
        return TypeError(
            'the callback of the service returned a coroutine: rclpy awaits a callback that is itself an `async def`, '
            'not one that another function, such as a lambda, calls'
        )
    what = 'nothing (None)' if response is None else f'an object of type {type(response).__name__}'
    return TypeError(f'the callback of the service returned {what}; its last line must be `return response`')


def _named(entity) -> str:
    """Which callback it is. It asks nothing of rclpy: the callback may have destroyed its timer."""
    callback = getattr(entity, 'callback', None)
    return f'{type(entity).__name__} {getattr(callback, "__qualname__", "")}'


def _describe(entity) -> str:
    """What a callback belongs to, in a learner's words."""
    for attribute, words in (('topic_name', 'subscription of'), ('srv_name', 'service')):
        if name := getattr(entity, attribute, None):
            return f'{words} {name}'
    if hasattr(entity, 'timer_period_ns'):
        return f'timer of {entity.timer_period_ns / 1e9:g} s'
    return type(entity).__name__ if entity is not None else ''
