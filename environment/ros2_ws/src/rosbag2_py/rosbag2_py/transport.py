"""
Play and record by program: a call lasts until the end, Ctrl+C, or `cancel()` from another thread.

The nodes offer no services such as `~/pause`: those are services of rosbag2_interfaces.
"""

import threading
from collections.abc import Sequence
from contextlib import closing
from typing import Any

from rclpy.logging import LoggingSeverity

from rosbag2_py.compression import CompressionOptions, compression_mode_from_string
from rosbag2_py.merged import MergedReader
from rosbag2_py.options import StorageOptions
from rosbag2_py.player import Playback, PlayOptions
from rosbag2_py.recorder import Recording, RecordOptions
from rosbag2_py.running import RunningNode
from rosbag2_py.writer import SequentialCompressionWriter


class _Cancelled(Exception):
    """Another thread has called `cancel()`."""


class _Transport:
    """What both have: a level of their log, and a way to end them."""

    _cancelled: threading.Event

    def __init__(self, log_level: str = 'info') -> None:
        """
        Remember what to log.

        :raises RuntimeError: if there is no such level.
        """
        if log_level.upper() not in LoggingSeverity.__members__:
            raise RuntimeError(f"the log level '{log_level}' is not known")
        self._level = LoggingSeverity[log_level.upper()]

    @classmethod
    def cancel(cls) -> None:
        """End what runs in another thread."""
        cls._cancelled.set()


class Player(_Transport):
    """Plays a bag, or several as one."""

    _cancelled = threading.Event()

    def play(self, storage_options: StorageOptions | Sequence[StorageOptions], play_options: PlayOptions) -> None:
        """
        Play a bag to its end, with `loop` again and again.

        :raises BagError: if it cannot be read.
        """
        self._run(storage_options, play_options, lambda playback: playback.play())

    def burst(
        self, storage_options: StorageOptions | Sequence[StorageOptions], play_options: PlayOptions, num_messages: int
    ) -> None:
        """Publish so many messages at once (BagError as above)."""
        self._run(storage_options, play_options, lambda playback: playback.burst(num_messages))

    def _run(self, bags: StorageOptions | Sequence[StorageOptions], options: PlayOptions, act: Any) -> None:
        self._cancelled.clear()
        reader = MergedReader([bags] if isinstance(bags, StorageOptions) else bags)
        with closing(reader), RunningNode('rosbag2_player') as running:
            logger = running.node.get_logger()
            logger.set_level(self._level)

            def wait(seconds: float) -> None:
                running.spin(timeout=seconds)
                if self._cancelled.is_set():
                    raise _Cancelled

            playback = Playback(running.node, reader, options, wait)
            logger.info(f'Set rate to {options.rate:g}')
            logger.info(f'Playback until timestamp: {options.playback_until_timestamp}')
            try:
                act(playback)
            except _Cancelled:
                return


class Recorder(_Transport):
    """Records bags."""

    _cancelled = threading.Event()

    def record(
        self, storage_options: StorageOptions, record_options: RecordOptions, node_name: str = 'rosbag2_recorder'
    ) -> None:
        """
        Record what the options choose.

        :raises BagError: if the bag cannot be written.
        """
        self._cancelled.clear()
        mode = compression_mode_from_string(record_options.compression_mode)
        writer = SequentialCompressionWriter(CompressionOptions(record_options.compression_format, mode))
        failures: list[Exception] = []
        with closing(writer), RunningNode(node_name, record_options.use_sim_time) as running:
            logger = running.node.get_logger()
            logger.set_level(self._level)
            writer.open(storage_options)
            recording = Recording(running.node, writer, record_options, failures.append)
            logger.info('Listening for topics...')

            def step() -> bool:
                recording.look()
                return bool(failures) or self._cancelled.is_set()

            running.spin(until=step)
            running.spin_ready(lambda: recording.written)
        if failures:
            raise failures[0]
