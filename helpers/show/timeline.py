"""Which thread runs which callback when: recording for the timeline chart (drawn by `helpers.show.timeline_chart`).

While nobody records, nothing is wrapped and nothing is kept.
"""

import functools
import itertools
import threading
import time
from dataclasses import dataclass, field

from helpers.kernel import executors

_POLL = 0.0005  # s; in a shorter run an unfinished coroutine has only checked whether its future is done
_HIDDEN = ('/clock', '/parameter_events', '/rosout')
_recording: list['Timeline'] = []


@dataclass
class Callback:
    """One run of a callback. Times are seconds since the start of the recording; `end` is None if it never ended."""

    node: str
    name: str
    thread: int  # ident
    start: float
    end: float | None = None
    parts: list = field(default_factory=list)  # (start, end) in which it really ran; between them it awaited something

    @property
    def awaited(self) -> bool:
        """Whether it let others run while it awaited something."""
        return len(self.parts) > 1 or (self.end is None and self.parts[-1][1] is not None)


@dataclass
class Message:
    """One message on its way out of or into a node: `kind` is publish, receive, request, take, respond or answer.

    ``take`` is a server that takes a request, ``answer`` a client that gets the response. What belongs to one service
    call has the same number in `call`.
    """

    kind: str
    name: str  # of the topic or service
    node: str
    thread: int
    time: float
    call: int | None = None

    @property
    def sent(self) -> bool:
        """Whether it goes out."""
        return self.kind in ('publish', 'request', 'respond')


def timeline() -> 'Timeline':
    """Record callbacks and messages of all nodes that spin, and show them as a chart.

    ::

        with timeline() as chart:
            with spinning(server, client):
                wait_for(lambda: client.done)
        chart

    It sees callbacks that `spinning` and `spin_for` run, and messages of the whole kernel. Each thread is a lane, each
    callback a bar, each message a mark.
    """
    return Timeline()


class Timeline:
    """A recording; made by `timeline`, shown as the value of a cell."""

    def __init__(self):
        self.callbacks: list[Callback] = []
        self.messages: list[Message] = []
        self.threads: dict[int, str] = {}  #: ident -> name of its lane, in the order of their first events
        self.end = 0.0  #: length of the recording in seconds
        self._begun: float | None = None
        self._open: dict[int, tuple] = {}  # id of a task that is not done -> (task, Callback)
        self._working: set[int] = set()  # ids of the works that run a callback now
        self._calls: list[_ServiceCall] = []
        self._responses: list[tuple] = []  # (header, take or None, respond, response): matched with calls at the end
        self._numbers = itertools.count(1)
        self._lock = threading.Lock()

    def __enter__(self) -> 'Timeline':
        self._begun = time.monotonic()
        with _installing:
            if not _recording:
                _install()
            _recording.append(self)
        return self

    def __exit__(self, kind, error, tb) -> None:
        with _installing:
            _recording.remove(self)
            if not _recording:
                _uninstall()
        self.end = self._now()
        self._open.clear()
        self._match()

    def __repr__(self) -> str:
        from helpers.show import timeline_chart

        return timeline_chart.text(self)

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict:
        from helpers.show import timeline_chart

        return {'text/html': timeline_chart.html(self), 'text/plain': repr(self)}

    def _now(self) -> float:
        return time.monotonic() - self._begun

    def _lane(self) -> int:
        thread = threading.get_ident()
        if thread not in self.threads:
            with self._lock:
                main = thread == threading.main_thread().ident
                number = sum(name != 'notebook' for name in self.threads.values()) + 1
                self.threads[thread] = 'notebook' if main else f'thread {number}'
        return thread

    # What the executors tell (see `helpers.kernel.executors.observers`)

    def begin(self, work) -> None:
        """A callback begins, or a coroutine goes on."""
        now, thread, kind = self._now(), self._lane(), type(work.entity).__name__
        if kind == 'Client' or _is_hidden(work):
            return
        known = self._open.get(id(work.task))
        if not _runs(work, resumed=known is not None):
            return
        self._working.add(id(work))
        if known:
            known[1].parts.append([now, None])
            return
        node = _node_name(work)
        callback = Callback(node, _label(work), thread, now, parts=[[now, None]])
        self._open[id(work.task)] = work.task, callback
        self.callbacks.append(callback)
        if kind in ('Subscription', 'Service'):
            name = work.entity.topic_name if kind == 'Subscription' else work.entity.service_name
            self.messages.append(Message('receive' if kind == 'Subscription' else 'take', name, node, thread, now))
            if kind == 'Service':
                callback.take = self.messages[-1]

    def finish(self, work) -> None:
        """A callback has returned, or a coroutine awaits something."""
        now = self._now()
        if type(work.entity).__name__ == 'Client':
            self._answered(work, now)
            return
        known = self._open.get(id(work.task))
        if known is None or id(work) not in self._working:
            return
        self._working.discard(id(work))
        callback = known[1]
        callback.parts[-1][1] = now
        if work.task.done() or work.task.cancelled():
            callback.end = now
            del self._open[id(work.task)]
        elif len(callback.parts) > 1 and now - callback.parts[-1][0] < _POLL:
            callback.parts.pop()

    # What publishers, clients and services tell

    def published(self, publisher) -> None:
        """A message goes out."""
        if publisher.topic_name not in _HIDDEN:
            self.messages.append(Message('publish', publisher.topic_name, self._node_here(), self._lane(), self._now()))

    def requested(self, client, sent: float) -> '_ServiceCall':
        """A client sends a request at the monotonic time `sent`."""
        request = Message(
            'request', client.service_name, self._node_here(), self._lane(), sent - self._begun, next(self._numbers)
        )
        self.messages.append(request)
        self._calls.append(_ServiceCall(client, request))
        return self._calls[-1]

    def responded(self, service, response, header) -> None:
        """A service sends a response: now it is known which request its callback has taken."""
        work = executors.running_here()
        message = Message('respond', service.service_name, self._node_here(), self._lane(), self._now())
        self.messages.append(message)
        known = self._open.get(id(work.task)) if work else None
        self._responses.append((header, getattr(known[1], 'take', None) if known else None, message, response))

    def _match(self) -> None:
        """Find out which responses belong to which requests. Where that is not certain, a response stays unmatched."""
        writers: dict[bytes, object] = {}  # DDS writer of requests -> client
        for header, take, respond, response in self._responses:
            request_id = getattr(header, 'request_id', header)
            writer = bytes(request_id.writer_guid) if hasattr(request_id, 'writer_guid') else None
            fitting = [
                call
                for call in self._calls
                if call.number == request_id.sequence_number
                and not call.taken
                and call.request.name == respond.name
                and call.request.time <= (take or respond).time
            ]
            known = writers.get(writer)
            fitting = (
                [call for call in fitting if call.client is known]
                if known
                else [call for call in fitting if call.client not in writers.values()]
            )
            if len(fitting) > 1:  # clients number their requests alike: it is not known which one got this answer
                fitting = [call for call in fitting if call.future.done() and call.future.result() == response]
            if len(fitting) != 1:
                continue
            (call,) = fitting
            call.taken = True
            if writer:
                writers[writer] = call.client
            for message in (take, respond):
                if message:
                    message.call = call.request.call
        self._responses.clear()
        self._calls.clear()

    def _answered(self, work, now: float) -> None:
        for call in self._calls:
            if call.client is work.entity and call.future and call.future.done() and not call.answered:
                call.answered = True
                self.messages.append(
                    Message('answer', call.request.name, _node_name(work), self._lane(), now, call.request.call)
                )

    def _node_here(self) -> str:
        work = executors.running_here()
        return _node_name(work) if work else ''


@dataclass
class _ServiceCall:
    client: object
    request: Message
    future: object = None
    number: int | None = None  # of the request, as its client counts
    taken: bool = False
    answered: bool = False


_installing = threading.Lock()
_plain: dict = {}


def _install() -> None:
    """Wrap what sends, and listen to the executors."""
    from rclpy.client import Client
    from rclpy.publisher import Publisher
    from rclpy.service import Service

    _plain.update(
        {
            (Publisher, 'publish'): Publisher.publish,
            (Client, 'call_async'): Client.call_async,
            (Service, 'send_response'): Service.send_response,
        }
    )

    def publish(plain, self, *args):
        for recorder in _recording:
            recorder.published(self)
        return plain(self, *args)

    def call_async(plain, self, request):
        sent = time.monotonic()
        calls = [recorder.requested(self, sent) for recorder in _recording]
        future = plain(self, request)
        for call in calls:
            call.future = future
            call.number = next((key for key, its in self._pending_requests.copy().items() if its is future), None)
        return future

    def send_response(plain, self, response, header):
        for recorder in _recording:
            recorder.responded(self, response, header)
        return plain(self, response, header)

    for (owner, name), wrapper in zip(_plain, (publish, call_async, send_response), strict=True):
        plain = _plain[owner, name]
        setattr(owner, name, functools.wraps(plain)(_bind(wrapper, plain)))
    executors.observers.append(_tell)


def _bind(wrapper, plain):
    return lambda self, *args, **kwargs: wrapper(plain, self, *args, **kwargs)


def _uninstall() -> None:
    executors.observers.remove(_tell)
    for (owner, name), plain in _plain.items():
        setattr(owner, name, plain)
    _plain.clear()


def _tell(event: str, work) -> None:
    for recorder in _recording.copy():
        getattr(recorder, event)(work)


def _runs(work, resumed: bool) -> bool:
    """Tell whether a work will run its callback. A MultiThreadedExecutor hands some out twice, or too early."""
    group = getattr(work.entity, 'callback_group', None)
    return (
        not work.task.done()
        and not work.task.executing()
        and (resumed or group is None or group.can_execute(work.entity))
    )


def _is_hidden(work) -> bool:
    """Tell whether a callback belongs to rclpy itself."""
    kind = type(work.entity).__name__
    if kind in ('EventHandler', 'GuardCondition') or getattr(work.entity, 'topic_name', '') in _HIDDEN:
        return True
    if work.entity is not None:
        return False
    return (getattr(_function(work), '__module__', None) or '').startswith('rclpy')


def _function(work):
    """The learner's function of a callback; of a task (a done-callback, the execution of a goal), what it runs."""
    function = getattr(work.entity, 'callback', None) if work.entity else getattr(work.task, '_handler', None)
    frame = getattr(function, 'cr_frame', None)
    if frame is not None:  # rclpy wraps a goal's execute callback into a coroutine of its own
        function = frame.f_locals.get('execute_callback', function)
    return getattr(function, 'func', function)


def _label(work) -> str:
    name = getattr(_function(work), '__name__', '')
    kinds = {
        'Timer': 'timer',
        'Subscription': 'message',
        'Service': 'request',
        'NoneType': 'done-callback',
        'ActionServer': 'action server',
        'ActionClient': 'action client',
    }
    return name if name and name != '<lambda>' else kinds.get(type(work.entity).__name__, 'callback')


def _node_name(work) -> str:
    from rclpy.node import Node

    owner = getattr(_function(work), '__self__', None)
    node = work.node if work.node is not None else owner
    return node.get_name() if isinstance(node, Node) else ''
