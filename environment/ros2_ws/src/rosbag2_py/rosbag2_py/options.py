"""What callers tell the readers and writers, and what these tell of a bag; names and order of arguments as upstream."""

from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from rclpy.duration import Duration
from rclpy.time import Time


@dataclass
class StorageOptions:
    """Where a bag is, or shall be, and when a new file begins (sizes in bytes, durations in seconds; 0: never)."""

    uri: str
    storage_id: str = ''
    max_bagfile_size: int = 0
    max_bagfile_duration: int = 0
    max_cache_size: int = 0  # upstream's cache; here each message goes to the file at once
    storage_preset_profile: str = ''
    storage_config_uri: str = ''
    snapshot_mode: bool = False
    start_time_ns: int = -1
    end_time_ns: int = -1
    custom_data: dict[str, str] = field(default_factory=dict)


@dataclass
class ConverterOptions:
    """The serialization formats; only `cdr`, or '' for it, can be read and written."""

    input_serialization_format: str = ''
    output_serialization_format: str = ''


@dataclass
class StorageFilter:
    """Which topics to read; empty: all. The regular expressions are matched as a whole."""

    topics: list[str] = field(default_factory=list)
    services_events: list[str] = field(default_factory=list)
    regex: str = ''
    exclude_topics: list[str] = field(default_factory=list)
    exclude_service_events: list[str] = field(default_factory=list)
    regex_to_exclude: str = ''


@dataclass
class TopicMetadata:
    """A topic of a bag; `offered_qos_profiles` are rclpy's QoSProfile objects."""

    id: int = 0
    name: str = ''
    type: str = ''
    serialization_format: str = 'cdr'
    offered_qos_profiles: list[Any] = field(default_factory=list)
    type_description_hash: str = ''


@dataclass
class TopicInformation:
    """A topic and how many messages it has."""

    topic_metadata: TopicMetadata
    message_count: int


@dataclass
class FileInformation:
    """A file of a bag."""

    path: str
    starting_time: Time
    duration: Duration
    message_count: int


@dataclass
class BagMetadata:
    """What metadata.yaml says of a bag."""

    version: int = 9
    bag_size: int = 0
    storage_identifier: str = ''
    relative_file_paths: list[str] = field(default_factory=list)
    files: list[FileInformation] = field(default_factory=list)
    duration: Duration = field(default_factory=Duration)
    starting_time: Time = field(default_factory=Time)
    message_count: int = 0
    topics_with_message_count: list[TopicInformation] = field(default_factory=list)
    compression_format: str = ''
    compression_mode: str = ''
    custom_data: dict[str, str] = field(default_factory=dict)
    ros_distro: str = ''

    def __str__(self) -> str:
        """Return what `ros2 bag info` prints."""
        from rosbag2_py.describe import describe

        return describe(self)


class ReadOrderSortBy(Enum):
    """By which time messages are read."""

    ReceivedTimestamp = 0
    PublishedTimestamp = 1
    File = 2


@dataclass
class ReadOrder:
    """In which order messages are read; the time of their reception is the only one here, forwards or backwards."""

    sort_by: ReadOrderSortBy = ReadOrderSortBy.ReceivedTimestamp
    reverse: bool = False
