"""Makes metadata.yaml anew from a bag's data files, after giving an end to one that was left without."""

import os
import re
from contextlib import suppress
from pathlib import Path

from rclpy.time import Time

from rosbag2_py import metadata as metadata_file
from rosbag2_py.compression import FORMAT, CompressionMode, is_compressed
from rosbag2_py.files import SUFFIXES, end_mcap, index_mcap
from rosbag2_py.metadata import BagError
from rosbag2_py.options import BagMetadata, StorageOptions, TopicInformation
from rosbag2_py.reader import open_reader, read_metadata


class Reindexer:
    """Makes bags readable whose recording did not end in order."""

    def reindex(self, storage_options: StorageOptions) -> BagMetadata:
        """
        Write metadata.yaml into a bag's folder, and return what it says.

        :raises BagError: if there is no data file, or none that can be read.
        """
        folder = Path(storage_options.uri)
        if not folder.is_dir():
            raise BagError(f"'{folder}' is no folder")
        storages = [storage_options.storage_id] if storage_options.storage_id else list(SUFFIXES)
        for storage in storages:
            files = sorted(folder.glob(f'*{SUFFIXES[storage]}'), key=_number)
            if files:
                metadata = _joined([_read(file, storage) for file in files], storage)
                metadata_file.write(folder, metadata)
                return metadata
        raise BagError(f"'{folder}' has no {' or '.join(SUFFIXES[each] for each in storages)} file")


def _number(file: Path) -> tuple[int, str]:
    found = re.search(r'_(\d+)$', file.stem)
    return (int(found[1]) if found else 0, file.name)


def _read(file: Path, storage: str) -> BagMetadata:
    if storage == 'mcap' and end_mcap(file):
        with suppress(OSError):  # a full disk; it is scanned then
            index_mcap(file, metadata_file.dump(metadata_file.inner(_facts(file))))
    return _facts(file)


def _facts(file: Path) -> BagMetadata:
    reader = open_reader(file)
    try:
        metadata = read_metadata(file, reader)
        first = next(reader.messages(), None)
        if first is not None and is_compressed(bytes(first[2])):
            metadata.compression_format, metadata.compression_mode = FORMAT, CompressionMode.MESSAGE.name
        return metadata
    finally:
        reader.close()


def _joined(parts: list[BagMetadata], storage: str) -> BagMetadata:
    topics: dict[str, TopicInformation] = {}
    for part in parts:
        for each in part.topics_with_message_count:
            known = topics.setdefault(each.topic_metadata.name, TopicInformation(each.topic_metadata, 0))
            known.message_count += each.message_count
    filled = [part for part in parts if part.message_count]
    start = min((part.starting_time for part in filled), default=Time())
    end = max((part.starting_time + part.duration for part in filled), default=start)
    return BagMetadata(
        storage_identifier=storage,
        relative_file_paths=[path for part in parts for path in part.relative_file_paths],
        files=[file for part in parts for file in part.files],
        starting_time=start,
        duration=end - start,
        message_count=sum(part.message_count for part in parts),
        topics_with_message_count=list(topics.values()),
        compression_format=max(part.compression_format for part in parts),
        compression_mode=max(part.compression_mode for part in parts),
        ros_distro=os.environ.get('ROS_DISTRO', 'jazzy'),
    )
