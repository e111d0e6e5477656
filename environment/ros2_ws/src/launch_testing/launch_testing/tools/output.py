"""Which lines of an output count."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from pathlib import Path


def get_default_filtered_prefixes() -> list[str]:
    """Return what lines begin with that are left out by default."""
    return ['pid', 'rc']


def get_default_filtered_patterns() -> list[str]:
    """Return the patterns of lines that are left out by default: none."""
    return []


def basic_output_filter(
    filtered_prefixes: Iterable[str] | None = None, filtered_patterns: Iterable[str] | None = None
) -> Callable[[str], str]:
    """
    Return a function that leaves lines out of a text.

    :param filtered_prefixes: what such lines begin with; by default `get_default_filtered_prefixes`
    :param filtered_patterns: regular expressions that fit their beginnings
    """
    prefixes = tuple(get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes)
    patterns = [re.compile(one) for one in filtered_patterns or ()]

    def keep(line: str) -> bool:
        return not line.startswith(prefixes) and not any(pattern.match(line) for pattern in patterns)

    return lambda output: ''.join(filter(keep, output.splitlines(keepends=True)))


def expected_output_from_file(path: str | Path, encoding: str | None = None) -> list[str | re.Pattern]:
    """
    Return the lines of the file PATH.txt, or those of PATH.regex as regular expressions.

    :param encoding: of the file; ``'unicode_escape'`` also reads Python's escape sequences
    :raises RuntimeError: if there is none of the two
    """
    text, patterns = Path(f'{path}.txt'), Path(f'{path}.regex')
    if text.is_file():
        return list(text.read_text(encoding).splitlines())
    if patterns.is_file():
        return [re.compile(line) for line in patterns.read_text(encoding).splitlines()]
    raise RuntimeError(f'could not find output check file: {path}')
