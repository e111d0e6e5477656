"""Reads bags."""

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from rclpy.duration import Duration
from rclpy.time import Time
from rosbags.interfaces import Connection
from rosbags.rosbag2 import Reader, ReaderError

from rosbag2_py import metadata as metadata_file
from rosbag2_py.compression import decompress
from rosbag2_py.definitions import type_hash
from rosbag2_py.files import SUFFIXES
from rosbag2_py.metadata import BagError
from rosbag2_py.options import (
    BagMetadata,
    ConverterOptions,
    FileInformation,
    ReadOrder,
    ReadOrderSortBy,
    StorageFilter,
    StorageOptions,
    TopicInformation,
    TopicMetadata,
)
from rosbag2_py.qos import to_rclpy

_SECOND = 1_000_000_000


class SequentialReader:
    """
    Reads the messages of a bag, a folder or a single .mcap or .db3 file, in the order of their time.

    What is compressed is decompressed: messages one by one, files into a temporary folder.
    """

    def __init__(self) -> None:
        """Begin without a bag."""
        self._reader: Reader | None = None

    def open(self, storage_options: StorageOptions, converter_options: ConverterOptions | None = None) -> None:
        """
        Open a bag.

        :raises BagError: if there is none, or it cannot be read; the text says what to do.
        """
        self.close()
        self._path = Path(storage_options.uri)
        self._reader = open_reader(self._path)
        self._filter, self._order = StorageFilter(), ReadOrder()
        self.seek(0)

    def open_uri(self, uri: str) -> None:
        """Open the bag of a path."""
        self.open(StorageOptions(uri))

    def close(self) -> None:
        """Close the bag."""
        if self._reader is not None:
            self._reader.close()
            self._reader = None

    def has_next(self) -> bool:
        """
        Return whether there is another message.

        :raises BagError: if no bag is open.
        """
        self._open()
        if self._next is None:
            self._next = next(self._messages, None)
        return self._next is not None

    def read_next(self) -> tuple[str, bytes, int]:
        """
        Return the next message: topic, serialized message, time of its reception in nanoseconds.

        :raises BagError: if there is none.
        """
        if not self.has_next():
            raise BagError('Bag is at end. No next message.')
        connection, timestamp, data = self._next
        self._next = None
        if self._last is None or self._last[0] != timestamp:
            self._read.clear()
        self._read[connection.topic] += 1
        self._last = (timestamp, connection.topic)
        return connection.topic, decompress(bytes(data)), timestamp

    def seek(self, timestamp: int) -> None:
        """Go on with the first message at or after a time in nanoseconds; backwards: at or before it."""
        self._start = timestamp
        self._last: tuple[int, str] | None = None  # time and topic of what was read last
        self._read: Counter = Counter()  # how many messages of that time, for each topic
        self._next: tuple[Connection, int, bytes] | None = None
        self._messages: Iterator = self._from(timestamp)

    def set_filter(self, storage_filter: StorageFilter) -> None:
        """Read only what the filter lets through, from here on."""
        self._filter = storage_filter
        if self._last is None:
            self.seek(self._start)
        else:
            self._next = None
            self._messages = self._behind(*self._last, self._read[self._last[1]])

    def _from(self, timestamp: int) -> Iterator:
        """Return the messages that the filter lets through, from a time on."""
        chosen = [each for each in self._open().connections if self.passes(each.topic)]
        if not chosen:
            return iter(())
        return self._backwards(chosen, timestamp) if self._order.reverse else self._open().messages(chosen, timestamp)

    def _backwards(self, chosen: list[Connection], timestamp: int) -> Iterator:
        """Yield the messages up to a time, the last one first; the library reads forwards, so second by second."""
        reader = self._open()
        begin, end, width = reader.start_time, min(timestamp + 1, reader.end_time), _SECOND
        while end > begin:
            found = list(reader.messages(chosen, max(begin, end - width), end))
            yield from reversed(found)
            end -= width
            width = _SECOND if found else 2 * width  # a long pause costs few looks

    def _behind(self, timestamp: int, topic: str, number: int) -> Iterator:
        """Yield what the filter lets through behind the message of that number with that time and topic."""
        same = self._open().messages(start=timestamp, stop=timestamp + 1)
        for message in reversed(list(same)) if self._order.reverse else same:
            if number <= 0 and self.passes(message[0].topic):
                yield message
            number -= message[0].topic == topic
        yield from self._from(timestamp - 1 if self._order.reverse else timestamp + 1)

    def reset_filter(self) -> None:
        """Read all topics again."""
        self.set_filter(StorageFilter())

    def set_read_order(self, order: ReadOrder) -> bool:
        """
        Read in another order: backwards, or forwards again.

        An order by something else than the time of reception is not known: False is returned, and nothing changes.
        Whoever has read a part goes on from there with messages of another time. Without a :meth:`seek` a bag is read
        backwards from its end.
        """
        if order.sort_by != ReadOrderSortBy.ReceivedTimestamp:
            return False
        if order.reverse == self._order.reverse:
            return True
        self._order = order
        if self._last is not None:
            self.seek(self._last[0] + (-1 if order.reverse else 1))
        else:
            self.seek(self._start or (self._open().end_time if order.reverse else 0))
        return True

    def get_all_topics_and_types(self) -> list[TopicMetadata]:
        """Return the topics of the bag."""
        return [each.topic_metadata for each in self.get_metadata().topics_with_message_count]

    def get_metadata(self) -> BagMetadata:
        """Return what is known of the bag."""
        return read_metadata(self._path, self._open())

    def _open(self) -> Reader:
        if self._reader is None:
            raise BagError('Bag is not open. Call open() before reading.')
        return self._reader

    def passes(self, topic: str) -> bool:
        """Return whether the filter lets a topic through."""
        chosen = self._filter
        if topic in (*chosen.exclude_topics, *chosen.exclude_service_events):
            return False
        if chosen.regex_to_exclude and re.fullmatch(chosen.regex_to_exclude, topic):
            return False
        named = (*chosen.topics, *chosen.services_events)
        if not (named or chosen.regex):
            return True
        return topic in named or bool(chosen.regex and re.fullmatch(chosen.regex, topic))


class SequentialCompressionReader(SequentialReader):
    """Reads compressed bags, as :class:`SequentialReader` does, too."""


def open_reader(path: Path) -> Reader:
    """Return the library's reader of a bag or a file, opened; raises BagError."""
    if not path.exists():
        raise BagError(f"Bag path '{path}' does not exist!")
    if path.is_dir():
        metadata_file.read(path)  # for its messages
    elif path.suffix not in SUFFIXES.values():
        raise BagError(f"'{path}' is no bag: it is neither a folder nor a .mcap or .db3 file")
    try:
        reader = Reader(path)
        reader.open()
    except (ReaderError, OSError) as error:
        folder = path if path.is_dir() else path.parent
        raise BagError(
            f"'{path}' cannot be read: {error} If the recording did not end in order, run: ros2 bag reindex {folder}"
        ) from None
    return reader


def read_metadata(path: Path, reader: Reader) -> BagMetadata:
    """Return the metadata of a bag, or what a single file says of itself."""
    if path.is_dir():
        return metadata_file.read(path)
    storage = next(name for name, suffix in SUFFIXES.items() if suffix == path.suffix)
    count = reader.message_count
    start = Time(nanoseconds=reader.start_time if count else 0)
    duration = Duration(nanoseconds=reader.duration - 1 if count else 0)
    topics = [TopicInformation(_topic(index, each), each.msgcount) for index, each in enumerate(reader.connections)]
    return BagMetadata(
        bag_size=path.stat().st_size,
        storage_identifier=storage,
        relative_file_paths=[path.name],
        files=[FileInformation(path.name, start, duration, count)],
        starting_time=start,
        duration=duration,
        message_count=count,
        topics_with_message_count=topics,
    )


def _topic(index: int, connection: Connection) -> TopicMetadata:
    return TopicMetadata(
        index,
        connection.topic,
        connection.msgtype,
        connection.ext.serialization_format,
        [to_rclpy(each) for each in connection.ext.offered_qos_profiles],
        connection.digest or type_hash(connection.msgtype),
    )
