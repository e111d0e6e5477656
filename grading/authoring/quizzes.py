"""Questions for "Check yourself": one click on an option tells whether it is right, and why.

The directive holds the question, and each option with its reason below it::

    ```{quiz}
    A node is not spun. What does `ros2 node list` show?

    - (a) nothing
      A node is in the graph as soon as it exists.
    - (b, right) the node
      It is in the graph, but calls no callback.
    ```

Each option becomes a ``<details>``, which JupyterLab and browsers fold without a kernel. Questions are numbered.
"""

import re
from dataclasses import dataclass
from string import ascii_lowercase

from markdown_it import MarkdownIt

from grading.authoring.chapter_errors import CellError

_BEGIN = re.compile(r'(`{3,})\s*\{quiz\}\s*(.*)')
_OPTION = re.compile(r'- \(([a-z])(, right)?\)\s+(\S.*)')
EXAMPLE = '- (a) an option, or - (b, right) the right one, and below it, indented, the reason'


@dataclass
class _Option:
    letter: str
    right: bool
    text: str
    reason: str
    offset: int


def render(source: str, first: int) -> tuple[str, int]:
    """Return a Markdown cell with its quizzes as the notebooks show them, and the number of the last question.

    :param first: the number of the cell's first question.
    :raises CellError: a quiz is not complete.
    """
    lines, shown, index, number = source.split('\n'), [], 0, first - 1
    while index < len(lines):
        match = _BEGIN.fullmatch(lines[index].rstrip())
        if not match:
            shown.append(lines[index])
            index += 1
            continue
        end = next((k for k in range(index + 1, len(lines)) if lines[k].strip() == match[1]), None)
        if end is None:
            raise CellError(index, 'a quiz has no end', f'close it with {match[1]}')
        if match[2]:
            raise CellError(index, f'a quiz with {match[2]!r} in its first line', 'write the question below it')
        number += 1
        question, options = _parse(lines[index + 1 : end], index)
        folded = [line for option in options for line in _details(option)]
        # JupyterLab leaves no space below a fold.
        shown += [f'**{number}.** {question}', '', '<div style="margin-bottom: 1.2em">', *folded, '</div>']
        index = end + 1
    return '\n'.join(shown), number


def _parse(lines: list[str], begin: int) -> tuple[str, list[_Option]]:
    """The question and its options; `begin` is the offset of the directive."""
    question: list[str] = []
    options: list[_Option] = []
    for offset, line in enumerate(lines, start=begin + 1):
        if match := _OPTION.fullmatch(line.rstrip()):
            options.append(_Option(match[1], bool(match[2]), match[3], '', offset))
        elif line.startswith('- ') or options and line.strip() and not line.startswith('  '):
            raise CellError(offset, 'a line of a quiz that is neither an option nor a reason', f'write {EXAMPLE}')
        elif options:
            options[-1].reason = f'{options[-1].reason} {line.strip()}'.strip()
        elif line.strip():
            question.append(line.strip())
    if not question:
        raise CellError(begin, 'a quiz without a question', 'write it above the options')
    if len(options) < 2 or [option.letter for option in options] != list(ascii_lowercase[: len(options)]):
        raise CellError(begin, 'the options of a quiz are not (a), (b), …', f'write {EXAMPLE}')
    if sum(option.right for option in options) != 1:
        raise CellError(begin, 'a quiz needs one right option', 'mark it as in (b, right)')
    for option in options:
        if not option.reason:
            raise CellError(option.offset, f'option ({option.letter}) has no reason', 'write it below, indented')
    return ' '.join(question), options


def _details(option: _Option) -> list[str]:
    # In a summary Markdown means nothing, so it is HTML; blank lines around the reason make it Markdown again.
    summary = MarkdownIt().renderInline(option.text)
    verdict = '✓ **Right.**' if option.right else '✗ **No.**'
    return [
        f'<details><summary>({option.letter}) {summary}</summary>',
        '',
        f'{verdict} {option.reason}',
        '',
        '</details>',
    ]
