"""Plays a bag: publishes its messages at the pace at which they were recorded."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from rclpy.duration import Duration
from rclpy.expand_topic_name import expand_topic_name
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.time import Time

from rosbag2_py.definitions import message_class, service_class
from rosbag2_py.describe import SERVICE_EVENTS, is_service_event
from rosbag2_py.merged import MergedReader
from rosbag2_py.options import StorageFilter, TopicMetadata
from rosbag2_py.qos import to_publish
from rosbag2_py.reader import SequentialReader
from rosbag2_py.service_requests import ServiceRequests

_SECOND = 1_000_000_000
_STEP = 0.05  # seconds after which a wait looks at the keyboard
RATE_STEP = 0.1


class ServiceRequestsSource(Enum):
    """Whose recorded requests to send: as services received them, or as clients sent them."""

    SERVICE_INTROSPECTION = 0
    CLIENT_INTROSPECTION = 1


@dataclass
class PlayOptions:
    """
    How to play; names as upstream. Times in seconds, `-1` for "to the end"; services are the topics of their events.

    Those of the last lines are accepted and count for nothing here: a message is read when it is due, and only
    `ros2 bag play` listens to the keyboard.
    """

    rate: float = 1.0
    topics_to_filter: list[str] = field(default_factory=list)
    services_to_filter: list[str] = field(default_factory=list)
    regex_to_filter: str = ''
    exclude_topics_to_filter: list[str] = field(default_factory=list)
    exclude_service_events_to_filter: list[str] = field(default_factory=list)
    exclude_regex_to_filter: str = ''
    topic_qos_profile_overrides: dict[str, QoSProfile] = field(default_factory=dict)
    loop: bool = False
    topic_remapping_options: list[str] = field(default_factory=list)  # old:=new, also behind --ros-args --remap
    clock_publish_frequency: float = 0.0
    clock_publish_on_topic_publish: bool = False
    clock_topics: list[str] = field(default_factory=list)  # of these topics only; otherwise of all
    delay: float = 0.0
    start_paused: bool = False
    start_offset: float = 0.0
    playback_duration: float = -1.0
    playback_until_timestamp: int = -1  # nanoseconds since 1970
    wait_acked_timeout: int = -1  # milliseconds; 0: for ever
    publish_service_requests: bool = False  # and not the events
    service_requests_source: ServiceRequestsSource | str = ServiceRequestsSource.SERVICE_INTROSPECTION  # or its name

    node_prefix: str = ''
    read_ahead_queue_size: int = 1000
    disable_keyboard_controls: bool = False
    disable_loan_message: bool = False


class Playback:
    """Publishes the messages of a bag with a node of the caller's, who spins it by way of `wait`."""

    def __init__(
        self, node: Node, reader: SequentialReader | MergedReader, options: PlayOptions, wait: Callable[[float], Any]
    ):
        """
        Create the publishers.

        :param wait: spins the node for so many seconds, and handles the keyboard.
        :raises ValueError: if a remapping is none.
        """
        self.node, self.reader, self.options, self.rate = node, reader, options, options.rate
        self.paused, self.skip = options.start_paused, False
        self._wait = wait
        metadata = reader.get_metadata()
        begin = metadata.starting_time.nanoseconds
        self.published = 0  #: messages, so far
        self._sought = False
        self._start = begin + round(options.start_offset * _SECOND)
        self._end = begin + metadata.duration.nanoseconds
        if options.playback_duration >= 0:
            self._end = min(self._end, self._start + round(options.playback_duration * _SECOND))
        if options.playback_until_timestamp >= 0:
            self._end = min(self._end, options.playback_until_timestamp)
        self.start, self.duration = self._start, self._end - self._start  #: nanoseconds
        self._now, self._since = self._start, time.monotonic()  # the bag's time, and when it was that
        self._clock: Any = None
        self._next_clock = 0.0
        if options.clock_publish_frequency or options.clock_publish_on_topic_publish:
            from rosgraph_msgs.msg import Clock

            self._clock = node.create_publisher(Clock, '/clock', 10)
        self._remappings = parse_remappings(options.topic_remapping_options, node)
        reader.set_filter(
            StorageFilter(
                topics=[*options.topics_to_filter, *options.services_to_filter],
                regex=options.regex_to_filter,
                exclude_topics=[*options.exclude_topics_to_filter, *options.exclude_service_events_to_filter],
                regex_to_exclude=options.exclude_regex_to_filter,
            )
        )
        self.publishers: dict[str, Any] = {}
        self._create_publishers()

    def _create_publishers(self) -> None:
        for topic in self.reader.get_all_topics_and_types():
            name = topic.name
            if not self.reader.passes(name):
                continue
            try:
                self.publishers[name] = self._publisher(topic)
            except RuntimeError as error:
                self.node.get_logger().warning(f"Ignoring a topic '{name}', reason: {error}")

    def _publisher(self, topic: TopicMetadata) -> Any:
        """Return what the messages of a topic go to; RuntimeError if the type is not installed."""
        name, options = topic.name, self.options
        if options.publish_service_requests and is_service_event(name):
            service = name.removesuffix(SERVICE_EVENTS)
            kind = service_class(topic.type)
            source = options.service_requests_source
            name_of_source = source if isinstance(source, str) else source.name.lower()
            return ServiceRequests(self.node, kind, service, name_of_source, self._wait)
        profile = options.topic_qos_profile_overrides.get(name) or to_publish(topic.offered_qos_profiles)
        return self.node.create_publisher(message_class(topic.type), self._remappings.get(name, name), profile)

    def play(self) -> int:
        """Play to the end, again and again with `loop`; returns how many messages were published."""
        published = 0
        while True:
            if self.options.delay:
                self.node.get_logger().info(f'Sleep {round(self.options.delay * _SECOND)} ns')
                self._wait(self.options.delay)
            published += self._play_once()
            if not self.options.loop:
                break
        self._deliver()
        return published

    def burst(self, number: int) -> int:
        """Publish so many messages at once, all of them with 0; returns how many there were."""
        published = 0
        self.reader.seek(self._start)
        self._set_time(self._start)
        while not number or published < number:
            message = self._next()
            if message is None:
                break
            self._wait(0.0)  # Ctrl+C counts
            self._set_time(message[2])
            published += self._publish(*message)
        self._deliver()
        return published

    def play_rest(self) -> int:
        """Play what a burst has left, from where it ended; returns how many messages were published."""
        published = self._play_on()
        self._deliver()
        return published

    def _play_once(self) -> int:
        self.reader.seek(self._start)
        self._set_time(self._start)
        return self._play_on()

    def _play_on(self) -> int:
        before = self.published
        while (message := self._next()) is not None:
            if self._wait_until(message[0], message[2]):
                self._publish(*message)
        return self.published - before

    def _next(self) -> tuple[str, bytes, int] | None:
        """Return the next message up to the end, if there is one."""
        if not self.reader.has_next():
            return None
        message = self.reader.read_next()
        return message if message[2] <= self._end else None

    def _publish(self, topic: str, data: bytes, timestamp: int) -> int:
        """Publish a message; return how many were published: 0 or 1."""
        if topic not in self.publishers:
            return 0
        if self.options.clock_publish_on_topic_publish and topic in (self.options.clock_topics or (topic,)):
            self._publish_clock(timestamp)  # before the message, which is about this time
        self.publishers[topic].publish(data)
        self.published += 1
        return 1

    def time(self) -> int:
        """Return the bag's time, in nanoseconds."""
        if self.paused:
            return self._now
        return self._now + round((time.monotonic() - self._since) * self.rate * _SECOND)

    def _set_time(self, now: int) -> None:
        self._now, self._since = now, time.monotonic()

    def pause(self, paused: bool) -> None:
        """Stop the bag's time, or let it go on."""
        self._set_time(self.time())
        self.paused = paused

    def seek(self, timestamp: int) -> None:
        """Go on with the first message at or after a time in nanoseconds; what is waited for is not played."""
        timestamp = max(timestamp, self._start)
        self.reader.seek(timestamp)
        self._set_time(timestamp)
        self._sought = True

    def set_rate(self, rate: float) -> None:
        """Play at another pace from now on."""
        self._set_time(self.time())
        self.rate = rate

    def _wait_until(self, topic: str, timestamp: int) -> bool:
        """Wait until a message is due; return False if it is not to be played, because of :meth:`seek`."""
        self._sought = False
        self._wait(0.0)  # keys and Ctrl+C count also while everything is overdue
        while not self._sought:
            now = self.time()
            self._tell_time(now)
            if self.skip:  # play the next message although it is not due
                self.skip = topic not in self.publishers  # then the message after it
                self._set_time(timestamp)
                return True
            missing = (timestamp - now) / _SECOND / self.rate
            if not self.paused and missing <= 0:
                return True
            longest = _STEP if self.paused else min(_STEP, missing)
            if self.options.clock_publish_frequency:
                longest = min(longest, max(0.0, self._next_clock - time.monotonic()))
            self._wait(longest)
        return False

    def _tell_time(self, now: int) -> None:
        """Publish /clock, as often as asked."""
        if not self.options.clock_publish_frequency or time.monotonic() < self._next_clock:
            return
        self._next_clock = time.monotonic() + 1.0 / self.options.clock_publish_frequency
        self._publish_clock(now)

    def _publish_clock(self, now: int) -> None:
        from rosgraph_msgs.msg import Clock

        self._clock.publish(Clock(clock=Time(nanoseconds=now).to_msg()))

    def _deliver(self) -> None:
        """Wait until reliable readers have everything: a second, or what the options say."""
        timeout = self.options.wait_acked_timeout
        duration = Duration(seconds=1.0 if timeout < 0 else 2**31 if timeout == 0 else timeout / 1000)
        for publisher in self.publishers.values():
            try:
                publisher.wait_for_all_acked(duration)
            except Exception:  # not every middleware can
                pass


def parse_remappings(rules: list[str], node: Node) -> dict[str, str]:
    """
    Return the new names by the old ones, both full, of rules `old:=new`; what makes them ROS arguments is left out.

    :raises ValueError: if a rule is none.
    """
    remappings = {}
    for rule in rules:
        if rule in ('--ros-args', '--remap', '-r'):
            continue
        old, separator, new = rule.partition(':=')
        if not (old and separator and new):
            raise ValueError(f"'{rule}' is no remapping; expected old_topic:=new_topic")
        full = [expand_topic_name(each, node.get_name(), node.get_namespace()) for each in (old, new)]
        remappings[full[0]] = full[1]
    return remappings
