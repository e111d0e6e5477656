"""Compression of bags with zstd: of each file when it is complete, or of each message."""

import shutil
import sys
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

if sys.version_info >= (3, 14):
    from compression import zstd
else:
    from backports import zstd

FORMAT = 'zstd'
_MAGIC = b'\x28\xb5\x2f\xfd'  # of a zstd frame; a serialized message begins with two bytes that say how, the first is 0


class CompressionMode(Enum):
    """What is compressed."""

    NONE = 0
    FILE = 1
    MESSAGE = 2


@dataclass
class CompressionOptions:
    """How a bag is compressed; names and order as upstream. Here the program itself compresses, without a queue."""

    compression_format: str = ''
    compression_mode: CompressionMode = CompressionMode.NONE
    compression_queue_size: int = 0
    compression_threads: int = 0
    thread_priority: int = 0


def compression_mode_from_string(compression_mode: str) -> CompressionMode:
    """Return the mode of a name, in large or small letters; NONE for a name that there is not."""
    return CompressionMode.__members__.get(compression_mode.upper(), CompressionMode.NONE)


def compression_mode_to_string(compression_mode: CompressionMode) -> str:
    """Return the name of a mode."""
    return compression_mode.name


def compress_file(path: Path) -> Path:
    """Put a file that is complete into a compressed one beside it, which takes its place; return its path."""
    compressed = path.with_name(f'{path.name}.{FORMAT}')
    partial = path.with_name(f'.{compressed.name}.partial')
    with path.open('rb') as source, zstd.open(partial, 'wb') as target:
        shutil.copyfileobj(source, target)
    partial.replace(compressed)
    path.unlink()
    return compressed


def compress(data: bytes) -> bytes:
    """Return a message, compressed."""
    return zstd.compress(data)


def is_compressed(data: bytes) -> bool:
    """Return whether the data of a message are compressed."""
    return data[:4] == _MAGIC


def decompress(data: bytes) -> bytes:
    """Return a message as it was before; one that is not compressed stays as it is."""
    return zstd.decompress(data) if is_compressed(data) else data
