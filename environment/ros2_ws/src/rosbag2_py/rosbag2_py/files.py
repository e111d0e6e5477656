"""
A bag's data files, MCAP or SQLite, as the library rosbags writes them, safe against a sudden end.

The library writes what it has collected when it is told to close. Here the collected messages go to the file every
second, so that a killed program loses no more than that; `ros2 bag reindex` gives such a file its end.
"""

import os
import sqlite3
import struct
import tempfile
import time
from pathlib import Path
from typing import Any

from rosbags.interfaces import Connection
from rosbags.rosbag2.enums import CompressionMode
from rosbags.rosbag2.metadata import dump_qos_v9
from rosbags.rosbag2.storage_mcap import McapReader, McapWriter
from rosbags.rosbag2.storage_sqlite3 import Sqlite3Writer

from rosbag2_py.metadata import BagError, dump

SUFFIXES = {'mcap': '.mcap', 'sqlite3': '.db3'}
FLUSH_PERIOD = 1.0  # seconds


class _Folder:
    """Stands for the folder of a bag where the library asks for it: it would name the file after the folder."""

    def __init__(self, path: Path, stem: str):
        self.name = stem
        self._path = path

    def __truediv__(self, name: str) -> Path:
        return self._path / name


class DataFile:
    """A data file that is being written."""

    def __init__(self, folder: Path, stem: str, storage_id: str, compressed: bool = False):
        """Create `<folder>/<stem>.mcap` or `.db3`; with `compressed` the chunks of an MCAP file are compressed."""
        mode = CompressionMode.STORAGE if compressed and storage_id == 'mcap' else CompressionMode.NONE
        kind = {'mcap': McapWriter, 'sqlite3': Sqlite3Writer}[storage_id]
        self._storage: Any = kind(_Folder(folder, stem), mode)  # type: ignore[arg-type]
        self.path: Path = self._storage.path
        self.message_count, self.first, self.last = 0, 2**63 - 1, 0
        self._types: set[str] = set()
        self._written = 0
        self._flushed = time.monotonic()
        if storage_id == 'sqlite3':
            # Callbacks come in any thread; the caller sees to it that there is one at a time.
            self._storage.conn.close()
            self._storage.conn = sqlite3.connect(self.path, check_same_thread=False)
            self._storage.cursor = self._storage.conn.cursor()
            # What is committed outlives a killed process without waiting for the disk each time.
            self._storage.conn.execute('PRAGMA synchronous=OFF')

    @property
    def size(self) -> int:
        """Bytes of the messages written so far, about what the file takes."""
        return self._written

    def add(self, connection: Connection) -> None:
        """Add a topic."""
        if connection.msgtype not in self._types:
            self._types.add(connection.msgtype)
            self._storage.add_msgtype(connection)
        self._storage.add_connection(connection, dump(dump_qos_v9(connection.ext.offered_qos_profiles)).strip())

    def write(self, connection: Connection, timestamp: int, data: bytes) -> None:
        """Write a message; `timestamp` in nanoseconds."""
        self._storage.write(connection, timestamp, data)
        self.message_count += 1
        self._written += len(data)
        self.first, self.last = min(self.first, timestamp), max(self.last, timestamp)
        self.flush(FLUSH_PERIOD)

    def flush(self, period: float = 0.0) -> None:
        """Hand what was collected to the operating system, unless that was done less than `period` seconds ago."""
        now = time.monotonic()
        if now < self._flushed + period:
            return
        self._flushed = now
        if isinstance(self._storage, Sqlite3Writer):
            self._storage.conn.commit()
        else:
            if self._storage.chunk.msgs:
                self._storage.close_chunk()
            self._storage.bio.flush()

    def close(self, version: int, metadata: str) -> None:
        """Write the end of the file."""
        self._storage.close(version, metadata)


# MCAP's specification: a file is its magic, then records (opcode, length of 8 bytes, content), then its magic again.
_MAGIC = b'\x89MCAP0\r\n'
_FOOTER, _CHUNK, _DATA_END = 0x02, 0x06, 0x0F
_END = struct.pack('<BQI', _DATA_END, 4, 0) + struct.pack('<BQQQI', _FOOTER, 20, 0, 0, 0) + _MAGIC


def end_mcap(path: Path) -> bool:
    """
    Give an MCAP file that was left without an end one; whether that was needed.

    A record that was not written to its end is cut off. The end has no index (see `index_mcap`): readers scan the file.

    :raises BagError: if it is no MCAP file, or has no whole record.
    """
    size = path.stat().st_size
    with path.open('r+b') as file:
        if file.read(len(_MAGIC)) != _MAGIC:
            raise BagError(f"'{path}' is no MCAP file")
        end = file.tell()
        while end + 9 <= size:
            opcode, length = struct.unpack('<BQ', file.read(9))
            if end + 9 + length > size:
                break
            if opcode == _FOOTER:
                file.seek(end + 9 + length)
                if file.read(len(_MAGIC)) == _MAGIC:
                    return False
                break
            if opcode == _DATA_END:  # the summary that follows is made anew
                break
            end += 9 + length
            file.seek(end)
        if end == len(_MAGIC):
            raise BagError(f"'{path}' ends before its first record; nothing of it can be read")
        file.truncate(end)
        file.seek(end)
        file.write(_END)
    return True


def index_mcap(path: Path, metadata: str) -> None:
    """
    Write an MCAP file without an index anew, with one, and with the bag's metadata.

    Who scans a file may need its messages in the order of their times, as the library rosbags does. On a busy machine
    those of two topics can be recorded in another order.

    :raises OSError: there is no room; the file is as before.
    """
    reader = McapReader(path)
    reader.open()
    try:
        with tempfile.TemporaryDirectory(prefix='.reindex_', dir=path.parent) as folder:
            file = DataFile(Path(folder), path.stem, 'mcap', _compressed(path))
            for connection in reader.connections:
                file.add(connection)
            for connection, timestamp, data in reader.messages_scan(reader.connections):
                file.write(connection, timestamp, data)
            file.close(9, metadata)
            file.path.replace(path)
    finally:
        reader.close()


def _compressed(path: Path) -> bool:
    """Return whether the first chunk of an MCAP file that has an end is compressed."""
    with path.open('rb') as file:
        file.seek(len(_MAGIC))
        while True:
            opcode, length = struct.unpack('<BQ', file.read(9))
            if opcode == _CHUNK:
                file.seek(28, os.SEEK_CUR)  # times, size, checksum; then comes the compression's name
                return struct.unpack('<I', file.read(4))[0] > 0
            if opcode == _DATA_END:
                return False
            file.seek(length, os.SEEK_CUR)
