"""
Read, write, record, play and reindex bags of messages: MCAP and SQLite, in the format of Jazzy's rosbag2.

The names are upstream's, as far as its tutorials use them. The files are written and read by the library rosbags.
"""

from rosbag2_py import _storage  # noqa: F401  # tutorials write rosbag2_py._storage.StorageOptions
from rosbag2_py.compression import (
    FORMAT,
    CompressionMode,
    CompressionOptions,
    compression_mode_from_string,
    compression_mode_to_string,
)
from rosbag2_py.info import Info
from rosbag2_py.message_definitions import LocalMessageDefinitionSource, MessageDefinition
from rosbag2_py.metadata import BagError, MetadataIo
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
from rosbag2_py.player import PlayOptions, ServiceRequestsSource
from rosbag2_py.reader import SequentialCompressionReader, SequentialReader
from rosbag2_py.recorder import RecordOptions
from rosbag2_py.reindex import Reindexer
from rosbag2_py.rewrite import bag_rewrite
from rosbag2_py.transport import Player, Recorder
from rosbag2_py.writer import DEFAULT_STORAGE, SequentialCompressionWriter, SequentialWriter

__all__ = [
    'BagError',
    'BagMetadata',
    'CompressionMode',
    'CompressionOptions',
    'ConverterOptions',
    'FileInformation',
    'Info',
    'LocalMessageDefinitionSource',
    'MessageDefinition',
    'MetadataIo',
    'PlayOptions',
    'Player',
    'ReadOrder',
    'ReadOrderSortBy',
    'RecordOptions',
    'Recorder',
    'Reindexer',
    'SequentialCompressionReader',
    'SequentialCompressionWriter',
    'SequentialReader',
    'SequentialWriter',
    'ServiceRequestsSource',
    'StorageFilter',
    'StorageOptions',
    'TopicInformation',
    'TopicMetadata',
    'bag_rewrite',
    'compression_mode_from_string',
    'compression_mode_to_string',
    'get_default_storage_id',
    'get_registered_compressors',
    'get_registered_readers',
    'get_registered_serializers',
    'get_registered_writers',
]


def get_default_storage_id() -> str:
    """Return the storage that a bag gets if none is named."""
    return DEFAULT_STORAGE


def get_registered_compressors() -> set[str]:
    """Return the formats in which files and messages can be compressed."""
    return {FORMAT}


def get_registered_readers() -> set[str]:
    """Return the storages that can be read."""
    return {'mcap', 'sqlite3'}


def get_registered_serializers() -> set[str]:
    """Return the serialization formats."""
    return {'cdr'}


def get_registered_writers() -> set[str]:
    """Return the storages that can be written."""
    return {'mcap', 'sqlite3'}
