"""Writes the messages of bags into other bags: merged, divided, filtered, compressed, in another storage."""

import dataclasses
import heapq
from contextlib import ExitStack, closing
from datetime import timedelta
from pathlib import Path
from typing import Any

import yaml

from rosbag2_py.compression import CompressionOptions, compression_mode_from_string
from rosbag2_py.merged import messages_of
from rosbag2_py.metadata import BagError
from rosbag2_py.options import StorageOptions
from rosbag2_py.reader import SequentialReader
from rosbag2_py.recorder import RecordOptions, chosen
from rosbag2_py.writer import SequentialCompressionWriter

_ROOT = 'output_bags'
_STORAGE, _RECORD = (
    {field.name: field for field in dataclasses.fields(kind)} for kind in (StorageOptions, RecordOptions)
)


def bag_rewrite(input_options: list[StorageOptions], output_config_file: str) -> None:
    """
    Write bags anew.

    :param input_options: the bags that are read; their messages are put into one order by time
    :param output_config_file: a YAML file whose only key, `output_bags`, is a list: for each bag that is written its
        `uri` and other names of StorageOptions, and what goes into it by names of RecordOptions
    :raises BagError: if a bag cannot be read or written, or the file is none of these
    """
    outputs = _read(output_config_file)
    with ExitStack() as stack:
        readers = [stack.enter_context(closing(SequentialReader())) for _ in input_options]
        for reader, each in zip(readers, input_options, strict=True):
            reader.open(each)
        topics = [topic for reader in readers for topic in reader.get_all_topics_and_types()]
        writers = []
        for storage, record in outputs:
            mode = compression_mode_from_string(record.compression_mode)
            writer = SequentialCompressionWriter(CompressionOptions(record.compression_format, mode))
            stack.enter_context(closing(writer))
            writer.open(storage)
            names = {topic.name for topic in topics if chosen(record, topic.name, [topic.type])}
            for topic in topics:
                if topic.name in names:
                    writer.create_topic(topic)
            writers.append((writer, names))
        for name, data, timestamp in heapq.merge(*map(messages_of, readers), key=lambda message: message[2]):
            for writer, names in writers:
                if name in names:
                    writer.write(name, data, timestamp)


def _read(path: str) -> list[tuple[StorageOptions, RecordOptions]]:
    try:
        content = yaml.safe_load(Path(path).read_text(encoding='utf-8'))
    except OSError as error:
        raise BagError(f"'{path}' cannot be read: {error.strerror}") from None
    except yaml.YAMLError as error:
        raise BagError(f"'{path}' is not valid YAML: {getattr(error, 'problem', error)}") from None
    bags = content.get(_ROOT) if isinstance(content, dict) else None
    if not isinstance(bags, list):
        raise BagError(f"'{path}' must have the key '{_ROOT}', a list of the bags that shall be written")
    return [_options(path, bag) for bag in bags]


def _options(path: str, bag: Any) -> tuple[StorageOptions, RecordOptions]:
    if not isinstance(bag, dict) or 'uri' not in bag:
        raise BagError(f"'{path}': each of the '{_ROOT}' needs a 'uri', the folder that shall be written")
    storage, record = StorageOptions(str(bag['uri'])), RecordOptions()
    for name, value in bag.items():
        if name == 'topic_polling_interval':  # of a recording; here nothing is awaited
            value = timedelta()
        target = storage if name in _STORAGE else record
        if name not in _STORAGE and name not in _RECORD and name not in ('exclude', 'output_serialization_format'):
            raise BagError(f"'{path}': '{name}' is no option of a bag")
        known = getattr(target, name, value)
        if isinstance(known, list | dict | str) and not isinstance(value, type(known)):
            raise BagError(f"'{path}': '{name}' must be a {type(known).__name__}, not {value!r}")
        setattr(target, 'exclude_regex' if name == 'exclude' else name, value)
    for names in ('topics', 'exclude_topics'):
        full = [name if name.startswith('/') else f'/{name}' for name in getattr(record, names)]
        setattr(record, names, [*getattr(record, names), *full])  # a bag may have a name without a slash
    return storage, record
