"""
Playing and recording in a thread, which a program controls while it goes on: pause, seek, stop …

The thread owns the bag and spins the node. What another thread asks for is done between two of its steps.
"""

import threading
import time
from collections.abc import Callable, Sequence
from typing import Any

from rclpy.logging import LoggingSeverity

from rosbag2_py.compression import CompressionOptions, compression_mode_from_string
from rosbag2_py.merged import MergedReader
from rosbag2_py.options import StorageOptions
from rosbag2_py.player import Playback, PlayOptions
from rosbag2_py.recorder import Recording, RecordOptions
from rosbag2_py.running import RunningNode
from rosbag2_py.writer import SequentialCompressionWriter

_STEP = 0.02  # seconds after which the thread looks for what it is asked for


class _Stopped(Exception):
    """The thread was asked to end."""


class _Worker:
    """A thread with a node; subclasses say what it does."""

    def __init__(self, running: RunningNode, level: LoggingSeverity):
        self.running = running
        running.__enter__()
        self.logger = running.node.get_logger()
        self.logger.set_level(level)
        self.started, self.finished = threading.Event(), threading.Event()
        self.finished.set()
        self._lock = threading.Lock()
        self._requests: list[tuple[Callable[[], Any], threading.Event]] = []
        self._stopping = False
        self._thread: threading.Thread | None = None

    def close(self) -> None:
        """End the thread and leave the graph."""
        self.stop()
        self.running.__exit__(None, None, None)

    def start(self, work: Callable[[], Any]) -> bool:
        """Let the thread do something; return False if it is busy."""
        if not self.finished.is_set():
            return False
        self._join()
        self._stopping = False
        self.finished.clear()
        self._thread = threading.Thread(target=self._run, args=(work,), daemon=True)
        self._thread.start()
        return True

    def stop(self) -> None:
        """End what the thread does, and wait for that."""
        self._stopping = True
        self._join()

    def ask(self, request: Callable[[], Any]) -> None:
        """Have something done in between, and wait for that; at once if the thread does nothing."""
        done = threading.Event()
        with self._lock:
            if self.finished.is_set():
                request()
                return
            self._requests.append((request, done))
        done.wait()

    def pause_between(self, seconds: float) -> None:
        """Spin the node for so long, and do what was asked for; _Stopped if the thread shall end."""
        end = time.monotonic() + seconds
        while True:
            self.running.spin(timeout=max(0.0, min(_STEP, end - time.monotonic())))
            self._answer()
            if self._stopping:
                raise _Stopped
            if time.monotonic() >= end:
                return

    def _answer(self) -> None:
        with self._lock:
            for request, done in self._requests:
                request()
                done.set()
            self._requests.clear()

    def _run(self, work: Callable[[], Any]) -> None:
        try:
            self.started.set()
            work()
        except _Stopped:
            pass
        except Exception as error:  # there is nobody to raise it to
            self.logger.error(str(error))
        finally:
            with self._lock:
                self.finished.set()
            self._answer()

    def _join(self) -> None:
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join()


class ControlledPlayback(_Worker):
    """Plays bags, as one, in a thread."""

    def __init__(self, bags: Sequence[StorageOptions], options: PlayOptions, level: LoggingSeverity, name: str):
        """
        Open the bags and make the publishers.

        :raises BagError: if a bag cannot be read.
        :raises ValueError: if a remapping is none.
        """
        self._reader = MergedReader(bags)
        super().__init__(RunningNode(name, handle_signals=False), level)
        try:
            self.playback = Playback(self.running.node, self._reader, options, self.pause_between)
        except ValueError:
            self.close()
            raise
        self.logger.info(f'Set rate to {options.rate:g}')
        self.logger.info(f'Playback until timestamp: {options.playback_until_timestamp}')

    def close(self) -> None:
        """End the thread, leave the graph and close the bags."""
        super().close()
        self._reader.close()

    def play(self) -> bool:
        """Begin to play; return False if it is being played."""
        if self.start(self.playback.play):
            return True
        self.logger.warning('Trying to play when playback already in progress.')
        return False

    def play_next(self, number: int = 1) -> int:
        """
        Play so many messages now, while the playback is paused.

        :param number: 0 for all that are left
        :returns: how many there were
        """
        if not self.playback.paused:
            self.logger.warning('Called play next, but not in paused state.')
            return 0
        played = 0
        while (played < number or not number) and self._play_one():
            played += 1
        return played

    def _play_one(self) -> bool:
        before = self.playback.published

        def skip() -> None:
            self.playback.skip = True

        self.ask(skip)
        while not self.finished.is_set() and self.playback.published == before:
            self.finished.wait(_STEP / 4)
        self.playback.skip = False
        return self.playback.published > before


class ControlledRecording(_Worker):
    """Records a bag in a thread."""

    def __init__(self, bag: StorageOptions, options: RecordOptions, level: LoggingSeverity, name: str):
        self._bag, self._options = bag, options
        super().__init__(RunningNode(name, options.use_sim_time, handle_signals=False), level)
        self._paused = options.start_paused
        self._recording: Recording | None = None

    @property
    def paused(self) -> bool:
        """Whether what comes is left out."""
        return self._paused

    def pause(self, paused: bool) -> None:
        """Leave out what comes from now on, or record it again."""
        self._paused = paused
        if self._recording is not None:
            self._recording.paused = paused

    def record(self) -> bool:
        """
        Begin to record; return False if it is being recorded.

        :raises BagError: if the bag cannot be written.
        """
        if not self.finished.is_set():
            return False
        mode = compression_mode_from_string(self._options.compression_mode)
        writer = SequentialCompressionWriter(CompressionOptions(self._options.compression_format, mode))
        writer.open(self._bag)
        failures: list[Exception] = []
        recording = Recording(self.running.node, writer, self._options, failures.append)
        recording.paused = self._paused
        self._recording = recording
        self.logger.info('Listening for topics...')
        return self.start(lambda: self._record(recording, writer, failures))

    def _record(self, recording: Recording, writer: SequentialCompressionWriter, failures: list[Exception]) -> None:
        try:
            while not failures:
                recording.look()
                self.pause_between(_STEP)
            raise failures[0]
        except _Stopped:
            self.running.spin_ready(lambda: recording.written)
        finally:
            for subscription in recording.subscriptions.values():
                self.running.node.destroy_subscription(subscription)
            writer.close()
