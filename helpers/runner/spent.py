"""How long the parts of a session take, in the tests' process: for the benchmark."""

import time
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager

seconds: defaultdict[str, float] = defaultdict(float)


@contextmanager
def part(name: str) -> Iterator[None]:
    """Add the wall time of the block to `seconds[name]`."""
    begin = time.perf_counter()
    try:
        yield
    finally:
        seconds[name] += time.perf_counter() - begin
