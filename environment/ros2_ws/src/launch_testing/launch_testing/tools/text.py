"""Whether a text or its lines are what is expected."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TypeAlias

Expected: TypeAlias = str | re.Pattern | Sequence[str | re.Pattern]


def expect_output(
    text: str | None = None,
    *,
    expected_text: Expected | None = None,
    expected_lines: Expected | None = None,
    lines: Sequence[str] | None = None,
    strict: bool = False,
) -> bool:
    """
    Return whether an output is as expected. Give one expectation, and one of ``text`` and ``lines``.

    :param expected_text: a text, a pattern, or several of them in their order
    :param expected_lines: a part of a line, a pattern that fits its beginning, or several of them in their order
    :param strict: what is expected begins with the output, and nothing else comes between; a single text is all of it
    :raises ValueError: if other arguments are given
    """
    if (expected_text is None) == (expected_lines is None):
        raise ValueError('Either expected_text or expected_lines is needed, and not both')
    if (text is None) == (lines is None):
        raise ValueError('Either text or lines is needed, and not both')
    if expected_text is not None:
        return _fits_text(expected_text, normalize_lineseps('\n'.join(lines or ()) if text is None else text), strict)
    return _fits_lines(
        expected_lines, normalize_lineseps(text or '').splitlines() if lines is None else list(lines), strict
    )


def normalize_lineseps(lines: str) -> str:
    """Return a text with the line ends that a terminal has changed put right."""
    return lines.replace('\r\n', '\n')


def _fits_text(expected: Expected, text: str, strict: bool) -> bool:
    if isinstance(expected, str) and strict:
        return text == expected
    end = 0
    for one in [expected] if isinstance(expected, (str, re.Pattern)) else expected:
        pattern = re.compile(re.escape(one)) if isinstance(one, str) else one
        found = pattern.match(text, end) if strict else pattern.search(text, end)
        if found is None:
            return False
        end = found.end()
    return True


def _fits_lines(expected: Expected, lines: list[str], strict: bool) -> bool:
    if isinstance(expected, (str, re.Pattern)):
        if strict:
            return all(line == expected if isinstance(expected, str) else expected.match(line) for line in lines)
        return any(_is_in(expected, line) for line in lines)
    at = 0
    for one in expected:
        candidates = lines[at : at + 1] if strict else lines[at:]
        found = next((index for index, line in enumerate(candidates) if _is_in(one, line)), None)
        if found is None:
            return False
        at += found + 1
    return True


def _is_in(expected: str | re.Pattern, line: str) -> bool:
    return expected in line if isinstance(expected, str) else expected.match(line) is not None
