"""A bag's metadata.yaml, in version 9 of its format, which is Jazzy's."""

from pathlib import Path
from typing import Any

import yaml
from rclpy.duration import Duration
from rclpy.time import Time
from rosbags.rosbag2.metadata import dump_qos_v9, parse_qos

from rosbag2_py.options import BagMetadata, FileInformation, TopicInformation, TopicMetadata
from rosbag2_py.qos import to_rclpy, to_rosbags

FILE = 'metadata.yaml'
_ROOT = 'rosbag2_bagfile_information'


class BagError(RuntimeError):
    """A bag cannot be read or written; the text says why, and what to do."""


def inner(metadata: BagMetadata) -> dict[str, Any]:
    """Return what stands below the file's only key."""
    return {
        'version': metadata.version,
        'storage_identifier': metadata.storage_identifier,
        'duration': {'nanoseconds': metadata.duration.nanoseconds},
        'starting_time': {'nanoseconds_since_epoch': metadata.starting_time.nanoseconds},
        'message_count': metadata.message_count,
        'topics_with_message_count': [_topic(each) for each in metadata.topics_with_message_count],
        'compression_format': metadata.compression_format,
        'compression_mode': metadata.compression_mode,
        'relative_file_paths': metadata.relative_file_paths,
        'files': [
            {
                'path': each.path,
                'starting_time': {'nanoseconds_since_epoch': each.starting_time.nanoseconds},
                'duration': {'nanoseconds': each.duration.nanoseconds},
                'message_count': each.message_count,
            }
            for each in metadata.files
        ],
        'custom_data': metadata.custom_data or None,
        'ros_distro': metadata.ros_distro,
    }


def _topic(information: TopicInformation) -> dict[str, Any]:
    topic = information.topic_metadata
    return {
        'topic_metadata': {
            'name': topic.name,
            'type': topic.type,
            'serialization_format': topic.serialization_format,
            'offered_qos_profiles': dump_qos_v9([to_rosbags(each) for each in topic.offered_qos_profiles]),
            'type_description_hash': topic.type_description_hash,
        },
        'message_count': information.message_count,
    }


def dump(content: dict[str, Any]) -> str:
    """Return the YAML text."""
    return yaml.safe_dump(content, sort_keys=False, default_flow_style=False)


def write(folder: Path, metadata: BagMetadata) -> None:
    """Write metadata.yaml: it is whole or not there."""
    partial = folder / f'.{FILE}.partial'
    partial.write_text(dump({_ROOT: inner(metadata)}), encoding='utf-8')
    partial.replace(folder / FILE)


def read(folder: Path) -> BagMetadata:
    """
    Read metadata.yaml.

    :raises BagError: if it is not there, or is none.
    """
    file = folder / FILE
    try:
        content = yaml.safe_load(file.read_text(encoding='utf-8'))[_ROOT]
        return _parse(content, folder)
    except FileNotFoundError:
        raise BagError(
            f"'{folder}' has no {FILE}: the recording did not end in order, or this is no bag. "
            f'If it has a .mcap or .db3 file, run: ros2 bag reindex {folder}'
        ) from None
    except (yaml.YAMLError, KeyError, TypeError, ValueError, AttributeError) as error:
        raise BagError(
            f"'{file}' is not the metadata of a bag: {type(error).__name__}: {error}. "
            f'Move it away, then run: ros2 bag reindex {folder}'
        ) from None


def _parse(content: dict[str, Any], folder: Path) -> BagMetadata:
    paths = [Path(path).name for path in content['relative_file_paths']]
    return BagMetadata(
        version=content['version'],
        storage_identifier=content['storage_identifier'],
        relative_file_paths=paths,
        bag_size=sum((folder / path).stat().st_size for path in paths if (folder / path).is_file()),
        files=[
            FileInformation(
                each['path'],
                Time(nanoseconds=each['starting_time']['nanoseconds_since_epoch']),
                Duration(nanoseconds=each['duration']['nanoseconds']),
                each['message_count'],
            )
            for each in content.get('files') or []
        ],
        duration=Duration(nanoseconds=content['duration']['nanoseconds']),
        starting_time=Time(nanoseconds=content['starting_time']['nanoseconds_since_epoch']),
        message_count=content['message_count'],
        topics_with_message_count=[
            TopicInformation(_parse_topic(index, each['topic_metadata']), each['message_count'])
            for index, each in enumerate(content['topics_with_message_count'])
        ],
        compression_format=content.get('compression_format') or '',
        compression_mode=content.get('compression_mode') or '',
        custom_data=content.get('custom_data') or {},
        ros_distro=content.get('ros_distro') or '',
    )


def _parse_topic(index: int, content: dict[str, Any]) -> TopicMetadata:
    return TopicMetadata(
        index,
        content['name'],
        content['type'],
        content['serialization_format'],
        [to_rclpy(each) for each in parse_qos(content.get('offered_qos_profiles') or [])],
        content.get('type_description_hash') or '',
    )


class MetadataIo:
    """Reads and writes the metadata of bags, whose folders are named."""

    def metadata_file_exists(self, uri: str) -> bool:
        """Return whether the folder has a metadata.yaml."""
        return (Path(uri) / FILE).is_file()

    def read_metadata(self, uri: str) -> BagMetadata:
        """Return the metadata; raises BagError if there is none."""
        return read(Path(uri))

    def write_metadata(self, uri: str, metadata: BagMetadata) -> None:
        """Write metadata.yaml."""
        write(Path(uri), metadata)
