"""A window of samples and what `ros2 topic hz` and `delay` say about it."""

import math
from collections import deque
from typing import NamedTuple


class Summary(NamedTuple):
    """Mean, extremes, standard deviation (all in nanoseconds) and number of the samples."""

    mean: float
    smallest: int
    largest: int
    deviation: float
    count: int

    def line(self) -> str:
        """Return the second line of the output, in seconds."""
        return (
            f'\tmin: {self.smallest * 1e-9:.3f}s max: {self.largest * 1e-9:.3f}s '
            f'std dev: {self.deviation * 1e-9:.5f}s window: {self.count}'
        )


class Window:
    """The latest samples, in nanoseconds."""

    def __init__(self, size: int) -> None:
        """Keep so many samples."""
        self._samples = deque(maxlen=size)

    def __bool__(self) -> bool:
        """Return whether there is a sample."""
        return bool(self._samples)

    def add(self, sample: int) -> None:
        """Add a sample; the oldest leaves if the window is full."""
        self._samples.append(sample)

    def clear(self) -> None:
        """Forget all samples."""
        self._samples.clear()

    def summary(self) -> Summary:
        """Return the figures; there must be a sample."""
        count = len(self._samples)
        mean = sum(self._samples) / count
        deviation = math.sqrt(sum((sample - mean) ** 2 for sample in self._samples) / count)
        return Summary(mean, min(self._samples), max(self._samples), deviation, count)
