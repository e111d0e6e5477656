"""Solution regions inside an exercise cell: from the author's text to the solved cell and to the learner's stub."""

from dataclasses import dataclass

from grading.authoring.chapter_errors import CellError

BEGIN, END, STUB = '# BEGIN SOLUTION', '# END SOLUTION', '# STUB:'
PLACEHOLDER = '# Your code here.'
IN_XML = '<!-- {} -->'  # how a file that is XML has these


@dataclass(frozen=True)
class Split:
    """The two forms of an exercise cell."""

    solved: str
    stub: str
    solved_lines: tuple[int, ...]  # for each line of ``solved``: its offset, from 0, in the author's text
    regions: int


class MarkerError(CellError):
    """A marker is out of place."""


def has_marker(source: str) -> bool:
    """Tell whether any line of ``source`` is a solution marker."""
    lines = [_plain(line.strip()) for line in source.splitlines()]
    return any(line in (BEGIN, END) or line.startswith(STUB) for line in lines)


def split(source: str) -> Split:
    """Return the solved form of a cell (its markers gone) and the stub (its regions replaced).

    A region becomes the line ``# Your code here.``, followed by what its ``# STUB:`` lines hold. In XML, where ``#``
    begins no comment, ``<!-- BEGIN SOLUTION -->`` and ``<!-- END SOLUTION -->`` are the markers.

    :raises MarkerError: BEGIN without END, END without BEGIN, nested regions, or STUB outside of a region.
    """
    solved, solved_lines, stub = [], [], []
    begin, regions = None, 0
    for offset, line in enumerate(source.splitlines()):
        text = _plain(line.strip())
        indent = line[: len(line) - len(line.lstrip())]
        if text == BEGIN:
            if begin is not None:
                raise MarkerError(offset, f'{BEGIN} inside a solution region', f'write {END} before it')
            begin, regions = offset, regions + 1
            stub.append(indent + (PLACEHOLDER if text == line.strip() else _in_xml(PLACEHOLDER)))
        elif text == END:
            if begin is None:
                raise MarkerError(offset, f'{END} without {BEGIN}', f'write {BEGIN} before the solution')
            begin = None
        elif text.startswith(STUB):
            if begin is None:
                raise MarkerError(offset, f'{STUB} outside of a solution region', f'move it between {BEGIN} and {END}')
            stub.append((indent + text[len(STUB) :].removeprefix(' ')).rstrip())
        else:
            solved.append(line)
            solved_lines.append(offset)
            if begin is None:
                stub.append(line)
    if begin is not None:
        raise MarkerError(begin, f'{BEGIN} without {END}', f'write {END} after the solution')
    return Split('\n'.join(solved), '\n'.join(stub), tuple(solved_lines), regions)


def _in_xml(marker: str) -> str:
    return IN_XML.format(marker.removeprefix('# '))


def _plain(text: str) -> str:
    """A marker as it stands in Python, if the text is one in XML; else the text."""
    return next((marker for marker in (BEGIN, END) if text == _in_xml(marker)), text)
