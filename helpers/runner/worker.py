"""The learner's process: loads one program and does what the tests' side asks, one request at a time.

Nothing spins between requests, so the order of things is the same on an idle and on a loaded machine. Requests
and replies are JSON objects on a private socket (`helpers.runner.channel`); standard output is the learner's own.

Each request is a method `do_…` of `Worker`. One more, `where`, is answered at once by another thread while the main
thread is busy. Each reply has the request's `id` and either `ok: true` with results or `error: {...}`.
"""

import os
import queue
import signal
import socket
import sys
import threading
import time
import traceback
from contextlib import nullcontext, suppress

import rclpy
import rclpy.context
import rclpy.node
from rclpy.clock import ClockType
from rclpy.duration import Duration
from rclpy.exceptions import InvalidHandle
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.signals import SignalHandlerOptions
from std_msgs.msg import UInt64

from helpers.kernel.nodes import destroy_actions
from helpers.runner import awaiting, sleeping_threads, values
from helpers.runner.arguments import Arguments
from helpers.runner.channel import Channel, ChannelClosed, ChannelError, ChannelTimeout
from helpers.runner.conductor import Conductor
from helpers.runner.loaded_program import LoadedProgram, RequestError
from helpers.runner.mistakes import CONSTRUCTOR_WORK, MistakeWatch, watch
from helpers.runner.rclpy_changes import Outgoing, SimulatedTimeSource, arguments_of_nodes, for_other_contexts
from helpers.runner.threads import ThreadPool, patch_locks


def _depth(profile: QoSProfile) -> int:
    """How many messages an endpoint keeps; 0: all of them."""
    return 0 if profile.history == HistoryPolicy.KEEP_ALL else profile.depth


class Worker:
    """Answers the requests of the tests' side."""

    def __init__(self, channel: Channel):
        self.channel = channel
        self.requests: queue.SimpleQueue = queue.SimpleQueue()
        self.program: LoadedProgram | None = None
        self.executor: SingleThreadedExecutor | None = None
        self.conductor: Conductor | None = None
        self.sleepers = sleeping_threads.Sleepers()
        self.outgoing = Outgoing()
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
        SimulatedTimeSource.now = now
        rclpy.node.TimeSource = SimulatedTimeSource  # type: ignore[misc]  # every node is to have this one
        rclpy.init(
            args=['--ros-args', '-p', 'use_sim_time:=true', *ros_args], signal_handler_options=SignalHandlerOptions.NO
        )
        if ros_args:  # as `ros2 run` gives them: a context that the program makes itself takes them from here
            sys.argv[1:] = ['--ros-args', *ros_args]
        # The notebook's own start and stop of ROS mean this context. Other contexts are left as they are.
        for function in (rclpy.init, rclpy.shutdown, rclpy.try_shutdown):
            setattr(rclpy, function.__name__, for_other_contexts(function))
        program = self.program = LoadedProgram()
        program.watch = MistakeWatch(
            self._in_callback,
            lambda: bool(self.conductor and self.conductor.pool),
            lambda frame: frame.f_code.co_filename in program.labels,
        )
        watch(program.watch)
        self.outgoing.watch()
        patch_locks()
        if join:
            self.do_join()
        program.load(cells)
        program.watch.loaded()
        # Not before: what cells start beside the answer does not count.
        sleeping_threads.watch(self.sleepers, program.watch)
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

    def do_start(
        self, name: str, args: list, kwargs: dict, ros_args: list, threads: bool = False, switches: bool = False
    ):
        """Construct the learner's class (or call their function) and take the nodes that it gives.

        :param ros_args: for these nodes only.
        """
        factory = self._loaded().find(name)
        if not self.started:  # later ones may be kept by the program itself
            self._loaded().destroy_instances(factory)
        seen = self._loaded().watch
        if seen:
            seen.begins()
        begin = seen.processor_time() if seen else 0.0
        try:
            with arguments_of_nodes(ros_args) if ros_args else nullcontext():
                made = factory(*map(values.decode, args), **{k: values.decode(v) for k, v in kwargs.items()})
        except BaseException as error:  # noqa: BLE001 - SystemExit in a constructor, too
            raise self._loaded().error('constructor', error, name=name) from None
        if seen:
            seen.worked(name, seen.processor_time() - begin, CONSTRUCTOR_WORK)
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
                lambda: SimulatedTimeSource.now, switches, more=lambda: bool(conductor.accepted)
            )
        for node in nodes:
            conductor.executor.add_node(node)
        self.nodes += nodes
        self.started.append(made)
        return {
            'index': len(self.started) - 1,
            'endpoints': self._endpoints(),
            'nodes': [Node.get_fully_qualified_name(node) for node in nodes],  # whatever their own class says
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
        given = [values.decode(value) for value in args]
        named = {key: values.decode(value) for key, value in kwargs.items()}
        arguments = Arguments(function, given, named)
        try:
            encoded = values.encode_result(function(*given, **named))
        except BaseException as error:  # noqa: BLE001 - SystemExit, too
            raise self._loaded().error('call', error, name=name) from None
        return {'result': encoded, 'given': arguments.changed('given'), 'defaults': arguments.changed('default')}

    def do_mute(self, topic: str):
        """From now on nothing that the program publishes on this topic goes out, as if a cable were cut."""
        publish = Publisher.publish

        def muted(publisher, msg):
            if publisher.topic_name != topic:
                publish(publisher, msg)

        Publisher.publish = muted  # type: ignore[method-assign]  # of all publishers, also those that it makes later

    def do_value(self, name: str):
        """What the learner's program binds to a name."""
        return {'result': values.encode(self._loaded().find(name))}

    def do_join(self):
        """Make the conductor, if there is none yet."""
        if self.conductor is None:
            self.executor = SingleThreadedExecutor()
            self.conductor = Conductor(self.token, self._loaded(), self.executor, self.sleepers, self.outgoing)
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
        SimulatedTimeSource.now = now
        conductor, seen = self._joined(), self._loaded().watch
        count, reached = conductor.step(number, now, self.nodes, timeout)
        return {
            'count': count,
            'reached': reached,
            'next': self._next_timer(now),
            'endpoints': self._endpoints(),
            'waiting': conductor.waiting(),
            'remarks': [*(seen.remarks if seen else []), *self._sleeps(), *self._deadlocks()],
        }

    def _sleeps(self) -> list[str]:
        seen = self._loaded().watch
        own = self._loaded().lines(seen.asleep) if seen and seen.asleep else []
        return [
            f'A callback sleeps at {line["cell"]}, line {line["line"]}: `{line["code"]:.100}`. Nothing else of the '
            'node runs meanwhile: a timer does the waiting.'
            for line in own[-1:]
        ]

    def _deadlocks(self) -> list[str]:
        return awaiting.deadlocks(self.executor._tasks, self.nodes, self._loaded().lines) if self.executor else []

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
