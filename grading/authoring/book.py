"""What the chapters say of each other: their headings and exercises, to which a link may lead, and the uses of terms.

The sources are scanned, not read: a link may lead to a chapter that has mistakes of its own.
"""

import html
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from markdown_it import MarkdownIt

from grading.authoring import cards, glossary
from grading.authoring.chapter_errors import CellError

FILE_NAME = re.compile(r'(\d\d)_[a-z0-9_]+\.md')
HEADING = 'heading='  # a fragment's kind, of JupyterLab; web pages have none
_HEADING = re.compile(r'#{1,6}\s+(\S.*?)\s*')
# A span of code is taken first, so that `{name}` inside of one is no role.
ROLE = re.compile(r'\{([a-z][a-z-]*)\}`([^`\n]*)`|(`+)(?!`).*?(?<!`)\3(?!`)')
_OWN_TEXT = re.compile(r'(\S.*?)\s*<([^<>]+)>')
_PLAIN = re.compile(r"[A-Za-z0-9\-._~:;,'()/?!*+=&@$]+")
_NUMBER = re.compile(r'([A-Z]?\d+\.\d+)\s')
PROSE = ('{quiz}', '{figure}')  # directives whose bodies are text
_FENCE = re.compile(r'\s*(`{3,}|~{3,})(.*)')


@dataclass(frozen=True)
class Heading:
    """A heading of a chapter."""

    notebook: str
    heading: str  # its text, without marks

    @property
    def number(self) -> str:
        """The number at its beginning."""
        return self.heading.split()[0]

    @property
    def anchor(self) -> str:
        """The heading's id, as JupyterLab and nbconvert make it."""
        return self.heading.replace(' ', '-')

    @property
    def address(self) -> str:
        """Where a link to it leads, for a reader of JupyterLab.

        Only with ``heading=`` does JupyterLab find a heading that it has not drawn yet, and only with the notebook's
        name does it look for one in the same notebook.
        """
        return f'{self.notebook}#{HEADING}{self.anchor}'

    @property
    def linkable(self) -> bool:
        """Whether JupyterLab finds it: it compares the link with the heading as browsers write it, escapes and all."""
        return bool(_PLAIN.fullmatch(self.anchor))


@dataclass(frozen=True)
class Use:
    """A place where a chapter marks a term."""

    chapter: int
    path: Path
    line: int
    place: Heading | None  # the section


@dataclass
class Book:
    """All chapters of a folder."""

    chapters: dict[int, str] = field(default_factory=dict)  # number -> notebook
    sections: dict[str, Heading] = field(default_factory=dict)  # '8.10', also 'A7.2'
    exercises: dict[str, Heading] = field(default_factory=dict)
    anchors: dict[str, set[str]] = field(default_factory=dict)  # notebook -> its anchors
    titles: dict[str, str] = field(default_factory=dict)  # notebook -> its title
    glossary_file: Path | None = None
    terms: dict[str, glossary.Term] = field(default_factory=dict)
    uses: dict[str, list[Use]] = field(default_factory=dict)  # of terms, in the order of the chapters


def sources(folder: Path) -> list[Path]:
    """Return the chapters' sources in ``folder``, in order."""
    return sorted(path for path in folder.glob('*.md') if FILE_NAME.fullmatch(path.name))


def load(folder: Path) -> Book:
    """Scan the sources in `folder`.

    :raises AuthoringError: the glossary has a mistake.
    """
    path = folder / glossary.FILE
    book = Book(glossary_file=path, terms=glossary.read(path))
    for path in sources(folder):
        _scan(path, book)
    return book


def prose(lines: list[str]) -> Iterator[tuple[int, str]]:
    """Yield the lines outside of fences, with their offsets; those of a quiz and of a figure are prose, too."""
    end, shown = '', True
    for offset, line in enumerate(lines):
        fence = _FENCE.fullmatch(line)
        if not end and fence and '`' not in fence[2]:
            end, shown = fence[1], fence[2].strip().startswith(PROSE)
        elif end and line.strip().startswith(end) and not line.strip().strip(end[0]):
            end, shown = '', True
        elif shown:
            yield offset, line


def target(content: str) -> tuple[str, str | None]:
    """Return what a role refers to, and its own text if it has one."""
    own = _OWN_TEXT.fullmatch(content.strip())
    return (own[2].strip(), own[1]) if own else (content.strip(), None)


def text_of(markdown: str) -> str:
    """Return one line of Markdown as a page shows it."""
    return html.unescape(re.sub(r'<[^>]*>', '', MarkdownIt().renderInline(markdown)))


def _scan(path: Path, book: Book) -> None:
    """Add what one source has."""
    number, notebook = int(path.name[:2]), f'{path.stem}.ipynb'
    lines = path.read_text(encoding='utf-8').splitlines()
    book.chapters[number] = notebook
    anchors = book.anchors[notebook] = set()
    section = None
    for offset, line in prose(lines):
        for role in ROLE.finditer(line):
            if role[1] == 'term':
                book.uses.setdefault(target(role[2])[0], []).append(Use(number, path, offset + 1, section))
        if not (match := _HEADING.fullmatch(line)):
            continue
        place = Heading(notebook, text_of(match[1]))
        book.titles.setdefault(notebook, place.heading)
        anchors.add(place.anchor)
        if named := _NUMBER.match(place.heading):
            section = book.sections.setdefault(named[1], place)
    for card in _cards(lines, number):
        place = Heading(notebook, text_of(card.heading.lstrip('# ')))
        anchors.add(place.anchor)
        book.exercises.setdefault(card.id, place)


def _cards(lines: list[str], chapter: int) -> Iterator[cards.Card]:
    """Yield the exercises that are declared without a mistake."""
    for offset, line in enumerate(lines):
        if match := cards.BEGIN.fullmatch(line.rstrip()):
            rest = lines[offset + 1 :]
            end = next((k for k, after in enumerate(rest) if after.strip().startswith('```')), 0)
            try:
                yield cards.declared(match[1].strip(), rest[:end], offset, chapter)
            except CellError:
                continue  # told when the chapter is read
