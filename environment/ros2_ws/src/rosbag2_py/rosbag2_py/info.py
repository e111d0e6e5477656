"""What `ros2 bag info` asks, and prints."""

from collections import Counter
from pathlib import Path
from typing import Any

from rclpy.serialization import deserialize_message
from service_msgs.msg import ServiceEventInfo

from rosbag2_py import metadata as metadata_file
from rosbag2_py.describe import SORTING, describe, in_order, is_service_event
from rosbag2_py.options import BagMetadata
from rosbag2_py.reader import SequentialReader, open_reader, read_metadata


class Info:
    """What `ros2 bag info` asks."""

    def read_metadata(self, uri: str, storage_id: str = '') -> BagMetadata:
        """Return what is known of a bag; raises BagError as :meth:`SequentialReader.open`."""
        path = Path(uri)
        if path.is_dir():
            return metadata_file.read(path)
        reader = open_reader(path)
        try:
            return read_metadata(path, reader)
        finally:
            reader.close()

    def get_sorting_methods(self) -> set[str]:
        """Return the names of the orders in which topics can be printed."""
        return set(SORTING)

    def print_output(self, metadata_info: BagMetadata, sorting_method: str = 'name') -> None:
        """Print what is known of a bag."""
        print(describe(metadata_info, sorting_method))

    def print_output_topic_name_only(self, metadata_info: BagMetadata, sorting_method: str = 'name') -> None:
        """Print the names of a bag's topics, without those of the events of services."""
        for each in in_order(metadata_info, sorting_method):
            if not is_service_event(each.topic_metadata.name):
                print(each.topic_metadata.name)

    def print_output_verbose(self, uri: str, metadata_info: BagMetadata, sorting_method: str = 'name') -> None:
        """Read all messages, too: print how large those of a topic are, and how many calls a service has had."""
        sizes: Counter[str] = Counter()
        calls: dict[str, tuple[set[Any], set[Any]]] = {}
        reader = SequentialReader()
        reader.open_uri(uri)
        try:
            while reader.has_next():
                topic, data, _ = reader.read_next()
                sizes[topic] += len(data)
                if is_service_event(topic):
                    event = deserialize_message(data, ServiceEventInfo)
                    which = event.event_type in (ServiceEventInfo.RESPONSE_SENT, ServiceEventInfo.RESPONSE_RECEIVED)
                    calls.setdefault(topic, (set(), set()))[which].add((bytes(event.client_gid), event.sequence_number))
        finally:
            reader.close()
        counts = {topic: (len(requests), len(responses)) for topic, (requests, responses) in calls.items()}
        print(describe(metadata_info, sorting_method, sizes, counts))
