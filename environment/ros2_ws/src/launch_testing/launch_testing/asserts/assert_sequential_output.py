"""
The order of what a process has written.

A test that fails shows the message alone: PYTEST_DONT_REWRITE.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from launch_testing.util import resolveProcesses

_CONTEXT = 3  # lines shown before and behind the last find


class SequentialTextChecker:
    """Looks for texts one behind the other."""

    def __init__(self, output: Sequence[str]):
        self._text, self._at = ''.join(output), 0

    def assertInText(self, msg: str) -> None:
        """
        Find a text behind the one found last.

        :raises AssertionError: if it is not there
        """
        found = self._text.find(msg, self._at)
        assert found != -1, (
            f"'{msg}' not found in sequence after previous match.  The output near the last matched "
            f'line:\n{self.get_nearby_lines()}'
        )
        self._at = found + len(msg)

    def assertInStdout(self, msg: str) -> None:
        """Do the same as ``assertInText``."""
        self.assertInText(msg)

    def get_nearby_lines(self) -> str:
        """Return the lines around the text found last."""
        ended = self._text.startswith('\n', self._at)  # the find ended its line, whose rest is no line of context
        before = self._text[: self._at].splitlines()[-_CONTEXT:]
        behind = self._text[self._at :].splitlines()[: _CONTEXT + ended]
        return '\n'.join(before[:-1] + [''.join(before[-1:] + behind[:1])] + behind[1:])


@contextmanager
def assertSequentialStdout(proc_output, process, cmd_args=None) -> Iterator[SequentialTextChecker]:
    """
    Give a checker of what a process has written, see ``launch_testing.util.resolveProcesses``.

    Its name is upstream's; as there, the standard error counts, too, where ROS nodes log.
    """
    (one,) = resolveProcesses(proc_output, process=process, cmd_args=cmd_args)
    yield SequentialTextChecker([part.text.decode(errors='replace') for part in proc_output[one]])
