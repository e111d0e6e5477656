"""
Play and record by program.

Either a call lasts until the end, Ctrl+C, or `cancel()` from another thread. Or the options are given at the beginning;
then a thread plays or records, and the program may pause it, seek, and stop it.

The nodes offer no services such as `~/pause`: those are services of rosbag2_interfaces.
"""

import threading
import weakref
from collections.abc import Sequence
from contextlib import closing
from typing import Any

from rclpy.logging import LoggingSeverity

from rosbag2_py.compression import CompressionOptions, compression_mode_from_string
from rosbag2_py.controlled import ControlledPlayback, ControlledRecording
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

    def start_spin(self) -> None:
        """Do nothing: the thread that plays or records spins the node, too."""

    def stop_spin(self) -> None:
        """Do nothing, as :meth:`start_spin`."""

    @classmethod
    def cancel(cls) -> None:
        """End what runs in another thread."""
        cls._cancelled.set()


class Player(_Transport):
    """
    Plays a bag, or several as one.

    :param storage_options: the bag or bags; only a level of the log, or nothing, for a player whose `play` has it all
    """

    _cancelled = threading.Event()

    def __init__(
        self,
        storage_options: StorageOptions | Sequence[StorageOptions] | str = 'info',
        play_options: PlayOptions | None = None,
        log_level: str = 'info',
        node_name: str = 'rosbag2_player',
    ) -> None:
        """
        Open the bag and make its publishers, if it is given.

        :raises BagError: if it cannot be read.
        :raises RuntimeError: if there is no such level of the log.
        """
        self._controlled: ControlledPlayback | None = None
        super().__init__(storage_options if isinstance(storage_options, str) else log_level)
        if not isinstance(storage_options, str):
            bags = _several(storage_options)
            self._controlled = ControlledPlayback(bags, play_options or PlayOptions(), self._level, node_name)
            weakref.finalize(self, self._controlled.close)  # also when the program ends

    def play(
        self,
        storage_options: StorageOptions | Sequence[StorageOptions] | None = None,
        play_options: PlayOptions | None = None,
    ) -> None:
        """
        Begin to play; or, with options, play a bag to its end, with `loop` again and again.

        :raises BagError: if it cannot be read.
        """
        if storage_options is None:
            self._own.play()
        else:
            self._run(storage_options, play_options or PlayOptions(), lambda playback: playback.play())

    def burst(
        self,
        storage_options: StorageOptions | Sequence[StorageOptions] | int | None = None,
        play_options: PlayOptions | None = None,
        num_messages: int = 0,
    ) -> int | None:
        """
        Publish so many messages at once, 0 for all: `burst(number)` while the playback is paused, or of another bag.

        :returns: how many there were, for `burst(number)`.
        """
        if storage_options is None or isinstance(storage_options, int):
            return self._own.play_next(num_messages if storage_options is None else storage_options)
        self._run(storage_options, play_options or PlayOptions(), lambda playback: playback.burst(num_messages))
        return None

    def wait_for_playback_to_start(self, timeout: float = -1.0) -> bool:
        """Wait for so many seconds, with -1 for ever; return whether it has begun."""
        return _wait(self._own.started, timeout)

    def wait_for_playback_to_finish(self, timeout: float = -1.0) -> bool:
        """Wait for so many seconds, with -1 for ever; return whether it is over."""
        return _wait(self._own.finished, timeout)

    wait_for_playback_to_start_exclusively = wait_for_playback_to_start
    wait_for_playback_to_finish_exclusively = wait_for_playback_to_finish

    def stop(self) -> None:
        """End the playback."""
        self._own.stop()

    def pause(self) -> None:
        """Stop the bag's time."""
        self._own.ask(lambda: self._own.playback.pause(True))

    def resume(self) -> None:
        """Let the bag's time go on."""
        self._own.ask(lambda: self._own.playback.pause(False))

    def is_paused(self) -> bool:
        """Return whether the bag's time stands still."""
        return self._own.playback.paused

    def get_starting_time(self) -> int:
        """Return the time at which the playback begins, in nanoseconds."""
        return self._own.playback.start

    def get_playback_duration(self) -> int:
        """Return how long the playback is, in nanoseconds of the bag's time."""
        return self._own.playback.duration

    def play_next(self) -> bool:
        """Play the next message now, while the playback is paused; return whether there was one."""
        return self._own.play_next() > 0

    def seek(self, time_point: int) -> None:
        """Go on with the first message at or after a time in nanoseconds."""
        self._own.ask(lambda: self._own.playback.seek(time_point))

    @property
    def _own(self) -> ControlledPlayback:
        if self._controlled is None:
            raise RuntimeError('Player is not initialized. Please use constructor with storage and play options.')
        return self._controlled

    def _run(self, bags: StorageOptions | Sequence[StorageOptions], options: PlayOptions, act: Any) -> None:
        self._cancelled.clear()
        reader = MergedReader(_several(bags))
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
    """
    Records bags.

    :param storage_options: the bag; only a level of the log, or nothing, for a recorder whose `record` has it all
    """

    _cancelled = threading.Event()

    def __init__(
        self,
        storage_options: StorageOptions | str = 'info',
        record_options: RecordOptions | None = None,
        log_level: str = 'info',
        node_name: str = 'rosbag2_recorder',
    ) -> None:
        """
        Make the node, if the bag is given.

        :raises RuntimeError: if there is no such level of the log.
        """
        self._controlled: ControlledRecording | None = None
        super().__init__(storage_options if isinstance(storage_options, str) else log_level)
        if not isinstance(storage_options, str):
            options = record_options or RecordOptions()
            self._controlled = ControlledRecording(storage_options, options, self._level, node_name)
            weakref.finalize(self, self._controlled.close)  # also when the program ends

    def stop(self) -> None:
        """End the recording and complete the bag."""
        self._own.stop()

    def pause(self) -> None:
        """Leave out what comes from now on."""
        self._own.pause(True)

    def resume(self) -> None:
        """Record again what comes."""
        self._own.pause(False)

    def is_paused(self) -> bool:
        """Return whether what comes is left out."""
        return self._own.paused

    @property
    def _own(self) -> ControlledRecording:
        if self._controlled is None:
            raise RuntimeError('Recorder is not initialized. Please use constructor with storage and record options.')
        return self._controlled

    def record(
        self,
        storage_options: StorageOptions | None = None,
        record_options: RecordOptions | None = None,
        node_name: str = 'rosbag2_recorder',
    ) -> None:
        """
        Begin to record; or, with options, record until Ctrl+C or `cancel()`.

        :raises BagError: if the bag cannot be written.
        """
        if storage_options is None:
            self._own.record()
            return
        record_options = record_options or RecordOptions()
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


def _several(bags: StorageOptions | Sequence[StorageOptions]) -> Sequence[StorageOptions]:
    return [bags] if isinstance(bags, StorageOptions) else bags


def _wait(event: threading.Event, timeout: float) -> bool:
    return event.wait(None if timeout < 0 else timeout)
