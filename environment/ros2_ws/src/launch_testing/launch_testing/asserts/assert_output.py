"""
What processes have written.

A test that fails shows the message alone: PYTEST_DONT_REWRITE.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import Any

from launch_testing.util import resolveProcesses

_ANSI = re.compile(r'\x1b\[[0-?]*[ -/]*[@-~]')


def assertInStream(
    proc_output,
    expected_output: str | re.Pattern | Sequence,
    process,
    cmd_args=None,
    *,
    output_filter: Callable[[str], str] | None = None,
    strict_proc_matching: bool = True,
    strip_ansi_escape_sequences: bool = True,
    stream: str = 'stderr',
) -> None:
    """
    Check that a process has written something, see ``launch_testing.util.resolveProcesses`` for which one.

    :param expected_output: a text, a pattern, whole lines in their order, or patterns in their order
    :param output_filter: applied to the output before
    :param stream: stdout or stderr
    :raises AssertionError: if none of the processes has
    :raises ValueError: if the output is expected in another form, or there is no such stream
    """
    if stream not in ('stdout', 'stderr'):
        raise ValueError(f"stream argument must be 'stdout' or 'stderr', got '{stream}'")
    if output_filter is not None and not callable(output_filter):
        raise ValueError('output_filter is not callable')
    found = resolveProcesses(proc_output, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching)
    for one in found:
        parts = [output.text for output in proc_output[one] if getattr(output, f'from_{stream}')]
        text = b''.join(parts).decode(errors='replace').replace('\r\n', '\n')
        text = _ANSI.sub('', text) if strip_ansi_escape_sequences else text
        if _is_in(expected_output, text if output_filter is None else output_filter(text)):
            return
    names = ', '.join(sorted(one.process_details['name'] for one in found))
    raise AssertionError(
        f"Did not find '{expected_output}' in {stream} output for any of the matching processes: {names}"
    )


def assertInStdout(*args: Any, **kwargs: Any) -> None:
    """Check the standard output, see ``assertInStream``."""
    assertInStream(*args, stream='stdout', **kwargs)


def assertInStderr(*args: Any, **kwargs: Any) -> None:
    """Check the standard error, see ``assertInStream``."""
    assertInStream(*args, stream='stderr', **kwargs)


def _is_in(expected: Any, text: str) -> bool:
    if isinstance(expected, str):
        return expected in text
    if hasattr(expected, 'search'):
        return expected.search(text) is not None
    if isinstance(expected, (list, tuple)) and expected:
        if isinstance(expected[0], str):
            lines = iter(text.splitlines())
            return all(line in lines for line in expected)  # each search goes on behind the last find
        if hasattr(expected[0], 'search'):
            return _are_in_order(expected, text)
    raise ValueError('Unknown format for expected output')


def _are_in_order(patterns: Sequence[re.Pattern], text: str) -> bool:
    begin = 0
    for pattern in patterns:
        match = pattern.search(text, begin)
        if match is None:
            return False
        begin = match.end()
    return True
