"""Records topics: looks for them, subscribes, and writes what comes."""

import functools
import re
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import timedelta
from typing import Any

from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

from rosbag2_py.definitions import message_class
from rosbag2_py.describe import SERVICE_EVENTS, is_service_event
from rosbag2_py.options import TopicMetadata
from rosbag2_py.qos import to_hear
from rosbag2_py.writer import SequentialWriter


@dataclass
class RecordOptions:
    """
    Which topics to record, and how; names as upstream. Topics are full names; services are the topics of their events.

    Those of the last lines are accepted and count for nothing here: the program itself compresses, and only
    `ros2 bag record` listens to the keyboard.
    """

    all_topics: bool = False
    all_services: bool = False
    topics: list[str] = field(default_factory=list)
    topic_types: list[str] = field(default_factory=list)
    services: list[str] = field(default_factory=list)
    regex: str = ''
    exclude_regex: str = ''
    exclude_topics: list[str] = field(default_factory=list)
    exclude_topic_types: list[str] = field(default_factory=list)
    exclude_service_events: list[str] = field(default_factory=list)
    include_hidden_topics: bool = False
    include_unpublished_topics: bool = False
    ignore_leaf_topics: bool = False
    is_discovery_disabled: bool = False
    topic_polling_interval: timedelta = timedelta(seconds=0.1)
    topic_qos_profile_overrides: dict[str, QoSProfile] = field(default_factory=dict)
    start_paused: bool = False
    use_sim_time: bool = False
    compression_mode: str = ''
    compression_format: str = ''

    rmw_serialization_format: str = ''
    node_prefix: str = ''
    compression_queue_size: int = 1
    compression_threads: int = 0
    compression_threads_priority: int = 0
    disable_keyboard_controls: bool = False


def chosen(options: RecordOptions, name: str, types: list[str]) -> bool:
    """Return whether the options choose a topic, by its name and types."""
    if options.exclude_regex and re.search(options.exclude_regex, name):
        return False
    event = is_service_event(name)
    by_regex = bool(options.regex and re.search(options.regex, name.removesuffix(SERVICE_EVENTS) if event else name))
    if event:
        named = options.all_services or name in options.services or by_regex
        return named and name not in options.exclude_service_events
    if name in options.exclude_topics or set(types) & set(options.exclude_topic_types):
        return False
    if name in options.topics:
        return True
    if topic_or_service_is_hidden(name) and not options.include_hidden_topics:
        return False
    return options.all_topics or bool(set(types) & set(options.topic_types)) or by_regex


class Recording:
    """Writes the messages of the chosen topics; the caller spins the node and calls :meth:`look` now and then."""

    def __init__(self, node: Node, writer: SequentialWriter, options: RecordOptions, fail: Callable[[Exception], None]):
        """
        Begin without a subscription.

        :param fail: called with an error of the writer, such as a full disk, from within a callback.
        """
        self.node, self.writer, self.options = node, writer, options
        self.paused = options.start_paused
        self.subscriptions: dict[str, Any] = {}
        self.written = 0  #: messages
        self._fail = fail
        self._looked = self._flushed = float('-inf')
        self._refused: set[str] = set()
        self._complete = False

    def look(self) -> None:
        """Subscribe to topics that have come, and see to it that what was written is on its way to the disk."""
        now = time.monotonic()
        if now >= self._flushed + 1.0:
            self._flushed = now
            self.writer.flush()
        if self._complete or now < self._looked + self.options.topic_polling_interval.total_seconds():
            return
        self._complete = self.options.is_discovery_disabled
        self._looked = now
        for name, types in self.node.get_topic_names_and_types():
            if name not in self.subscriptions and name not in self._refused and self._wanted(name, types):
                self._subscribe(name, types)
        named = [*self.options.topics, *self.options.services]
        others = self.options.all_topics or self.options.all_services or self.options.regex or self.options.topic_types
        if named and not others and set(named) <= self.subscriptions.keys() and not self._complete:
            self.node.get_logger().info('All requested topics are subscribed. Stopping discovery...')
            self._complete = True

    def _wanted(self, name: str, types: list[str]) -> bool:
        if not chosen(self.options, name, types):
            return False
        if is_service_event(name):
            return True
        if self.options.ignore_leaf_topics and not self.node.count_subscribers(name):
            return False
        return bool(self.options.include_unpublished_topics or self.node.count_publishers(name))

    def _subscribe(self, name: str, types: list[str]) -> None:
        logger = self.node.get_logger()
        if len(types) > 1:
            self._refused.add(name)
            logger.warning(f"Topic '{name}' has several types associated. Only topics with one type are supported")
            return
        try:
            kind = message_class(types[0])
        except RuntimeError as error:
            self._refused.add(name)
            logger.warning(f"Topic '{name}' cannot be recorded: {error}")
            return
        endpoints = self.node.get_publishers_info_by_topic(name)
        offered = [each.qos_profile for each in endpoints]
        known = str(endpoints[0].topic_type_hash) if endpoints else ''
        self.writer.create_topic(
            TopicMetadata(
                len(self.subscriptions), name, types[0], 'cdr', offered, known if known.startswith('RIHS01_') else ''
            )
        )
        profile = self.options.topic_qos_profile_overrides.get(name) or to_hear(offered)
        self.subscriptions[name] = self.node.create_subscription(
            kind, name, functools.partial(self._write, name), profile, raw=True
        )
        logger.info(f"Subscribed to topic '{name}'")

    def _write(self, name: str, data: bytes, info: dict) -> None:
        if self.paused:
            return
        clock = self.node.get_clock()
        # As rosbag2 of Jazzy has it: when the middleware got the message, however late this callback is; in simulated
        # time, the time of the node.
        came = 0 if clock.ros_time_is_active else info['received_timestamp']
        try:
            self.writer.write(name, data, came or clock.now().nanoseconds)
            self.written += 1
        except (RuntimeError, OSError) as error:
            self._fail(error)
