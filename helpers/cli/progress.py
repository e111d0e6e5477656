"""Shows in a terminal that tests are running, and how many have finished."""

import itertools
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console


@contextmanager
def counted(console: Console, tests: str) -> Iterator[Callable[[str], None]]:
    """A block with a line that counts; yields what has to be told of each test that has finished, from any thread.

    The line is gone after the block, and is not there where the output is no terminal.

    :param tests: what is counted, such as ``visible tests``.
    """
    numbers = itertools.count(1)
    with console.status(f'Running the {tests}') as status:
        yield lambda test: status.update(f'Running the {tests}: {next(numbers)} done')
