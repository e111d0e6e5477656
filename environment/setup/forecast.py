"""How far the build of the ROS packages is, and how long it will still take."""

import re
import time
from collections.abc import Callable, Mapping
from pathlib import Path

_FINISHED = re.compile(r'Finished <<< (\S+)')
_COMPILED, _EACH_INTERFACE, _COPIED = 3.0, 0.4, 0.5  # rough seconds of a processor: only their ratios count


def effort(directory: Path) -> float:
    """What building the package in `directory` costs, in seconds of some processor."""
    if (directory / 'setup.py').exists():
        return _COPIED
    interfaces = sum(1 for kind in ('msg', 'srv', 'action') for _ in directory.glob(f'{kind}/*.{kind}'))
    return _COMPILED + _EACH_INTERFACE * interfaces if interfaces else _COPIED


class Forecast:
    """Turns colcon's lines into lines for the person who waits."""

    def __init__(self, efforts: Mapping[str, float], clock: Callable[[], float] = time.monotonic):
        self._open = dict(efforts)
        self._total = len(efforts)
        self._all = sum(efforts.values())
        self._clock = clock
        self._started = clock()

    def line(self, output: str) -> str:
        """What to say when colcon has said `output`; '' if it is nothing that matters."""
        found = _FINISHED.search(output)
        if not found or found[1] not in self._open:
            return ''
        del self._open[found[1]]
        text = f'  {self._total - len(self._open)} of {self._total}: {found[1]}'
        left = sum(self._open.values())
        if left:
            seconds = (self._clock() - self._started) * left / (self._all - left)
            text += f', about {max(seconds, 1):.0f} s left'
        return text
