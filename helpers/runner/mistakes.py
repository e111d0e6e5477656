"""Common mistakes in the use of rclpy, recognised in the learner's process, where rclpy itself hangs or says little.

`watch` puts checks around functions of rclpy. What is wrong at the call itself raises TypeError there, so that the
error names the learner's line; a wait inside a callback raises `WaitsInCallback`, as it would never end, or end without
an answer; what may be right is only remembered, to explain an error that follows.
"""

import functools
import inspect
import os
import sys
import threading
import time
import traceback
import weakref
from collections.abc import Callable
from types import FrameType

import rclpy
from rclpy import executors
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.action.client import ClientGoalHandle
from rclpy.client import Client
from rclpy.clock import Clock, ClockType
from rclpy.impl import rcutils_logger
from rclpy.node import Node
from rclpy.task import Future


class WaitsInCallback(BaseException):
    """A callback waits for what only another callback can bring. No `except Exception` of the learner's hides it."""

    def __init__(self, call: str):
        super().__init__(call)
        self.call = call  # 'rclpy.spin_until_future_complete'


# Who keeps the processor for longer than this (s) each time waits in a loop that counts. The right answers' callbacks
# took less than 10 ms and their constructors less than 20 ms, also on a busy machine. Of many runs of a callback, the
# shortest took at most 0.4 ms, which a slow machine may need three times over.
CALLBACK_WORK, CONSTRUCTOR_WORK = 0.02, 0.06
STEADY_WORK, _STEADY = 0.003, 8  # the limit (s) after so many runs
_INSTANT = 0.01  # s: who spins for less has only looked what there is
# Whose callbacks have slept so long (s) in all is known to sleep; no later sleep lasts longer than this, so that nobody
# waits minutes for a check.
_KNOWN, _SHORT = 2.0, 0.02

# They sleep until the graph shows a server.
_POLLING = (Client.wait_for_service.__code__, ActionClient.wait_for_server.__code__)


# So often a line may ask what time it is, in one run of a function, before that is a wait.
_LOOKS = 50


class MistakeWatch:
    """What the checks ask, and what they have seen."""

    def __init__(
        self, in_callback: Callable[[], bool], in_threads: Callable[[], bool], is_learners: Callable[..., bool]
    ):
        """`in_callback()`: a callback of the learner's runs in this thread. `in_threads()`: callbacks run in threads of
        their own. `is_learners(frame)`: the frame is in a cell of the learner's.
        """
        self.in_callback, self.in_threads, self.is_learners = in_callback, in_threads, is_learners
        self.early: tuple[str, int] | None = None  # (file, line) of the last `result()` of a future that was not done
        self.remarks: list[str] = []  # sentences for the learner
        # Seconds for which the learner's lines have slept, also in wait_for_server, asked a clock again and again, or
        # counted.
        self.slept = 0.0
        self.asleep: traceback.StackSummary | None = None  # where a callback first slept, and so the whole node
        self._work: dict[str, tuple[int, float]] = {}  # per callback: its runs, and their least processor time (s)
        self._looks: dict[tuple, tuple[int, float]] = {}  # per line in this callback: how often, and when it first did
        self._aside: set[threading.Thread] = set()
        self._logging = threading.local()  # `.seconds`: the processor time that this thread has needed to write logs
        self._spaces: weakref.WeakKeyDictionary[Node, str] = weakref.WeakKeyDictionary()

    def own_namespace(self, node: Node) -> str:
        """The namespace that the node's constructor was given, which a remapping of `__ns` hides; '' for none."""
        return self._spaces.get(node, '')

    def made(self, node: Node, namespace: str | None) -> None:
        """A node is being made with this argument `namespace`."""
        if namespace and namespace != '/':
            self._spaces[node] = str(namespace)

    def loaded(self) -> None:
        """The cells have run: what they did, and what threads do that they have started, is no part of the answer."""
        self.slept = 0.0
        self._aside = set(threading.enumerate()) - {threading.main_thread()}

    def sleeps(self, frame: FrameType | None, seconds: float) -> None:
        """A line sleeps."""
        if frame and self.is_learners(frame) and threading.current_thread() not in self._aside:
            self.slept += max(0.0, float(seconds))
            if seconds >= _INSTANT and self.asleep is None and self._stops_the_node():
                self.asleep = traceback.extract_stack(frame)

    def shortened(self, frame: FrameType | None, seconds: float) -> float:
        """For how long a line sleeps that wants to sleep so long."""
        known = self.slept - seconds > _KNOWN and frame and self.is_learners(frame) and self._stops_the_node()
        return min(seconds, _SHORT) if known else seconds

    def _stops_the_node(self) -> bool:
        return self.in_callback() and not self.in_threads()

    def begins(self) -> None:
        """A callback or a constructor begins."""
        self._looks.clear()

    def looks(self, frame: FrameType, now: float) -> None:
        """A line asks for the time, which is `now` (s): a loop that does nothing else is a wait."""
        if not self.is_learners(frame):
            return
        line = threading.get_ident(), id(frame), frame.f_lineno
        count, begin = self._looks.get(line, (0, now))
        if count >= _LOOKS:
            self.sleeps(frame, now - begin)
            begin = now
        self._looks[line] = count + 1, begin

    def processor_time(self) -> float:
        """Seconds for which this thread has used the processor, without what rclpy needs to write its log lines.

        For each line rclpy asks `inspect` five times who has called, and in a cell, which is no module, this looks
        through all modules: 3 ms for two lines on a busy machine.
        """
        return time.thread_time() - getattr(self._logging, 'seconds', 0.0)

    def logged(self, seconds: float) -> None:
        """This thread has used the processor so long to write a log line."""
        self._logging.seconds = getattr(self._logging, 'seconds', 0.0) + seconds

    def worked(self, what: str, seconds: float, limit: float, steady: float | None = None) -> None:
        """A callback or a constructor, `what`, has used the processor for so long; longer than `limit` is a wait.

        Its own processor time hardly depends on what else the machine does. The first run may have imported modules.

        :param steady: the limit if it has run often.
        """
        runs, least = self._work.get(what, (0, seconds))
        least = min(least, seconds)
        self._work[what] = runs + 1, least
        if runs and least > (limit if steady is None or runs < _STEADY else steady):
            self.slept += seconds

    def remark(self, sentence: str) -> None:
        """Keep a sentence for the learner, once."""
        if sentence not in self.remarks and len(self.remarks) < 10:
            self.remarks.append(sentence)


def watch(seen: MistakeWatch) -> None:
    """Put the checks around rclpy's functions, in this process."""
    for method in ('create_timer', 'create_subscription', 'create_service', 'create_publisher', 'create_client'):
        setattr(Node, method, _checked(getattr(Node, method), seen))
    for method in (
        'add_on_set_parameters_callback',
        'add_pre_set_parameters_callback',
        'add_post_set_parameters_callback',
    ):
        setattr(Node, method, _checked(getattr(Node, method), seen))
    for name in ('spin', 'spin_once', 'spin_until_future_complete'):
        setattr(rclpy, name, _no_wait(getattr(rclpy, name), f'rclpy.{name}', seen))
    for kind in (executors.Executor, executors.SingleThreadedExecutor, executors.MultiThreadedExecutor):
        for name in ('spin', 'spin_once', 'spin_until_future_complete', 'spin_once_until_future_complete'):
            if name in vars(kind):
                setattr(kind, name, _no_wait(vars(kind)[name], name, seen))
    for owner, name in (
        (Client, 'call'),
        (ActionClient, 'send_goal'),
        (ClientGoalHandle, 'get_result'),
        (ClientGoalHandle, 'cancel_goal'),
    ):
        setattr(owner, name, _no_wait(vars(owner)[name], name, seen, unless=seen.in_threads))
    rcutils_logger.RcutilsLogger.log = _timed(rcutils_logger.RcutilsLogger.log, seen)  # type: ignore[method-assign]
    rcutils_logger._internal_callers.append(os.path.realpath(__file__))  # a line's caller is the learner's cell
    Future.result = _asked_early(Future.result, seen)  # type: ignore[method-assign]  # put around it on purpose
    Future.add_done_callback = _with_function(Future.add_done_callback)  # type: ignore[method-assign]
    time.sleep = _counted(time.sleep, seen)
    for name, unit in (
        ('time', 1.0),
        ('monotonic', 1.0),
        ('perf_counter', 1.0),
        ('monotonic_ns', 1e-9),
        ('time_ns', 1e-9),
    ):
        setattr(time, name, _looked_at(getattr(time, name), unit, seen))
    threading.Condition.wait = _waited(threading.Condition.wait, seen)  # type: ignore[method-assign]
    _watch_nodes(seen)
    _watch_actions(seen)


def _checked(method, seen: MistakeWatch):
    """A method that makes an endpoint or registers a callback, with an error of its own for wrong arguments.

    Only for calls from the learner's cells: rclpy itself makes timers without a callback.
    """
    signature = inspect.signature(method)
    parameters = list(signature.parameters)[1:]
    first_is_type = parameters[0].endswith('_type')

    @functools.wraps(method)
    def checked(self, *args, **kwargs):
        if not seen.is_learners(sys._getframe(1)):
            return method(self, *args, **kwargs)
        try:
            given = signature.bind(self, *args, **kwargs).arguments
        except TypeError:
            return method(self, *args, **kwargs)  # rclpy's own words: an argument is missing or unknown
        if first_is_type and isinstance(given[parameters[0]], str) and inspect.isclass(given.get(parameters[1])):
            name, kind = given[parameters[0]], given[parameters[1]].__name__
            raise TypeError(f'the type comes first, then the name: {method.__name__}({kind}, {name!r}, …)')
        first = given[parameters[0]]
        if first_is_type and hasattr(first, 'get_fields_and_field_types') and not inspect.isclass(first):
            kind = type(first).__name__
            raise TypeError(f'the type is the class itself, without parentheses: {method.__name__}({kind}, …)')
        if 'callback' in given and not callable(given['callback']):
            raise TypeError(_no_function(f'{method.__name__}(…)', given['callback']))
        clock = given.get('clock')
        if isinstance(clock, Clock) and clock.clock_type != ClockType.ROS_TIME:
            seen.remark(
                f'A timer of yours runs on a clock of its own ({clock.clock_type.name}). The tests use simulated time, '
                "which only the node's clock follows, as in a simulator: leave out `clock`."
            )
        return method(self, *args, **kwargs)

    return checked


def _no_function(where: str, given) -> str:
    if given is None:
        return (
            f'the callback given to {where} is None, not a function: give the function itself, without parentheses '
            '(self.on_timer, not self.on_timer())'
        )
    return f'the callback given to {where} is an object of type {type(given).__name__}, not a function'


def _no_wait(function, name: str, seen: MistakeWatch, unless: Callable[[], bool] = lambda: False):
    """A function that waits, refused in a callback, where nothing can come while it waits; elsewhere it is counted."""
    clock = time.monotonic  # itself: a look of ours is none of the learner's

    @functools.wraps(function)
    def refusing(*args, **kwargs):
        if seen.in_callback() and not unless():
            raise WaitsInCallback(name)
        begin, frame = clock(), sys._getframe(1)
        try:
            return function(*args, **kwargs)
        finally:
            if clock() - begin > _INSTANT and not seen.in_threads():
                seen.sleeps(frame, clock() - begin)

    return refusing


def _with_function(add_done_callback):
    """`Future.add_done_callback`, which raises TypeError at once for what cannot be called; rclpy only later."""

    @functools.wraps(add_done_callback)
    def checked(self, callback):
        if callback is None:
            raise TypeError(
                'the callback given to add_done_callback(…) is None, not a function: give the function itself, as in '
                'add_done_callback(lambda future: …), which is called later'
            )
        if not callable(callback):
            raise TypeError(_no_function('add_done_callback(…)', callback))
        return add_done_callback(self, callback)

    return checked


def _asked_early(result, seen: MistakeWatch):
    """`Future.result`, which gives None as long as there is no answer."""

    @functools.wraps(result)
    def asked(self):
        if not self.done():
            frame = sys._getframe(1)
            if seen.is_learners(frame):
                seen.early = (frame.f_code.co_filename, frame.f_lineno)
        return result(self)

    return asked


def _timed(log, seen: MistakeWatch):
    """`RcutilsLogger.log`, whose processor time is none of the callback's."""

    @functools.wraps(log)
    def logging(*args, **kwargs):
        begin = time.thread_time()
        try:
            return log(*args, **kwargs)
        finally:
            seen.logged(time.thread_time() - begin)

    return logging


def _counted(sleep, seen: MistakeWatch):
    """`time.sleep` that adds up how long the learner's lines sleep, themselves or while they wait for a server.

    The count is the same on a busy machine.
    """

    @functools.wraps(sleep)
    def sleeping(seconds):
        caller: FrameType | None = sys._getframe(1)
        if caller and caller.f_code in _POLLING:
            caller = caller.f_back
        seen.sleeps(caller, seconds)
        return sleep(seen.shortened(caller, seconds))

    return sleeping


def _looked_at(clock, unit: float, seen: MistakeWatch):
    """A clock of Python's that notes which of the learner's lines ask it; `unit`: seconds in 1."""

    @functools.wraps(clock)
    def asked():
        now = clock()
        seen.looks(sys._getframe(1), now * unit)
        return now

    return asked


def _waited(wait, seen: MistakeWatch):
    """`Condition.wait`, and so Event.wait and Queue.get, that adds up for how long the learner's callbacks wait there.

    Where callbacks run in threads they may.
    """

    @functools.wraps(wait)
    def waiting(self, timeout=None):
        caller: FrameType | None = sys._getframe(1)
        while caller and caller.f_globals.get('__name__') in ('threading', 'queue'):
            caller = caller.f_back
        if timeout and seen.in_callback() and not seen.in_threads():
            seen.sleeps(caller, timeout)
        return wait(self, timeout)

    return waiting


def _watch_nodes(seen: MistakeWatch) -> None:
    """Remember which namespace each node is given where it is made; refuse a class that could never be a node."""
    create = Node.__init__
    signature = inspect.signature(create)

    @functools.wraps(create)
    def __init__(self, *args, **kwargs):
        _check_names(type(self))
        create(self, *args, **kwargs)
        seen.made(self, signature.bind(self, *args, **kwargs).arguments.get('namespace'))

    Node.__init__ = __init__  # type: ignore[method-assign]  # put around it on purpose


def _check_names(kind: type) -> None:
    """Raise AttributeError if a class has a method, or another value, in the place of a property that Node needs.

    Without this, rclpy fails later and elsewhere: "'method' object does not support the context manager protocol".
    """
    for each in kind.__mro__:
        if each is Node:
            return
        for name, value in vars(each).items():
            needed = getattr(Node, name, None)
            fixed = isinstance(needed, property) and (needed.fset is None or name == 'handle')  # whose setter refuses
            if fixed and not isinstance(value, property):
                raise AttributeError(f'class {each.__name__!r} hides the property {name!r} of Node')


def _watch_actions(seen: MistakeWatch) -> None:
    """Remember what makes rclpy reject: a goal or cancel callback without a right answer, or no cancel callback."""
    create = ActionServer.__init__
    answers = {'goal_callback': GoalResponse, 'cancel_callback': CancelResponse}
    signature = inspect.signature(create)

    @functools.wraps(create)
    def __init__(self, *args, **kwargs):
        try:
            given = signature.bind(self, *args, **kwargs).arguments
        except TypeError:
            return create(self, *args, **kwargs)
        _type_first('ActionServer', given)
        if not callable(given['execute_callback']):
            raise TypeError(_no_function('ActionServer(…)', given['execute_callback']))
        for name, kind in answers.items():
            if callable(given.get(name)):
                given[name] = _answering(given[name], name, kind, seen)
        given.setdefault('cancel_callback', _refusing(seen))
        if isinstance(given.get('result_timeout'), int | float):
            # rcl lets a result go only after its time. It would look again without end if time stood at this moment.
            given['result_timeout'] += 1e-6
        bound = inspect.BoundArguments(signature, given)
        return create(*bound.args, **bound.kwargs)

    ActionServer.__init__ = __init__  # type: ignore[method-assign]  # put around it on purpose
    create_client = ActionClient.__init__
    of_client = inspect.signature(create_client)

    @functools.wraps(create_client)
    def made(self, *args, **kwargs):
        try:
            given = of_client.bind(self, *args, **kwargs).arguments
        except TypeError:
            return create_client(self, *args, **kwargs)
        _type_first('ActionClient', given)
        return create_client(self, *args, **kwargs)

    ActionClient.__init__ = made  # type: ignore[method-assign]  # put around it on purpose


def _type_first(what: str, given: dict) -> None:
    """Raise TypeError if type and name of an action stand in the wrong order."""
    kind, name = given['action_type'], given['action_name']
    if isinstance(kind, str) and inspect.isclass(name):
        raise TypeError(f'the type comes first, then the name: {what}(self, {name.__name__}, {kind!r}, …)')


def _refusing(seen: MistakeWatch):
    """What an action server does that has no cancel callback, and why."""

    def refuse(request):
        seen.remark(
            'Your action server rejected a cancel request, as every one without a cancel_callback does: '
            'ActionServer(…, cancel_callback=…), which returns CancelResponse.ACCEPT.'
        )
        return CancelResponse.REJECT

    return refuse


def _answering(callback, name: str, kind, seen: MistakeWatch):
    def judged(answer):
        if not isinstance(answer, kind):
            seen.remark(
                f'Your {name} returned {answer!r:.40}. It must return {kind.__name__}.ACCEPT or '
                f'{kind.__name__}.REJECT; anything else counts as REJECT.'
            )
        return answer

    if inspect.iscoroutinefunction(callback):

        async def awaited(request):
            return judged(await callback(request))

        return awaited

    def asked(request):
        answer = callback(request)
        return answer if inspect.isawaitable(answer) else judged(answer)

    return asked
