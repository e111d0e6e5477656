"""What a learner's process changes in rclpy: simulated time from the first moment, and notes on what happens in it."""

import functools
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Any

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.client import Client
from rclpy.clock import ClockType
from rclpy.exceptions import InvalidHandle
from rclpy.executors import await_or_execute
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from rclpy.time_source import CLOCK_TOPIC, TimeSource
from rosgraph_msgs.msg import Clock


class SimulatedTimeSource(TimeSource):
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


def watch_actions(note: Callable[[Exception], Any], hold: Callable[[Callable[[], None]], Any]) -> None:
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


class Outgoing:
    """On which topics this process has ever had a publisher, and whether it has ever had a client."""

    def __init__(self) -> None:
        self.topics: set[str] = set()
        self.clients = False

    def watch(self) -> None:
        """Note each publisher and each client that is made from now on."""
        for kind, note in (Publisher, self._publisher), (Client, self._client), (ActionClient, self._client):
            kind.__init__ = _followed_by(note, kind.__init__)  # type: ignore[method-assign,misc]  # put around it

    def _publisher(self, publisher: Publisher) -> None:
        self.topics.add(publisher.topic_name)

    def _client(self, client: Client | ActionClient) -> None:
        self.clients = True

    def reaches(self, nodes: list[Node]) -> bool:
        """Whether something that this process sends can arrive at one of its nodes."""
        topics = set()
        for subscription in (each for node in nodes for each in node.subscriptions):
            with suppress(InvalidHandle):  # one that was destroyed, but not by its node, is still in the node's list
                topics.add(subscription.topic_name)
        return self.clients or not self.topics.isdisjoint(topics) or any('/_action/' in topic for topic in topics)


@contextmanager
def on_trial(nodes: list[Node]) -> Iterator[None]:
    """Keep back what is published meanwhile: tests would hear a cell that tries its answer while it is loaded.

    :param nodes: is given the nodes that are made meanwhile.
    """
    plain, made = Publisher.publish, Node.__init__
    Publisher.publish = lambda publisher, msg: None  # type: ignore[method-assign,assignment]  # of all publishers
    Node.__init__ = _followed_by(nodes.append, made)  # type: ignore[method-assign]  # put around it
    try:
        yield
    finally:
        Publisher.publish = plain  # type: ignore[method-assign]
        Node.__init__ = made  # type: ignore[method-assign]


def _followed_by(note: Callable[[Any], Any], init: Callable):
    """The constructor `init`, after which `note` is called with what has been made."""

    @functools.wraps(init)
    def made(self, *args, **kwargs):
        init(self, *args, **kwargs)
        note(self)

    return made


@contextmanager
def arguments_of_nodes(ros_args: list) -> Iterator[None]:
    """Give the nodes that are made meanwhile parameters and remappings of their own, which win over the process's."""
    plain = Node.__init__

    @functools.wraps(plain)
    def init(self, *args, cli_args=None, **kwargs):
        plain(self, *args, cli_args=[*(cli_args or []), '--ros-args', *ros_args], **kwargs)

    Node.__init__ = init  # type: ignore[method-assign]  # put around it on purpose
    try:
        yield
    finally:
        Node.__init__ = plain  # type: ignore[method-assign]


def for_other_contexts(function):
    """`rclpy.init` or its like without any effect on the default context, which is the worker's."""

    @functools.wraps(function)
    def wrapped(*args, context=None, **kwargs):
        if context is not None and context is not rclpy.get_default_context():
            function(*args, context=context, **kwargs)

    return wrapped
