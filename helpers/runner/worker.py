"""The learner's process: loads one program and does what the tests' side asks, one request at a time.

Nothing spins between requests, so the order of things is the same on an idle and on a loaded machine. Requests
and replies are JSON objects on a private socket (`helpers.runner.channel`); standard output is the learner's own.

Each request is a method `do_…` of `Worker`. One more, `where`, is answered at once by another thread while the main
thread is busy. Each reply has the request's `id` and either `ok: true` with results or `error: {...}`.
"""

import __future__

import ast
import asyncio
import functools
import inspect
import linecache
import operator
import os
import queue
import re
import signal
import socket
import sys
import threading
import time
import traceback
import types
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any

import rclpy
import rclpy.context
import rclpy.node
from rclpy.action import ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.clock import ClockType, ROSClock
from rclpy.duration import Duration
from rclpy.exceptions import InvalidHandle
from rclpy.executors import SingleThreadedExecutor, TimeoutException, await_or_execute
from rclpy.node import Node
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.signals import SignalHandlerOptions
from rclpy.time import Time
from rclpy.time_source import CLOCK_TOPIC, TimeSource
from rosgraph_msgs.msg import Clock
from std_msgs.msg import UInt64

from helpers.kernel.nodes import destroy_actions
from helpers.runner import rates, values
from helpers.runner.channel import Channel, ChannelClosed, ChannelError, ChannelTimeout
from helpers.runner.mistakes import CALLBACK_WORK, CONSTRUCTOR_WORK, STEADY_WORK, WaitsInCallback, Watch, watch
from helpers.runner.threads import Sleeps, ThreadPool, patch_locks

MAX_CALLBACKS = 5000  # in one step: more means that it never becomes idle
_SPARE_ROUNDS = 3  # rounds in which only unfinished coroutines made progress: they wait for something else


class RequestError(Exception):
    """A request that the learner's code made fail; `kind` and fields go to the tests' side."""

    def __init__(self, kind: str, **fields):
        super().__init__(kind)
        self.fields = {'kind': kind, **fields}


class _SimulatedTimeSource(TimeSource):
    """A time source that starts at the current simulated time, as if /clock had already been heard."""

    now = 0  # nanoseconds

    def __init__(self, *, node=None):
        super().__init__(node=None)
        self._last_time_set = Time(nanoseconds=type(self).now, clock_type=ClockType.ROS_TIME)
        if node is not None:
            self.attach_node(node)

    def _subscribe_to_clock_topic(self) -> None:
        """Hear /clock in a callback group of its own.

        In the node's default group, as rclpy has it, a callback that awaits an answer would stop the node's clock. That
        does not happen to the same program on the wall clock.
        """
        node = self._get_node()
        if self._clock_sub is None and node is not None:
            self._clock_sub = node.create_subscription(
                Clock,
                CLOCK_TOPIC,
                self.clock_callback,
                QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT),
                callback_group=MutuallyExclusiveCallbackGroup(),
            )


def _watch_actions(note: Callable[[Exception], Any], hold: Callable[[Callable[[], None]], Any]) -> None:
    """Have `note` called with what an execute callback raises: rclpy only prints it and aborts the goal.

    Each execution is given to `hold`, which begins it by a call when it is time.
    """
    plain = ActionServer.notify_execute

    def notify_execute(self, goal_handle, execute_callback):
        callback = execute_callback or self._execute_callback

        async def noting(goal_handle):
            try:
                result = await await_or_execute(callback, goal_handle)
                if isinstance(result, self.action_type.Result):
                    return result
                what = 'nothing (None)' if result is None else f'an object of type {type(result).__name__}'
                raise TypeError(f"execute returned {what}; return the action's Result on every way")
            except Exception as error:
                note(error)
                if goal_handle.is_active:
                    goal_handle.abort()
                return self.action_type.Result()

        hold(functools.partial(plain, self, goal_handle, noting))

    ActionServer.notify_execute = notify_execute  # type: ignore[method-assign]  # put around it on purpose


def _for_other_contexts(function):
    """`rclpy.init` or its like without any effect on the default context, which is the worker's."""

    @functools.wraps(function)
    def wrapped(*args, context=None, **kwargs):
        if context is not None and context is not rclpy.get_default_context():
            function(*args, context=context, **kwargs)

    return wrapped


class _Lines(Sequence):
    """The lines of a source that stands further down in its cell: empty ones before it, which take no memory."""

    def __init__(self, source: str, line: int):
        """`line`: the number of the source's first line."""
        self._before, self._lines = line - 1, source.splitlines(True)

    def __len__(self) -> int:
        return self._before + len(self._lines)

    def __getitem__(self, index):
        places = range(len(self))[index]
        return (
            [self[place] for place in places]
            if isinstance(places, range)
            else ('\n' if places < self._before else self._lines[places - self._before])
        )


_FUTURE = functools.reduce(
    operator.or_, (getattr(__future__, name).compiler_flag for name in __future__.all_feature_names)
)


def _compiled(source: str, line: int, filename: str, flags: int):
    """The code of a source whose first line has this number. As in notebooks, it may await outside of functions."""
    flags |= ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
    if line == 1:
        return compile(source, filename, 'exec', flags, dont_inherit=True)
    tree = ast.increment_lineno(ast.parse(source, filename), line - 1)
    return compile(tree, filename, 'exec', flags, dont_inherit=True)


class LoadedProgram:
    """The learner's code, loaded into a module of its own."""

    def __init__(self) -> None:
        self.module = types.ModuleType('notebook')
        self.notes: list[tuple[str, str]] = []  # cells that could not be run: their text, and what happened
        self.watch: Watch | None = None
        self.labels: dict[str, str] = {}
        vars(self.module)['display'] = lambda *objects, **options: None  # in notebooks it is there without an import
        sys.modules['notebook'] = self.module

    def load(self, cells: list[dict]) -> None:
        """Run the cells; they have `label`, `source`, `line` (of the source's beginning) and `required`.

        An exception in a cell that is not required is remembered in `notes`; in the required one it is a RequestError.
        """
        flags = 0  # of `from __future__ import …`, which holds for all later cells, as in the notebook
        for number, cell in enumerate(cells):
            filename = f'<cell {number}>'
            self.labels[filename] = cell['label']
            # For tracebacks: the learner's own lines.
            lines: Any = _Lines(cell['source'], cell['line'])  # any sequence will do
            linecache.cache[filename] = (len(cell['source']), None, lines, filename)
            try:
                # Names are resolved when a function runs, so annotations and defaults behave as in the notebook.
                code = _compiled(cell['source'], cell['line'], filename, flags)
                flags |= code.co_flags & _FUTURE
                awaited = eval(code, self.module.__dict__)  # noqa: S307 - the code is the learner's, and is to run
                if inspect.iscoroutine(awaited):
                    asyncio.run(awaited)
            except BaseException as error:  # noqa: BLE001 - SystemExit in a cell, too
                if cell['required']:
                    raise self.error('load', error) from None
                self.notes.append((cell['source'], f'{cell["label"]}: {type(error).__name__}: {_text(error)}'))

    def find(self, name: str):
        """The learner's object of that name; RequestError `missing` if there is none."""
        try:
            return getattr(self.module, name)
        except AttributeError:
            raise RequestError('missing', name=name) from None

    def error(self, where: str, error: BaseException, **fields) -> RequestError:
        """A RequestError that tells of `error` with the learner's own lines only."""
        if isinstance(error, RequestError):
            return error
        lines = self.lines(traceback.extract_tb(error.__traceback__))
        if isinstance(error, WaitsInCallback):
            return RequestError('waits', call=error.call, lines=lines)
        if isinstance(error, SyntaxError) and error.filename in self.labels:
            lines.append(
                {
                    'cell': self.labels[error.filename],
                    'line': error.lineno,
                    'function': '',
                    'code': (error.text or '').strip(),
                }
            )
        if isinstance(error, AttributeError) and self.watch is not None and self.watch.early:
            file, line = self.watch.early
            fields['early'] = f'at {self.labels.get(file, "your cell")}, line {line}'
        return RequestError(
            'exception',
            where=where,
            type=type(error).__name__,
            text=_text(error),
            lines=lines,
            notes=self.notes_on(error),
            **fields,
        )

    def notes_on(self, error: BaseException) -> list[str]:
        """What happened to the cells that could not be run and that hold the name that is missing."""
        name = getattr(error, 'name', None) or _text(error)
        return [note for source, note in self.notes if re.search(rf'\b{re.escape(name)}\b', source)][-5:]

    def lines(self, frames) -> list[dict]:
        """Those of the stack's frames (oldest first) that are the learner's."""
        found = [
            {
                'cell': self.labels[frame.filename],
                'line': frame.lineno,
                'function': frame.name,
                'code': (linecache.getline(frame.filename, frame.lineno) or '').strip()[:200],
            }
            for frame in frames
            if frame.filename in self.labels
        ]
        return found[:3] + found[-7:] if len(found) > 10 else found


def _text(error: BaseException) -> str:
    try:
        return str(error)[:2000]
    except BaseException:  # noqa: BLE001 - a learner's __str__ may raise, SystemExit too
        return ''


class Conductor:
    """The hidden node for the tests' side: it keeps messages in order and reports when no callback is left to run."""

    def __init__(self, token: str, program: LoadedProgram, executor: SingleThreadedExecutor, sleepers: rates.Sleepers):
        self.program, self.sleepers = program, sleepers
        self.executor = executor
        self.pool: ThreadPool | None = None  # where callbacks run in threads
        self.in_callback = False  # one of the learner's runs in the main thread
        self.raised: list[Exception] = []  # by execute callbacks of actions
        self.accepted: list[Callable[[], None]] = []  # executions of goals that have not begun
        _watch_actions(self.raised.append, self.accepted.append)
        self.node = Node(f'_{token}', start_parameter_services=False, enable_rosout=False, use_global_arguments=False)
        # Numbers seen: what was sent before them has arrived, too.
        self.step_seen = self.echo_seen = 0
        self.echo_sent = 0
        self.node.create_subscription(UInt64, f'/_{token}/step', self._on_step, 10)
        self.done = self.node.create_publisher(UInt64, f'/_{token}/done', 10)
        self.echo = self.node.create_publisher(UInt64, f'/_{token}/echo_{os.getpid()}', 10)
        self.node.create_subscription(UInt64, f'/_{token}/echo_{os.getpid()}', self._on_echo, 10)
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
            self._sent_since_echo |= self.sleepers.rest()  # what their threads have sent belongs to this step, too
            # What its nodes have sent to each other may still be on its way: it arrives before this echo.
            quiet = ran == 0 and self.echo_sent > 0 and not self._sent_since_echo
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
        begin = time.thread_time()
        try:
            handler()
            if not handler.done():
                return 0
            error = handler.exception()
        except BaseException as raised:  # noqa: BLE001 - SystemExit passes through rclpy's own handling
            error = raised
        finally:
            self.in_callback = False
            if self.program.watch and node is not self.node:
                self.program.watch.worked(_named(entity), time.thread_time() - begin, CALLBACK_WORK, STEADY_WORK)
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
    what = 'nothing (None)' if response is None else f'an object of type {type(response).__name__}'
    return TypeError(f'the callback of the service returned {what}; its last line must be `return response`')


def _depth(profile: QoSProfile) -> int:
    """How many messages an endpoint keeps; 0: all of them."""
    return 0 if profile.history == HistoryPolicy.KEEP_ALL else profile.depth


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
    return type(entity).__name__ if entity is not None else 'task'


class Worker:
    """Answers the requests of the tests' side."""

    def __init__(self, channel: Channel):
        self.channel = channel
        self.requests: queue.SimpleQueue = queue.SimpleQueue()
        self.program: LoadedProgram | None = None
        self.executor: SingleThreadedExecutor | None = None
        self.conductor: Conductor | None = None
        self.sleepers = rates.Sleepers()
        self.started: list = []  # what each `start` made
        self.nodes: list[Node] = []
        self.token = ''
        main = threading.main_thread().ident
        assert main is not None  # it has begun
        self._main = main
        self._sending = threading.Lock()

    def serve(self) -> None:
        """Answer one request after the other, `stop` as the last one; the process ends if the tests' side has gone."""
        threading.Thread(target=self._read, daemon=True).start()
        while (request := self.requests.get()) is not None:
            try:
                answer = {'ok': True, **(getattr(self, 'do_' + request['op'])(**request.get('with', {})) or {})}
            except RequestError as error:
                answer = {'error': error.fields}
            self._reply(request, answer)
            if request['op'] == 'stop':
                return

    def _read(self) -> None:
        """Pass requests to the main thread; answer `where` here, because the main thread may be stuck."""
        while True:
            try:
                request = self.channel.receive()
            except (ChannelClosed, ChannelError, ChannelTimeout):
                os._exit(0)  # the tests' side has ended
            if request['op'] == 'where':
                pool = self.conductor.pool if self.conductor else None
                frame = (pool.frame() if pool else None) or sys._current_frames().get(self._main)
                lines = self.program.lines(traceback.extract_stack(frame)) if self.program and frame else []
                self._reply(request, {'ok': True, 'lines': lines})
            else:
                self.requests.put(request)

    def _reply(self, request: dict, answer: dict) -> None:
        with self._sending:
            try:
                self.channel.send({'id': request['id'], **answer})
            except (ChannelError, ValueError) as error:  # also a number with thousands of digits
                self.channel.send({'id': request['id'], 'error': {'kind': 'too_long', 'text': str(error)}})

    # The requests

    def do_load(self, cells: list, ros_args: list, token: str, now: int, join: bool = False):
        """Initialise ROS and run the learner's program.

        :param join: `start` follows: the conductor is made first, so that tests' side and program find each other (a
            tenth of a second) while the cells run.
        """
        self.token = token
        _SimulatedTimeSource.now = now
        rclpy.node.TimeSource = _SimulatedTimeSource  # type: ignore[misc]  # every node is to have this one
        rclpy.init(
            args=['--ros-args', '-p', 'use_sim_time:=true', *ros_args], signal_handler_options=SignalHandlerOptions.NO
        )
        if ros_args:  # as `ros2 run` gives them: a context that the program makes itself takes them from here
            sys.argv[1:] = ['--ros-args', *ros_args]
        # The notebook's own start and stop of ROS mean this context. Other contexts are left as they are.
        for function in (rclpy.init, rclpy.shutdown, rclpy.try_shutdown):
            setattr(rclpy, function.__name__, _for_other_contexts(function))
        program = self.program = LoadedProgram()
        program.watch = Watch(
            self._in_callback,
            lambda: bool(self.conductor and self.conductor.pool),
            lambda frame: frame.f_code.co_filename in program.labels,
        )
        watch(program.watch)
        patch_locks()
        if join:
            self.do_join()
        program.load(cells)
        program.watch.loaded()
        rates.watch(self.sleepers, program.watch)  # not before: what cells start beside the answer does not count
        return {'notes': [note for _, note in program.notes]}

    def _in_callback(self) -> bool:
        """Whether a callback of the learner's runs in the calling thread."""
        conductor = self.conductor
        if conductor is None:
            return False
        if threading.get_ident() == self._main:
            return conductor.in_callback
        return bool(conductor.pool and conductor.pool.here())

    def _loaded(self) -> LoadedProgram:
        """The learner's program; RuntimeError before `load`."""
        if self.program is None:
            raise RuntimeError('no program is loaded: `load` is the first request')
        return self.program

    def _joined(self) -> Conductor:
        """The conductor; RuntimeError before `start` or `join`."""
        if self.conductor is None:
            raise RuntimeError('there is no conductor: `start` or `join` comes before this request')
        return self.conductor

    def do_start(self, name: str, args: list, kwargs: dict, threads: bool = False, switches: bool = False):
        """Construct the learner's class (or call their function) and take the nodes that it gives."""
        factory = self._loaded().find(name)
        seen = self._loaded().watch
        if seen:
            seen.begins()
        begin = time.thread_time()
        try:
            made = factory(*map(values.decode, args), **{k: values.decode(v) for k, v in kwargs.items()})
        except BaseException as error:  # noqa: BLE001 - SystemExit in a constructor, too
            raise self._loaded().error('constructor', error, name=name) from None
        if seen:
            seen.worked(name, time.thread_time() - begin, CONSTRUCTOR_WORK)
        nodes = list(made) if isinstance(made, (list, tuple)) else [made]
        for node in nodes:
            if not isinstance(node, Node):
                raise RequestError('no_node', name=name, got=type(node).__name__)
            try:
                node.get_name()
            except Exception:  # noqa: BLE001 - super().__init__() was not called, or the node is destroyed
                raise RequestError('no_super', name=name) from None
        self.do_join()
        conductor = self._joined()
        if threads and conductor.pool is None:
            conductor.pool = ThreadPool(
                lambda: _SimulatedTimeSource.now, switches, more=lambda: bool(conductor.accepted)
            )
        for node in nodes:
            conductor.executor.add_node(node)
        self.nodes += nodes
        self.started.append(made)
        return {
            'index': len(self.started) - 1,
            'endpoints': self._endpoints(),
            'nodes': [node.get_fully_qualified_name() for node in nodes],
            'namespaces': [seen.own_namespace(node) for node in nodes] if seen else [],
        }

    def do_call(self, name: str, args: list, kwargs: dict, index: int | None = None):
        """Call the learner's function, or a method of what a `start` made."""
        if index is None:
            function = self._loaded().find(name)
        else:
            function = getattr(self.started[index], name, None)
            if function is None:
                raise RequestError('missing', name=f'{type(self.started[index]).__name__}.{name}')
        if not callable(function):
            raise RequestError('not_callable', name=name, got=type(function).__name__)
        try:
            result = function(*map(values.decode, args), **{k: values.decode(v) for k, v in kwargs.items()})
            encoded = values.encode_result(result)
        except BaseException as error:  # noqa: BLE001 - SystemExit, too
            raise self._loaded().error('call', error, name=name) from None
        return {'result': encoded}

    def do_value(self, name: str):
        """What the learner's program binds to a name."""
        return {'result': values.encode(self._loaded().find(name))}

    def do_join(self):
        """Make the conductor, if there is none yet."""
        if self.conductor is None:
            self.executor = SingleThreadedExecutor()
            self.conductor = Conductor(self.token, self._loaded(), self.executor, self.sleepers)
        return {}

    def do_mark(self, mark: str):
        """Announce a fresh publisher and subscription on `mark`/worker.

        Discovery keeps order: a process that sees the mark has matched all endpoints that were made before it. Writers
        and readers are two ordered streams, so there is a mark in each.
        """
        node = self._joined().node
        publisher = node.create_publisher(UInt64, f'{mark}/worker', 1)
        self._marks = (publisher, node.create_subscription(UInt64, f'{mark}/worker', lambda message: None, 1))

    def do_sync(self, mark: str, workers: int, timeout: float):
        """Wait for the marks of the tests' side and of all `workers` processes of the learner's."""
        node = self._joined().node
        wanted = ((f'{mark}/tests', 1), (f'{mark}/worker', workers))
        deadline = time.monotonic() + timeout
        while any(min(node.count_publishers(topic), node.count_subscribers(topic)) < count for topic, count in wanted):
            if time.monotonic() > deadline:
                raise RequestError('deaf')
            time.sleep(0.001)  # a bounded poll: the graph has no event to wait for without spinning

    def do_unsync(self):
        """Withdraw the marks of `sync`."""
        publisher, subscription = self._marks
        node = self._joined().node
        node.destroy_publisher(publisher)
        node.destroy_subscription(subscription)

    def do_step(self, number: int, now: int, timeout: float):
        """Go to simulated time `now` (ns) with all that was sent before, and become idle."""
        _SimulatedTimeSource.now = now
        conductor, seen = self._joined(), self._loaded().watch
        count, reached = conductor.step(number, now, self.nodes, timeout)
        return {
            'count': count,
            'reached': reached,
            'next': self._next_timer(now),
            'endpoints': self._endpoints(),
            'waiting': conductor.waiting(),
            'remarks': seen.remarks if seen else [],
        }

    def _endpoints(self) -> int:
        """How many endpoints the learner's nodes have: more or fewer than before means new discovery."""
        return sum(
            len(list(kind))
            for node in self.nodes
            for kind in (node.publishers, node.subscriptions, node.services, node.clients, node.waitables)
        )

    def _next_timer(self, now: int) -> int | None:
        """The simulated time (ns) at which the next timer is due."""
        remaining = []
        for node in self.nodes:
            for timer in node.timers:
                # One that was destroyed, but not by its node, is still in the node's list.
                with suppress(InvalidHandle):
                    if timer.clock.clock_type == ClockType.ROS_TIME and not timer.is_canceled():
                        left = timer.time_until_next_call()
                        # What is overdue waits for its callback group, in which another callback still waits.
                        if left is not None and left > 0:
                            remaining.append(left)
        pool = self._joined().pool
        if pool and (due := pool.next_due()) is not None:
            remaining.append(due - now)
        return now + max(1, min(remaining)) if remaining else None

    def do_ack(self, timeout: float):
        """Wait until reliable messages have reached every reader, late joiners of latched topics included."""
        deadline = time.monotonic() + timeout
        for node in self.nodes:
            for publisher in list(node.publishers):
                if publisher.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT:
                    continue
                left = max(0.0, deadline - time.monotonic())
                publisher.wait_for_all_acked(Duration(seconds=left))
        return {}

    def do_switch(self, line: int, hold: bool):
        """Let a thread stand aside at a line of the learner's; tell what has come of the last such request."""
        pool = self._joined().pool
        if pool is None:
            raise RuntimeError('callbacks run in one thread: `start` must say that they may be switched')
        lines, stood = pool.lines, pool.stood
        pool.switch(line, hold)
        return {'lines': lines, 'stood': self._loaded().lines(stood or [])}

    def do_habits(self):
        """What only this process knows: the queues of its nodes, how long their lines have slept, which contexts live.

        rclpy counts the contexts that have been initialised and not shut down, also those that nobody refers to.
        """
        queues = [
            [kind, endpoint.topic_name, _depth(endpoint.qos_profile)]
            for node in self.nodes
            for kind, endpoints in (('publisher', node.publishers), ('subscription', node.subscriptions))
            for endpoint in endpoints
        ]
        return {'queues': queues, 'slept': self.program.watch.slept, 'contexts': rclpy.context.g_logging_ref_count}

    def do_stop(self):
        """Leave the graph, so that other participants forget this one at once."""
        if self.executor is not None:
            self.executor.shutdown(timeout_sec=1)
        rclpy.get_default_context().try_shutdown()
        for node in [*self.nodes, *([self.conductor.node] if self.conductor else [])]:
            try:
                destroy_actions(node)
                node.destroy_node()
            except Exception:  # noqa: BLE001 - a learner's destroy_node may raise; the process ends anyway
                pass
        return {}


def run(sock: socket.socket) -> int:
    """Serve one program over `sock` until it is stopped; returns the process's exit code."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Worker(Channel(sock)).serve()
    return 0
