"""The wish that processes get a signal."""

from __future__ import annotations

import signal
from collections.abc import Callable

from launch.events.process.process_targeted_event import ProcessTargetedEvent


class SignalProcess(ProcessTargetedEvent):
    """Processes are to get a signal."""

    name = 'launch.events.process.SignalProcess'

    def __init__(self, *, signal_number: str | int, process_matcher: Callable[[object], bool]):
        super().__init__(process_matcher=process_matcher)
        self.signal = signal.Signals[signal_number] if isinstance(signal_number, str) else signal.Signals(signal_number)
        self.signal_name = self.signal.name
