"""Writes bags."""

import os
import shutil
import threading
import weakref
from pathlib import Path

from rclpy.duration import Duration
from rclpy.time import Time
from rosbags.interfaces import Connection, ConnectionExtRosbag2, MessageDefinitionFormat
from rosbags.interfaces import MessageDefinition as StoredDefinition

from rosbag2_py import compression
from rosbag2_py import metadata as metadata_file
from rosbag2_py.compression import CompressionMode, CompressionOptions
from rosbag2_py.definitions import definition, type_hash
from rosbag2_py.files import SUFFIXES, DataFile
from rosbag2_py.message_definitions import MessageDefinition
from rosbag2_py.metadata import BagError
from rosbag2_py.options import (
    BagMetadata,
    ConverterOptions,
    FileInformation,
    StorageOptions,
    TopicInformation,
    TopicMetadata,
)
from rosbag2_py.qos import to_rosbags

DEFAULT_STORAGE = 'mcap'
NO_SNAPSHOTS = (
    'Snapshot mode is not available: the service that takes a snapshot is one of rosbag2_interfaces, '
    'and no such service is offered here. Record without it.'
)
LEAST_SIZE = {'mcap': 1024, 'sqlite3': 86016}  # bytes of a file, before the next one is begun; as upstream
SPACE_KEPT = 10 * 2**20  # bytes that a recording leaves free on the disk


class SequentialWriter:
    """Writes a bag, message by message; it is closed with :meth:`close`, or when the program ends."""

    def __init__(self) -> None:
        """Begin without a bag."""
        self._bag: _Bag | None = None
        self._compression = CompressionOptions()

    def open(self, storage_options: StorageOptions, converter_options: ConverterOptions | None = None) -> None:
        """
        Create a bag: a folder of the name `storage_options.uri`.

        :raises BagError: if it is there already, the storage or the serialization format is not known, or for
            snapshot mode.
        """
        if storage_options.snapshot_mode:
            raise BagError(NO_SNAPSHOTS)
        for given in (converter_options or ConverterOptions()).__dict__.values():
            if given not in ('', 'cdr'):
                raise BagError(f"the serialization format '{given}' is not known; there is 'cdr'")
        self.close()
        self._bag = _Bag(storage_options, self._compression)
        # Tutorials leave it to the end of the program.
        self._close = weakref.finalize(self, self._bag.close)

    def create_topic(self, topic: TopicMetadata, message_definition: MessageDefinition | None = None) -> None:
        """
        Add a topic; one that is there already stays as it is.

        :param message_definition: what the bag says of the type; without a text, what the installed package says
        """
        self._opened().create_topic(topic, message_definition)

    def remove_topic(self, topic: TopicMetadata) -> None:
        """Take no more messages of a topic."""
        self._opened().remove_topic(topic.name)

    def write(self, topic_name: str, message: bytes, time_stamp: int) -> None:
        """
        Write a serialized message; `time_stamp` in nanoseconds.

        :raises BagError: if the topic was not created, or the disk is full.
        """
        self._opened().write(topic_name, message, time_stamp)

    def flush(self) -> None:
        """Hand the messages so far to the operating system."""
        self._opened().flush()

    def split_bagfile(self) -> None:
        """Go on in a new file."""
        self._opened().split()

    def take_snapshot(self) -> bool:
        """Return False: there is no snapshot mode."""
        return False

    def close(self) -> None:
        """Write the end of the file, and metadata.yaml. A second call does nothing."""
        if self._bag is not None:
            self._bag = None
            self._close()

    def _opened(self) -> '_Bag':
        if self._bag is None:
            raise BagError('Bag is not open. Call open() before writing.')
        return self._bag


class SequentialCompressionWriter(SequentialWriter):
    """Writes a bag whose files or messages are compressed."""

    def __init__(self, compression_options: CompressionOptions | None = None) -> None:
        """
        Begin without a bag.

        :raises BagError: if the format of the compression is not known.
        """
        super().__init__()
        options = compression_options or CompressionOptions()
        if options.compression_mode != CompressionMode.NONE and options.compression_format != compression.FORMAT:
            raise BagError(
                f"the compression format '{options.compression_format}' is not known; there is '{compression.FORMAT}'"
            )
        self._compression = options


class _Bag:
    """A bag that is being written."""

    def __init__(self, options: StorageOptions, compressed: CompressionOptions):
        self.storage_id = options.storage_id or DEFAULT_STORAGE
        if self.storage_id not in SUFFIXES:
            raise BagError(f"the storage '{self.storage_id}' is not known; there are {', '.join(SUFFIXES)}")
        if 0 < options.max_bagfile_size < LEAST_SIZE[self.storage_id]:
            raise BagError(
                'Invalid bag splitting size given. Please provide a value greater than '
                f'{LEAST_SIZE[self.storage_id]}. Specified value of {options.max_bagfile_size}'
            )
        self.folder = Path(options.uri)
        try:
            self.folder.mkdir(parents=True)
        except FileExistsError:
            raise BagError(f"the folder '{self.folder}' exists already; a bag is written into a new one") from None
        except OSError as error:
            raise BagError(f"the folder '{self.folder}' cannot be created: {error.strerror}") from None
        self.options, self.compressed = options, compressed
        self._lock = threading.Lock()
        self._connections: dict[str, Connection] = {}
        self._topics: dict[str, TopicMetadata] = {}
        self._counts: dict[str, int] = {}
        self._files: list[DataFile] = []
        self._unchecked = 0
        self._begin_file()

    def _begin_file(self) -> None:
        compressed = self.options.storage_preset_profile.startswith('zstd')
        stem = f'{self.folder.resolve().name}_{len(self._files)}'
        self._files.append(DataFile(self.folder, stem, self.storage_id, compressed))
        for connection in self._connections.values():
            self._files[-1].add(connection)

    def create_topic(self, topic: TopicMetadata, given: MessageDefinition | None = None) -> None:
        with self._lock:
            if topic.name in self._connections:
                return
            known = topic.type_description_hash or type_hash(topic.type)
            extension = ConnectionExtRosbag2('cdr', [to_rosbags(each) for each in topic.offered_qos_profiles])
            connection = Connection(
                len(self._topics) + 1, topic.name, topic.type, _stored(topic.type, given), known, 0, extension, self
            )
            self._connections[topic.name] = connection
            self._topics[topic.name] = TopicMetadata(
                topic.id, topic.name, topic.type, 'cdr', topic.offered_qos_profiles, known
            )
            self._counts.setdefault(topic.name, 0)
            self._files[-1].add(connection)

    def remove_topic(self, name: str) -> None:
        with self._lock:
            self._connections.pop(name, None)

    def write(self, name: str, data: bytes, timestamp: int) -> None:
        with self._lock:
            if name not in self._connections:
                raise BagError(f"the topic '{name}' was not created in this bag; call create_topic() before write()")
            if self._full(timestamp):
                self._split()
            self._check_disk(len(data))
            if self.compressed.compression_mode == CompressionMode.MESSAGE:
                data = compression.compress(data)
            self._files[-1].write(self._connections[name], timestamp, data)
            self._counts[name] += 1

    def _full(self, timestamp: int) -> bool:
        file, options = self._files[-1], self.options
        if not file.message_count:
            return False
        if options.max_bagfile_size and file.size >= options.max_bagfile_size:
            return True
        return bool(options.max_bagfile_duration and timestamp - file.first >= options.max_bagfile_duration * 10**9)

    def _check_disk(self, size: int) -> None:
        """Stop in time: a full disk would leave a file without an end."""
        self._unchecked += size
        if self._unchecked > SPACE_KEPT // 10:
            self._unchecked = 0
            if shutil.disk_usage(self.folder).free < SPACE_KEPT:
                raise BagError(f"the disk of '{self.folder}' is full; the recording ends here")

    def split(self) -> None:
        with self._lock:
            self._split()

    def _split(self) -> None:
        self._end_file()
        self._begin_file()

    def flush(self) -> None:
        with self._lock:
            self._files[-1].flush()

    def _end_file(self) -> None:
        file = self._files[-1]
        file.close(9, metadata_file.dump(metadata_file.inner(self._metadata())))
        if self.compressed.compression_mode == CompressionMode.FILE:
            file.path = compression.compress_file(file.path)

    def _metadata(self) -> BagMetadata:
        """What metadata.yaml says of the files so far."""
        filled = [file for file in self._files if file.message_count]
        mode = self.compressed.compression_mode
        first = min((file.first for file in filled), default=0)
        return BagMetadata(
            storage_identifier=self.storage_id,
            relative_file_paths=[file.path.name for file in self._files],
            files=[
                FileInformation(
                    file.path.name,
                    Time(nanoseconds=file.first if file.message_count else 0),
                    Duration(nanoseconds=max(0, file.last - file.first)),
                    file.message_count,
                )
                for file in self._files
            ],
            duration=Duration(nanoseconds=max((file.last for file in filled), default=0) - first),
            starting_time=Time(nanoseconds=first),
            message_count=sum(self._counts.values()),
            topics_with_message_count=[
                TopicInformation(topic, self._counts[name]) for name, topic in self._topics.items()
            ],
            compression_format='' if mode == CompressionMode.NONE else compression.FORMAT,
            compression_mode='' if mode == CompressionMode.NONE else mode.name,
            custom_data=self.options.custom_data,
            ros_distro=os.environ.get('ROS_DISTRO', 'jazzy'),
        )

    def close(self) -> None:
        with self._lock:
            self._end_file()
            metadata_file.write(self.folder, self._metadata())


def _stored(type_name: str, given: MessageDefinition | None) -> StoredDefinition:
    """Return what the file says of a type: what was given, or the text of the installed package."""
    if given is not None and given.encoded_message_definition:
        kind = {'ros2msg': MessageDefinitionFormat.MSG, 'ros2idl': MessageDefinitionFormat.IDL}.get(given.encoding)
        return StoredDefinition(kind or MessageDefinitionFormat.NONE, given.encoded_message_definition)
    text = definition(type_name)
    return StoredDefinition(MessageDefinitionFormat.MSG if text else MessageDefinitionFormat.NONE, text)
