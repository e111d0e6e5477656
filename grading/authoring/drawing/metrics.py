"""How wide a text is, before any browser has set it.

The widths are those of DejaVu Sans, the widest of the usual system fonts, so that a text which fits here fits anywhere.
"""

import re
from typing import NamedTuple

LINE = 1.3  # height of a line, in font sizes
MONO = 0.61  # width of a character of code, in font sizes
BOLD = 1.13
_WIDTHS = {
    0.28: "'ijl",
    0.32: 'IJ ,.·’',
    0.36: '/:;\\|-f',
    0.4: '()[]!t',
    0.46: 'r"',
    0.5: '*_`°–',
    0.53: 's“”?z',
    0.58: 'cLFk',
    0.62: 'vxyPTYπaeo',
    0.65: '$0123456789ESbdghnpqu{}βKα',
    0.7: 'ABVXZCR',
    0.77: 'UNHD',
    0.82: '&GOQw',
}
_WIDTH = {character: width for width, characters in _WIDTHS.items() for character in characters}
_WIDEST = 1.0
_SPAN = re.compile(r'`([^`]+)`|\*\*(.+?)\*\*')


class Span(NamedTuple):
    """A part of a line that is set in one way."""

    text: str
    mono: bool = False
    bold: bool = False


def spans(line: str, bold: bool = False) -> list[Span]:
    """Split a line at its marks for code and bold."""
    result, end = [], 0
    for match in _SPAN.finditer(line):
        if match.start() > end:
            result.append(Span(line[end : match.start()], bold=bold))
        result.append(Span(match[1], mono=True, bold=bold) if match[1] else Span(match[2], bold=True))
        end = match.end()
    if line[end:]:
        result.append(Span(line[end:], bold=bold))
    return result


def width(line: str, size: float, bold: bool = False) -> float:
    """Return the width of a line of text."""
    return sum(_width(span) for span in spans(line, bold)) * size


def _width(span: Span) -> float:
    if span.mono:
        return MONO * len(span.text)
    return sum(_WIDTH.get(character, _WIDEST) for character in span.text) * (BOLD if span.bold else 1)
