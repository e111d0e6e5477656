"""A bag's metadata as text, in the form of `ros2 bag info`."""

import time

from rosbag2_py.options import BagMetadata, TopicInformation

_WIDTH = 19  # of the names of the lines
_SECOND = 1_000_000_000
SERVICE_EVENTS = '/_service_event'


def describe(metadata: BagMetadata) -> str:
    """Return the text, an empty line first."""
    start, duration = metadata.starting_time.nanoseconds, metadata.duration.nanoseconds
    topics = [each for each in metadata.topics_with_message_count if not is_service_event(each.topic_metadata.name)]
    services = [each for each in metadata.topics_with_message_count if is_service_event(each.topic_metadata.name)]
    lines = [
        '',
        _line('Files:', *metadata.relative_file_paths),
        _line('Bag size:', _size(metadata.bag_size)),
        _line('Storage id:', metadata.storage_identifier),
        _line('ROS Distro:', metadata.ros_distro or 'unknown'),
        _line('Duration:', f'{_seconds(duration)}s'),
        _line('Start:', _moment(start)),
        _line('End:', _moment(start + duration)),
        _line('Messages:', str(metadata.message_count)),
        _line('Topic information:', *map(_topic, topics)),
        _line('Services:', str(len(services))),
        _line('Service information:', *map(_service, services)),
    ]
    return '\n'.join(lines) + '\n'


def is_service_event(topic: str) -> bool:
    """Return whether a topic holds the events of a service."""
    return topic.endswith(SERVICE_EVENTS)


def _line(name: str, *values: str) -> str:
    first = name.ljust(_WIDTH) if len(name) < _WIDTH else f'{name} '
    return first + f'\n{" " * _WIDTH}'.join(values or [''])


def _topic(information: TopicInformation) -> str:
    topic = information.topic_metadata
    return (
        f'Topic: {topic.name} | Type: {topic.type} | Count: {information.message_count} | '
        f'Serialization Format: {topic.serialization_format}'
    )


def _service(information: TopicInformation) -> str:
    topic = information.topic_metadata
    return (
        f'Service: {topic.name.removesuffix(SERVICE_EVENTS)} | Type: {topic.type.removesuffix("_Event")} | '
        f'Event Count: {information.message_count} | Serialization Format: {topic.serialization_format}'
    )


def _seconds(nanoseconds: int) -> str:
    return f'{nanoseconds // _SECOND}.{nanoseconds % _SECOND:09d}'


def _moment(nanoseconds: int) -> str:
    local = time.localtime(nanoseconds // _SECOND)
    fraction = f'{nanoseconds % _SECOND:09d}'
    return f'{time.strftime("%b %e %Y %H:%M:%S", local)}.{fraction} ({_seconds(nanoseconds)})'


def _size(size: float) -> str:
    units = ['B', 'KiB', 'MiB', 'GiB', 'TiB']
    while size >= 1024 and len(units) > 1:
        size /= 1024
        del units[0]
    return f'{size:.0f} B' if units[0] == 'B' else f'{size:.1f} {units[0]}'
