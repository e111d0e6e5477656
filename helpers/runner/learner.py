"""The `learner` fixture: what a test can do with the learner's program, over DDS and in simulated time."""

import itertools
import secrets
import time
from dataclasses import dataclass
from functools import cached_property
from random import Random
from typing import TYPE_CHECKING

from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor, TimeoutException
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from rosgraph_msgs.msg import Clock
from std_msgs.msg import UInt64

from helpers.kernel.nodes import UNKNOWN
from helpers.runner import action_peers, service_peers, spent, values, wiring
from helpers.runner import silent_endpoints as silent
from helpers.runner.arguments import Changed
from helpers.runner.fork_client import ForkServer
from helpers.runner.own_endpoints import Received, Talker
from helpers.runner.peers import SECOND, Peer
from helpers.runner.program_process import ProgramProcess
from helpers.runner.started_nodes import StartedNodes
from helpers.runner.timeouts import TIMEOUTS, Timeouts
from helpers.runner.verdicts import LearnerError, Unheard
from helpers.runner.workspaces import Workspaces

if TYPE_CHECKING:
    from helpers.runner import frames

MAX_MOMENTS = 250  # of simulated time, in a tenth of a second of it, at which the learner's timers are due
MAX_MESSAGES = 5000  # at one moment of simulated time, on all topics that a test records


@dataclass(frozen=True)
class _Own:
    """The test's node, and what goes with it."""

    context: Context
    node: Node
    executor: SingleThreadedExecutor
    clock: Publisher
    step: Publisher


class Learner(Workspaces):
    """One test's access to the learner's program. Close it after the test.

    `random` is where a test draws its inputs: a `random.Random` of this test and this submission (see
    `helpers.runner.seeds`). An input that is drawn cannot be written into an answer beforehand.
    """

    def __init__(
        self,
        server: ForkServer,
        program: dict,
        domain_id: int,
        timeouts: Timeouts = TIMEOUTS,
        *,
        random: Random,
        relative: bool = False,
    ):
        """`relative`: the card's names are relative, so that no node may choose a namespace for itself."""
        self.server, self.program, self.timeouts, self.random = server, program, timeouts, random
        self.relative = relative
        self.token = secrets.token_hex(6)  # makes names unique without naming the test
        self.now = 0  # simulated time, ns
        self.unsettled = False
        self.processes: list[ProgramProcess] = []
        self._stepped: set[str] = set()  # keys of processes that have a conductor
        self._calls: ProgramProcess | None = None
        self._numbers = itertools.count(1)
        self._recordings: list[Received] = []
        self._participant = b''  # of the test's node
        self._participants: set[bytes] = set()  # of all programs that belong to the test
        self._talkers: list[Talker] = []
        self._peers: list[Peer] = []
        self._connected = True
        self._endpoints: dict = {}  # how many each of the learner's processes has, by its key
        self._past_output = ''
        self.transcripts: list[list[str]] = []  # of commands, per workspace
        self._done: dict[int, int] = {}
        self._domain_id = domain_id

    @cached_property
    def _own(self) -> '_Own':
        """The test's own node, made when it is first needed: a test that only calls functions has none."""
        context = Context()
        context.init(domain_id=self._domain_id)
        node = Node(
            f'_{self.token}_t',
            context=context,
            start_parameter_services=False,
            enable_rosout=False,
            use_global_arguments=False,
        )
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)
        clock = node.create_publisher(Clock, '/clock', 10, event_callbacks=silent.PUBLISHER)
        step = node.create_publisher(UInt64, f'/_{self.token}/step', 10, event_callbacks=silent.PUBLISHER)
        node.create_subscription(
            UInt64, f'/_{self.token}/done', self._on_done, 100, event_callbacks=silent.SUBSCRIPTION
        )
        return _Own(context, node, executor, clock, step)

    @property
    def context(self) -> Context:
        """That of the test's own nodes."""
        return self._own.context

    @property
    def node(self) -> Node:
        """The test's own node."""
        return self._own.node

    # What the learner's program is asked to do

    def start(
        self,
        name: str,
        *args,
        parameters: dict | None = None,
        remap: dict | None = None,
        beside: StartedNodes | None = None,
        threads: bool = False,
        switches: bool = False,
        **kwargs,
    ) -> StartedNodes:
        """Make the learner's node in a process of its own, in simulated time.

        `name` is their class, or a function that returns a node or a list of nodes. `parameters` and `remap` act as
        `-p name:=value` and `-r from:=to` on the command line. `beside` puts the node into the process of an earlier
        one, with that one's parameters and remappings, unless it gets its own: two objects of one class must not share
        state. `threads`: run the callbacks of this process in threads, as a MultiThreadedExecutor does, so that one may
        wait while others run (`helpers.runner.threads`). `switches`: the same, and `StartedNodes.switch` may let
        threads change in the middle of a callback.
        """
        ros_args = []
        for key, value in (parameters or {}).items():
            ros_args += ['-p', f'{key}:={_yaml(value)}']
        for key, value in (remap or {}).items():
            ros_args += ['-r', f'{key}:={value}']
        process = beside.process if beside else self._process(ros_args, join=True)
        answer = process.ask(
            'start',
            self.timeouts.start,
            name=name,
            ros_args=ros_args if beside else [],
            threads=threads or switches,
            switches=switches,
            args=[values.encode(a) for a in args],
            kwargs={k: values.encode(v) for k, v in kwargs.items()},
        )
        self._stepped.add(process.key)
        self._endpoints[process.key] = answer['endpoints']
        self._connected = False
        if self.relative:
            wiring.check_namespaces(answer['namespaces'])
        return StartedNodes(self, process, answer['index'], [str(node) for node in answer['nodes']])

    def call(self, name: str, *args, **kwargs):
        """Call a function of the learner's and return its result.

        Arguments and result are JSON values, ROS messages, QoSProfile, Duration or Time; a result of another type
        is a `values.Opaque`. All calls of one test share one process.
        """
        return self.command_process().call(name, args, kwargs, self.timeouts.call)

    def mute(self, topic: str) -> None:
        """From now on, until `end_calls`, what their functions publish on this topic does not leave their process."""
        self.command_process().ask('mute', self.timeouts.call, topic=topic)

    def changed(self, function: str, *, defaults: bool = False) -> list[str]:
        """The arguments that calls of this function have changed, by the names of its parameters.

        `defaults`: also those that were not given. It is what the learner's process says.
        """
        found = [one.argument for one in self._changed() if one.function == function and (one.given or defaults)]
        return list(dict.fromkeys(found))

    def _changed(self) -> list[Changed]:
        return [one for process in self.processes for one in process.changed]

    def command_process(self) -> ProgramProcess:
        """The process in which functions are called and commands run: one for a test."""
        if self._calls is None:
            self._calls = self._process([])
        return self._calls

    def end_calls(self) -> None:
        """End the process of `call` and all that it has left: commands run where no cell does.

        The next call gets another one. A test that has started nodes wants them to go on.
        """
        if self._calls is not None:
            process, self._calls = self._calls, None
            process.stop()
            self.forget(process)
            if not self.processes:
                self.server.clear()

    def _process(self, ros_args: list[str], join: bool = False) -> ProgramProcess:
        process = ProgramProcess(
            self.server,
            self.program,
            ros_args=ros_args,
            token=self.token,
            now=self.now,
            timeout=self.timeouts.load,
            join=join,
        )
        self.processes.append(process)
        return process

    def forget(self, process: ProgramProcess) -> None:
        """Drop a process that has ended; its output stays."""
        self.processes.remove(process)
        self._stepped.discard(process.key)
        self._endpoints.pop(process.key, None)
        self._past_output += process.output.text

    @property
    def output(self) -> str:
        """What the learner's program has printed and logged so far."""
        printed = self._past_output + ''.join(process.output.text for process in self.processes)
        return printed + '\n'.join(text for transcript in self.transcripts for text in transcript)

    # The test's own endpoints

    def listen(self, topic: str, msg_type, qos: QoSProfile | int = 10, *, strict: bool = True) -> Received:
        """Record `topic`. `strict`: a learner's publisher of another type or incompatible QoS fails the test."""
        recording = Received(topic, strict=strict)
        recording.subscription = self.node.create_subscription(
            msg_type,
            topic,
            # rclpy's annotations leave out the callback with two arguments.
            lambda message, info: self._record(recording, message, info),  # type: ignore[arg-type,misc]
            qos,
            event_callbacks=SubscriptionEventCallbacks(
                matched=lambda event: self._matched(recording, event), use_default_callbacks=False
            ),
        )
        self._recordings.append(recording)
        self._connected = False
        return recording

    def late_listener(self, topic: str, msg_type, qos: QoSProfile | int | None = None) -> Received:
        """A subscription that joins now and gets what is latched (default QoS: TRANSIENT_LOCAL, depth 10)."""
        qos = qos or QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        recording = self.listen(topic, msg_type, qos)
        self.settle()
        return recording

    def talk(self, topic: str, msg_type, qos: QoSProfile | int = 10, *, strict: bool = True) -> Talker:
        """A publisher on `topic`. `strict` as in `listen`."""
        own = self.node.create_publisher(msg_type, topic, qos, event_callbacks=silent.PUBLISHER)
        talker = Talker(self, own, strict)
        self._talkers.append(talker)
        self._connected = False
        return talker

    def client(self, name: str, srv_type, *, strict: bool = True) -> service_peers.ClientPeer:
        """A client for the learner's service `name`: `call` and `send`. `strict`: another type there fails the test."""
        return self.add(service_peers.ClientPeer(self, name, srv_type, strict))

    def serve(self, name: str, srv_type, answer, delay=0.0, *, strict: bool = True) -> service_peers.ServicePeer:
        """A server for the learner's client of `name`: `requests`, `stamps`, `stop()`, `start()`.

        `answer`: a response, a dictionary of its fields, None (silence), a function of the request that gives one of
        these, or an iterator with one of these for each request. `delay`: seconds of simulated time until an answer
        goes out; a number, or a function of the request. `strict` as in `client`.
        """
        return self.add(service_peers.ServicePeer(self, name, srv_type, answer, delay, strict))

    def action_client(self, name: str, action_type, *, strict: bool = True) -> action_peers.ActionClientPeer:
        """A client for the learner's action `name`: `send` gives a goal with its feedback, status, result, `cancel`."""
        return self.add(action_peers.ActionClientPeer(self, name, action_type, strict))

    def action_server(
        self,
        name: str,
        action_type,
        plan=(),
        *,
        accept=True,
        cancel: str = 'accept',
        cancel_delay: float = 0.0,
        partial=None,
        strict: bool = True,
    ) -> action_peers.ActionServerPeer:
        """An action server for the learner's client of `name`: `goals`, `stop()`, `start()`.

        `plan`: pairs (seconds of simulated time after the one before, Feedback or Result or `actions.Aborted`), or a
        function of the goal that gives them; without an end the goal goes on for ever. `accept`: whether goals are, or
        a function of the goal. `cancel`: 'accept' (`cancel_delay` seconds later the goal ends with the result
        `partial`), 'reject', or 'ignore' (accept, and go on as planned). All may be changed at any time.
        """
        return self.add(
            action_peers.ActionServerPeer(self, name, action_type, plan, accept, cancel, cancel_delay, partial, strict)
        )

    def tf_broadcaster(self) -> 'frames.Broadcaster':
        """Transforms for the learner's listener: `send` for `/tf`, `fix` for `/tf_static`."""
        from helpers.runner import frames  # imports numpy and tf2, which only tests about frames need

        return frames.Broadcaster(self)

    def tf_listener(self) -> 'frames.Listener':
        """What the learner broadcasts: `transforms`, `static_transforms`, `matrix`. A late one gets what is latched."""
        from helpers.runner import frames

        return self.add(frames.Listener(self))

    def add(self, peer: Peer):
        """Take in a partner of the learner's program, and return it."""
        self._peers.append(peer)
        self.rewired()
        return peer

    def rewired(self) -> None:
        """Endpoints of the test's have come or gone: `connect` before anything is sent."""
        self._connected = False

    def own_nodes(self) -> list[tuple[str, str]]:
        """(name, namespace) of the learner's nodes."""
        return [
            (name, namespace)
            for name, namespace in self.node.get_node_names_and_namespaces()
            if not name.startswith('_')
        ]

    def is_in_graph(self, name: str) -> bool:
        """Whether a node with this full name is in the graph, or comes soon."""

        def there() -> bool:
            found = self.node.get_node_names_and_namespaces()
            return name in {f'{space.rstrip("/")}/{node}' for node, space in found}

        if not there():
            self.connect()
        return self.wait_until(there, self.timeouts.discovery)

    def published(self) -> set[str]:
        """The topics on which the learner's programs have publishers, under whatever name of a node.

        Those on which the tests conduct them are left out.
        """
        there = {topic for topic, _ in self.node.get_topic_names_and_types()}
        own = f'/_{self.token}/'
        return {topic for topic in there if not topic.startswith(own) and self.endpoints(topic).publishers}

    def endpoints(self, topic: str) -> wiring.Endpoints:
        """The learner's publishers and subscriptions on `topic`: node, type, qos."""
        self.connect()
        topic = topic if topic.startswith('/') else '/' + topic
        return wiring.endpoints(self.node, topic, self._is_foreign)

    def depths(self, kind: str, topic: str) -> list[int]:
        """The queue depths of the learner's endpoints of this kind ('publisher', 'subscription') on `topic`.

        0 stands for KEEP_ALL. The graph does not tell depths, so the learner's processes are asked. What a late joiner
        or a burst can show should be judged by that.
        """
        return [
            depth
            for process in self._conducted()
            for found, name, depth in process.ask('habits', self.timeouts.call)['queues']
            if (found, name) == (kind, topic)
        ]

    @property
    def slept(self) -> float:
        """How many seconds the learner's lines have slept or waited for a server so far, outside of `threads=True`."""
        return sum(process.ask('habits', self.timeouts.call)['slept'] for process in self._conducted())

    @property
    def contexts(self) -> int:
        """How many contexts are initialised and not shut down where functions are called."""
        return self.command_process().ask('habits', self.timeouts.call)['contexts']

    def _is_foreign(self, info) -> bool:
        # By participant, as any program may use a name, also that of the conductor: it is in the learner's process.
        return _participant(info) != self._participant

    # Time and order

    def run(self, seconds: float, step: float = 0.1, *, until=None) -> None:
        """Let `seconds` of simulated time pass, in lock-step with the learner's nodes, or less if `until()` is true.

        Time goes from one due timer to the next, by at most `step` seconds, so that timers fire at their exact times.
        """
        if self.unsettled or not self._connected:
            self.settle()  # what was sent has arrived before time moves
        end = self.now + round(seconds * SECOND)
        largest = max(1, round(step * SECOND))
        begin, moments, since = self.now, 0, time.monotonic()
        while self.now < end and not (until and until()):
            moments += 1
            if self.now - begin >= SECOND // 10:
                begin, moments, since = self.now, 0, time.monotonic()
            if moments > MAX_MOMENTS or moments > 20 and time.monotonic() - since > self.timeouts.discovery:
                raise LearnerError(
                    'Your program has something to do at far too many moments of simulated time. Has a '
                    'timer a very small period? It is in seconds.'
                )
            due = [time_due for time_due in (*self._due, *(peer.due() for peer in self._peers)) if time_due is not None]
            self._step_to(max(self.now + 1, min([end, self.now + largest, *due])))
            self.connect()
        self._acknowledge()

    def jump(self, seconds: float) -> None:
        """Let the clock go forward at once: what was due in between is called late, and a timer once only.

        So it is after a callback that has blocked, or on a busy machine.
        """
        self.settle()
        self._step_to(self.now + round(seconds * SECOND))
        self.settle()

    def settle(self) -> None:
        """Let the learner's nodes react to all that was sent, without letting time pass."""
        self.connect()
        self._settle()

    def _settle(self) -> None:
        self._confirm()  # else the step may come before what was sent on another topic
        self._step_to(self.now)
        self.connect()
        self._acknowledge()

    def wait_until(self, condition, timeout: float = 10.0) -> bool:
        """Settle again and again until `condition()` is true; False after `timeout` seconds of wall time."""
        deadline = time.monotonic() + timeout
        while not condition():
            if time.monotonic() > deadline:
                return False
            self.settle()
            self._spin_once(0.01)
        return True

    _heard: tuple[int, int] = (0, 0)  # the moment of the last message, and how many came at it
    _due: tuple = ()
    _waiting: list = []  # the learner's lines at which callbacks waited after the last step
    _remarks: list = []  # sentences on mistakes that the learner's processes have noticed

    def _step_to(self, now: int) -> None:
        """Bring every process to `now`, until a round in which nothing happened."""
        self.now = now
        for _ in range(100):
            for peer in self._peers:
                peer.act()
            self._own.clock.publish(Clock(clock=Time(nanoseconds=now).to_msg()))
            number = next(self._numbers)
            self._own.step.publish(UInt64(data=number))
            answers = [
                process.ask('step', self.timeouts.stuck, number=number, now=now, timeout=self.timeouts.step)
                for process in self._conducted()
            ]
            self._drain(number, len(answers))
            self._due = tuple(answer.get('next') for answer in answers)
            self._waiting = [line for answer in answers for line in answer.get('waiting', ())]
            self._remarks = [text[:500] for answer in answers for text in answer.get('remarks', ())[:10]]
            # A callback may have made or destroyed endpoints: these are connected before the next step.
            endpoints = {
                process.key: answer.get('endpoints') for process, answer in zip(self._conducted(), answers, strict=True)
            }
            self._connected &= endpoints == self._endpoints
            self._endpoints = endpoints
            self.unsettled = False
            # One process is idle after one round. Several may have sent something to each other, and /clock is best
            # effort: what is lost is sent again.
            active = len(answers) > 1 and any(answer.get('count') for answer in answers)
            active |= any((due := peer.due()) is not None and due <= now for peer in self._peers)
            if not active and all(answer.get('reached') for answer in answers):
                return
            for process in self._conducted():  # what they have sent to each other arrives before the next round
                process.ask('ack', self.timeouts.step, timeout=5.0)
        if active:
            raise LearnerError("Your nodes never come to rest: they answer each other's messages without end.")
        raise Unheard('Your program does not take the time from /clock.')

    def _conducted(self) -> list[ProgramProcess]:
        return [process for process in self.processes if process.key in self._stepped]

    def _on_done(self, message: UInt64) -> None:
        self._done[message.data] = self._done.get(message.data, 0) + 1

    def _record(self, recording: Received, message, info: dict) -> None:
        moment, count = self._heard
        count = count + 1 if moment == self.now else 1
        self._heard = (self.now, count)
        if count > MAX_MESSAGES:
            raise LearnerError(
                f'More than {MAX_MESSAGES} messages came on {recording.topic} at one moment of '
                "simulated time: your program publishes without a pause. Publish in a timer's "
                'callback.'
            )
        recording.spoken = True
        recording.messages.append(message)
        recording.stamps.append(self.now / SECOND)
        recording.numbers.append(info['publication_sequence_number'])
        recording.published.append(info['source_timestamp'])

    def _matched(self, recording: Received, event) -> None:
        recording.matched = max(recording.matched, event.total_count)
        recording.gone = event.total_count - event.current_count

    def _check_origin(self) -> None:
        """Raise LearnerError if a program besides the test's and the learner's publishes to a recording.

        A program of the learner's has one participant. Another process, or another context, is another participant.
        Who has gone before the first message came has said nothing: a cell may make a node, and destroy it.
        """
        for recording in self._recordings:
            if not recording.spoken:
                recording.silent = recording.gone
            seen = bool(recording.messages), recording.matched, recording.gone
            if not recording.strict or not recording.messages or seen == recording.judged:
                continue  # who is matched since then has raised an event
            recording.judged = seen
            infos = self.node.get_publishers_info_by_topic(recording.subscription.topic_name)
            recording.known |= {bytes(info.endpoint_gid) for info in infos if _participant(info) in self._participants}
            strangers = any(_participant(info) not in self._participants for info in infos)
            if strangers or recording.matched > len(recording.known) + recording.silent:
                raise LearnerError(
                    f'What came on {recording.topic} is from another program, not from the node that '
                    'your cell defines: publish with that node, in its own process and context. Where your cell makes '
                    'a node to try it out, too, do that in another cell.'
                )

    def _drain(self, number: int, processes: int) -> None:
        """Receive all that was published before the processes' `done`."""
        deadline = time.monotonic() + self.timeouts.discovery
        while self._done.get(number, 0) < processes:
            if time.monotonic() > deadline:
                raise Unheard('Your program was not heard in time: it said that it had reacted, and nothing came.')
            self._spin_once(0.05)
        self._done.pop(number, None)
        self.receive()

    def receive(self, timeout: float = 0.0) -> None:
        """Run callbacks until a whole pass over the test's endpoints finds nothing (each pass ends with a timeout).

        `timeout`: wait so long (seconds of wall time) for the first one.
        """
        found = not timeout or self._spin_once(timeout)
        deadline = time.monotonic() + self.timeouts.discovery
        while found:
            found = False
            while self._spin_once(0):
                found = True
                if time.monotonic() > deadline:
                    raise LearnerError(
                        'Your program publishes without a pause: its messages come faster than they can '
                        "be read. Publish in a timer's callback."
                    )
        self._check_origin()

    def _spin_once(self, timeout: float) -> bool:
        try:
            handler, _, _ = self._own.executor.wait_for_ready_callbacks(timeout_sec=timeout)
        except TimeoutException:
            return False
        handler()
        if handler.exception() is not None:
            raise handler.exception()
        return True

    def _confirm(self) -> None:
        """Wait until the test's reliable messages have arrived, those that late joiners get included."""
        for talker in self._talkers:
            if talker.publisher.qos_profile.reliability != ReliabilityPolicy.BEST_EFFORT:
                talker.publisher.wait_for_all_acked(Duration(seconds=5))

    def _acknowledge(self) -> None:
        """Wait until reliable messages of both sides have arrived, those that late joiners get included."""
        self._confirm()
        for process in self._conducted():
            process.ask('ack', self.timeouts.step, timeout=5.0)
        self.receive()

    @spent.part('discovery')
    def connect(self) -> None:
        """Wait until every endpoint made so far, here and in the learner's processes, is matched.

        Raises WiringError for a wrong type or incompatible QoS.
        """
        if self._connected:
            return
        mark = f'/_{self.token}/mark{next(self._numbers)}'
        publisher = self.node.create_publisher(UInt64, f'{mark}/tests', 1)
        subscription = self.node.create_subscription(UInt64, f'{mark}/tests', lambda message: None, 1)
        processes = self._conducted()
        for process in processes:
            process.ask('mark', self.timeouts.step, mark=mark)
        for process in processes:
            process.ask(
                'sync', self.timeouts.discovery + 5, mark=mark, workers=len(processes), timeout=self.timeouts.discovery
            )
        deadline = time.monotonic() + self.timeouts.discovery
        while not self._known(f'{mark}/worker', len(processes)):
            if time.monotonic() > deadline:
                raise Unheard('The process of your program was not found in time.')
            time.sleep(0.001)  # a bounded poll, as in the worker
        self._meet(f'{mark}', len(processes))
        for process in processes:
            process.ask('unsync', self.timeouts.step)
        self.node.destroy_publisher(publisher)
        self.node.destroy_subscription(subscription)
        self._connected = True
        # Latched messages come only after the match.
        self._acknowledge()
        self._check_wiring()

    def _known(self, topic: str, count: int) -> bool:
        """Whether `count` publishers and subscriptions are there, with the names of their nodes.

        The names come on a way of their own, in order, too: then all earlier endpoints have theirs.
        """
        return all(
            sum(info.node_name != UNKNOWN for info in infos) >= count
            for infos in (
                self.node.get_publishers_info_by_topic(topic),
                self.node.get_subscriptions_info_by_topic(topic),
            )
        )

    def _meet(self, mark: str, processes: int) -> None:
        """Note the participants of the test's node and of the learner's processes."""
        (own,) = self.node.get_publishers_info_by_topic(f'{mark}/tests')[:1]
        theirs = {_participant(info) for info in self.node.get_publishers_info_by_topic(f'{mark}/worker')}
        if len(theirs) > processes:
            raise LearnerError('Another program speaks in the name of yours to the tests.')
        self._participant = _participant(own)
        self._participants |= {self._participant, *theirs}

    def _check_wiring(self) -> None:
        for recording in self._recordings:
            if recording.strict:
                wiring.check(
                    _Ours(recording.subscription),
                    'publisher',
                    self.endpoints(recording.subscription.topic_name).publishers,
                )
        for talker in self._talkers:
            if talker.strict:
                wiring.check(_Ours(talker.publisher), 'subscription', self.endpoints(talker.topic).subscriptions)
        for peer in self._peers:
            peer.check()

    def causes(self) -> list[str]:
        """Mistakes that were noticed in the learner's process: what a failed test says first."""
        return list(self._remarks)

    def hints(self) -> list[str]:
        """What a failed test may add: endpoints of the test's that no node of the learner's is connected with."""
        own = self.own_nodes()
        ends = [
            (recording.subscription.topic_name, 'publisher') for recording in self._recordings if not recording.optional
        ]
        ends += [(talker.topic, 'subscription') for talker in self._talkers if not talker.optional]
        found = []
        for topic, kind in dict.fromkeys(ends):
            there = self.endpoints(topic)
            if not (there.publishers if kind == 'publisher' else there.subscriptions):
                others = wiring.nearby(self.node, topic, kind, own)
                instead = f'; it has one on {others}' if others else ''
                found.append(f'Your program has no {kind} on {topic}{instead}.')
        found += [hint for peer in self._peers for hint in peer.hints()]
        found += [str(one) for one in self._changed()]
        stuck = [line for line in self._waiting if 'sleep' not in line['code']]
        return found + [
            f'A callback of your program was waiting at {line["cell"]}, line {line["line"]}: `{line["code"]}`.'
            for line in stuck[:3]
        ]

    def close(self) -> None:
        """End the learner's processes and the test's node."""
        try:
            for process in self.processes:
                process.stop()
        finally:
            for peer in self._peers:
                peer.close()
            if '_own' in vars(self):
                self._own.executor.shutdown(timeout_sec=1)
                self.node.destroy_node()
                self.context.try_shutdown()


def _participant(info) -> bytes:
    """The DDS participant of an endpoint: the first 12 bytes of its GUID."""
    return bytes(info.endpoint_gid[:12])


class _Ours:
    """Our endpoint with what `wiring.check` asks of it."""

    def __init__(self, endpoint):
        self.msg_type, self.qos_profile = endpoint.msg_type, endpoint.qos_profile


def _yaml(value) -> str:
    if isinstance(value, bool):
        return 'true' if value else 'false'
    if isinstance(value, str):
        return "'" + value.replace("'", "''") + "'"
    if isinstance(value, (list, tuple)):
        return '[' + ', '.join(map(_yaml, value)) + ']'
    return str(value)
