"""Reads several bags as one."""

import heapq
from collections.abc import Iterator, Sequence

from rclpy.duration import Duration
from rclpy.time import Time

from rosbag2_py.metadata import BagError
from rosbag2_py.options import BagMetadata, StorageFilter, StorageOptions, TopicMetadata
from rosbag2_py.reader import SequentialReader


class MergedReader:
    """Reads several bags as one, forwards: what a player asks of a reader."""

    def __init__(self, bags: Sequence[StorageOptions]):
        """Open the bags; raises BagError as :meth:`SequentialReader.open`."""
        self._readers: list[SequentialReader] = []
        try:
            for bag in bags:
                self._readers.append(SequentialReader())
                self._readers[-1].open(bag)
        except BagError:
            self.close()
            raise
        self.seek(0)

    def close(self) -> None:
        """Close the bags."""
        for reader in self._readers:
            reader.close()

    def get_metadata(self) -> BagMetadata:
        """Return the times and the topics of all bags; a topic that is in several of them is that of the first."""
        bags = [reader.get_metadata() for reader in self._readers]
        filled = [bag for bag in bags if bag.message_count] or bags
        start = min(bag.starting_time.nanoseconds for bag in filled)
        end = max(bag.starting_time.nanoseconds + bag.duration.nanoseconds for bag in filled)
        topics = {each.topic_metadata.name: each for bag in reversed(bags) for each in bag.topics_with_message_count}
        return BagMetadata(
            starting_time=Time(nanoseconds=start),
            duration=Duration(nanoseconds=end - start),
            message_count=sum(bag.message_count for bag in bags),
            topics_with_message_count=list(topics.values()),
        )

    def get_all_topics_and_types(self) -> list[TopicMetadata]:
        """Return the topics of the bags."""
        return [each.topic_metadata for each in self.get_metadata().topics_with_message_count]

    def set_filter(self, storage_filter: StorageFilter) -> None:
        """Read only what the filter lets through, from the time of the last :meth:`seek` on."""
        for reader in self._readers:
            reader.set_filter(storage_filter)
        self.seek(self._start)

    def passes(self, topic: str) -> bool:
        """Return whether the filter lets a topic through."""
        return self._readers[0].passes(topic)

    def seek(self, timestamp: int) -> None:
        """Go on with the first message at or after a time in nanoseconds."""
        self._start = timestamp
        for reader in self._readers:
            reader.seek(timestamp)
        self._messages = heapq.merge(*map(messages_of, self._readers), key=lambda message: message[2])
        self._next: tuple[str, bytes, int] | None = None

    def has_next(self) -> bool:
        """Return whether there is another message."""
        if self._next is None:
            self._next = next(self._messages, None)
        return self._next is not None

    def read_next(self) -> tuple[str, bytes, int]:
        """Return the next message, as :meth:`SequentialReader.read_next`."""
        if not self.has_next():
            raise BagError('Bag is at end. No next message.')
        message, self._next = self._next, None
        return message  # type: ignore[return-value]


def messages_of(reader: SequentialReader) -> Iterator[tuple[str, bytes, int]]:
    """Yield the messages that a reader has left."""
    while reader.has_next():
        yield reader.read_next()
