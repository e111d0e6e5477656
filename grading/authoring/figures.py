"""Figures in the chapters: the directive that places one, and the files that are made of them.

The directive stands in prose, with the caption as its body::

    ```{figure} qos_ladder
    Each offer against each request.
    ```

The figure is drawn by `solutions/figures/qos_ladder.py` (see `grading.authoring.drawing`), and kept as
`notebooks/figures/qos_ladder.svg`. Both notebooks of the chapter show this one file.
"""

import re
import runpy
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from grading.authoring.chapter_errors import AuthoringError, CellError
from grading.authoring.drawing import Sheet

FOLDER = 'figures'  # in solutions/, with what draws them, and in notebooks/, with the pictures
EXAMPLE = '```{figure} NAME'
_BEGIN = re.compile(r'```+\s*\{figure\}(.*)')
_NAME = re.compile(r'[a-z][a-z0-9_]*')
_UNFIT = re.compile(r'[\[\]\n`*<>]')  # in the text of a picture, Markdown reads them as marks


class FigureError(CellError):
    """A mistake in a directive."""


@dataclass(frozen=True)
class Figure:
    """A figure as its file describes it."""

    name: str
    alt: str
    sheet: Sheet
    svg: str


@dataclass(frozen=True)
class Placed:
    """The text of a Markdown cell with its figures."""

    solved: str  # as the solved notebook has it, from solutions/
    learner: str
    names: tuple[str, ...]


def place(source: str, shown: str, folder: Path) -> Placed:
    """Put the figures of a Markdown cell in the place of their directives.

    :param source: the cell as its author wrote it; mistakes are told with its lines.
    :param shown: the same without other directives.
    :param folder: where the figures are drawn.
    :raises FigureError: a directive is wrong, or its figure is.
    """
    names = []
    for offset, name, caption in _directives(source):
        if not _NAME.fullmatch(name):
            raise FigureError(offset, f'a figure cannot be called {name!r}', f'write {EXAMPLE}, as its file is called')
        if not caption:
            raise FigureError(offset, f'the figure {name} has no caption', 'write a sentence below the directive')
        path = folder / f'{name}.py'
        if not path.is_file():
            raise FigureError(offset, f'there is no figure {name!r}', f'draw it in solutions/{FOLDER}/{name}.py')
        try:
            load(path)
        except AuthoringError as error:
            mistake = f'{FOLDER}/{path.name}:{error.line}'
            raise FigureError(offset, f'the figure {name}: {error.problem}', f'{error.remedy} ({mistake})') from None
        names.append(name)
    return Placed(_filled(shown, folder, f'../notebooks/{FOLDER}'), _filled(shown, folder, FOLDER), tuple(names))


def load(path: Path) -> Figure:
    """Draw the figure of a file.

    :raises AuthoringError: the file fails, or lacks something.
    """
    return _loaded(path, path.read_text(encoding='utf-8'))


@lru_cache(maxsize=256)
def _loaded(path: Path, text: str) -> Figure:
    """The same; the text is there so that a file which has changed is read again."""
    try:
        names = runpy.run_path(str(path))
    except Exception as error:
        raise AuthoringError(path, _line(error, path), f'{type(error).__name__}: {error}', 'correct it') from error
    alt, draw = names.get('ALT'), names.get('draw')
    if not isinstance(alt, str) or not alt.strip():
        raise AuthoringError(path, 1, 'no alternative text', "say in ALT = '...' what the figure shows")
    if found := _UNFIT.search(alt):
        raise AuthoringError(path, 1, f'ALT has a {found[0]!r}', 'write plain sentences in one line')
    if not callable(draw):
        raise AuthoringError(path, 1, 'no function draw()', 'write one that returns a Sheet')
    try:
        sheet = draw()
    except Exception as error:
        raise AuthoringError(path, _line(error, path), f'{type(error).__name__}: {error}', 'correct it') from error
    if not isinstance(sheet, Sheet):
        raise AuthoringError(path, 1, 'draw() returns no Sheet', 'return the sheet at its end')
    return Figure(path.stem, alt, sheet, sheet.svg(path.stem, alt))


def drawn(folder: Path) -> list[Path]:
    """The files of all figures, in order."""
    return sorted(path for path in folder.glob('*.py') if not path.name.startswith('_'))


def check(folder: Path, used: Iterable[str]) -> list[AuthoringError]:
    """Return a mistake for each figure that no chapter shows."""
    shown = set(used)
    return [
        AuthoringError(path, 1, f'no chapter shows the figure {path.stem}', f'place it by {EXAMPLE}, or remove it')
        for path in drawn(folder)
        if path.stem not in shown
    ]


def pictures(folder: Path) -> dict[str, str]:
    """The pictures of all figures: their SVG by the file's name."""
    return {f'{path.stem}.svg': load(path).svg for path in drawn(folder)}


def _directives(source: str) -> list[tuple[int, str, str]]:
    """Offset, name and caption of each directive."""
    lines, found, index = source.split('\n'), [], 0
    while index < len(lines):
        match = _BEGIN.fullmatch(lines[index].rstrip())
        if match:
            end = _end(lines, index)
            found.append((index, match[1].strip(), ' '.join(lines[index + 1 : end]).strip()))
            index = end
        index += 1
    return found


def _end(lines: list[str], begin: int) -> int:
    for index in range(begin + 1, len(lines)):
        if lines[index].startswith('```'):
            return index
    raise FigureError(begin, 'the directive of a figure has no end', 'close it with ```')


def _filled(shown: str, folder: Path, address: str) -> str:
    lines, result, index = shown.split('\n'), [], 0
    while index < len(lines):
        match = _BEGIN.fullmatch(lines[index].rstrip())
        if match:
            end, figure = _end(lines, index), load(folder / f'{match[1].strip()}.py')
            caption = ' '.join(lines[index + 1 : end]).strip()
            result += [f'![{figure.alt}]({address}/{figure.name}.svg)', '', f'*{caption}*']
            index = end
        else:
            result.append(lines[index])
        index += 1
    return '\n'.join(result)


def _line(error: BaseException, path: Path) -> int | None:
    """The line of the file in which an error arose."""
    if isinstance(error, SyntaxError):
        return error.lineno
    step, line = error.__traceback__, None
    while step:
        if step.tb_frame.f_code.co_filename == str(path):
            line = step.tb_lineno
        step = step.tb_next
    return line
