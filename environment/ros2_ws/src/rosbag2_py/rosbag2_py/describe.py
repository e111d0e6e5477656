"""A bag's metadata as text, in the form of `ros2 bag info`."""

import time
from collections.abc import Callable, Mapping

from rosbag2_py.options import BagMetadata, TopicInformation

_WIDTH = 19  # of the names of the lines
_SECOND = 1_000_000_000
SERVICE_EVENTS = '/_service_event'
#: By what the topics can be sorted.
SORTING: dict[str, Callable[[TopicInformation], str | int]] = {
    'name': lambda information: information.topic_metadata.name,
    'type': lambda information: information.topic_metadata.type,
    'count': lambda information: information.message_count,
}


def describe(
    metadata: BagMetadata,
    sorting_method: str = 'name',
    sizes: Mapping[str, int] | None = None,
    calls: Mapping[str, tuple[int, int]] | None = None,
) -> str:
    """
    Return the text, an empty line first.

    :param sorting_method: a key of `SORTING`
    :param sizes: with it, a line tells how many bytes the messages of its topic have
    :param calls: with it, a service's line tells how many requests and responses its topic of events has
    """

    def topic(information: TopicInformation) -> str:
        topic = information.topic_metadata
        return f'Topic: {topic.name} | Type: {topic.type} | Count: {information.message_count} | ' + end(information)

    def service(information: TopicInformation) -> str:
        topic, counts = information.topic_metadata, f'Event Count: {information.message_count}'
        if calls is not None:
            counts = 'Request Count: {} | Response Count: {}'.format(*calls.get(topic.name, (0, 0)))
        name, kind = topic.name.removesuffix(SERVICE_EVENTS), topic.type.removesuffix('_Event')
        return f'Service: {name} | Type: {kind} | {counts} | ' + end(information)

    def end(information: TopicInformation) -> str:
        topic = information.topic_metadata
        size = '' if sizes is None else f'Size Contribution: {_size(sizes.get(topic.name, 0))} | '
        return f'{size}Serialization Format: {topic.serialization_format}'

    start, duration = metadata.starting_time.nanoseconds, metadata.duration.nanoseconds
    everything = in_order(metadata, sorting_method)
    topics = [each for each in everything if not is_service_event(each.topic_metadata.name)]
    services = [each for each in everything if is_service_event(each.topic_metadata.name)]
    lines = [
        '',
        _line('Files:', *metadata.relative_file_paths),
        _line('Bag size:', _size(metadata.bag_size)),
        _line('Storage id:', metadata.storage_identifier),
        _line('ROS Distro:', metadata.ros_distro or 'unknown'),
        _line('Duration:', f'{_seconds(duration)}s'),
        _line('Start:', _moment(start)),
        _line('End:', _moment(start + duration)),
        _line('Messages:', str(metadata.message_count - sum(each.message_count for each in services))),
        _line('Topic information:', *map(topic, topics)),
        _line('Service:', str(len(services))),
        _line('Service information:', *map(service, services)),
    ]
    return '\n'.join(lines) + '\n' * bool(services)


def in_order(metadata: BagMetadata, sorting_method: str) -> list[TopicInformation]:
    """Return the topics of a bag in an order, a key of `SORTING` in small or capital letters."""
    if (key := SORTING.get(sorting_method.lower())) is None:
        raise RuntimeError(f'Enum value match for "{sorting_method.lower()}" string is not found.')
    return sorted(metadata.topics_with_message_count, key=key)


def is_service_event(topic: str) -> bool:
    """Return whether a topic holds the events of a service."""
    return topic.endswith(SERVICE_EVENTS)


def _line(name: str, *values: str) -> str:
    first = f'{name} '.ljust(_WIDTH)
    return first + f'\n{" " * len(first)}'.join(values or [''])


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
