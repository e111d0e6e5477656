"""Cards of exercises: the directive that declares an exercise, and the roles that name the rules of its card.

The directive stands where the card's heading comes::

    ```{exercise} 3.1 a beacon
    :points: 10
    :names: Beacon
    ```

`names` are what the answer cell must define, `check` (optional) the tags of the check cell. With `folder`, such as
`my_ws/src/patrol`, the answer is a package in this folder beside the notebook: see `helpers.exercises.package_answers`.
`earlier` is how the digests begin of stubs that earlier versions of the course gave: an exercise with one of these is
not attempted either.

In the card's Markdown, from the directive to the answer cell, the role ``{rule}`rate` `` names the rule that the text
after it states: the rest of the list item or paragraph, or the text up to the next role.
"""

import re
from dataclasses import dataclass

import yaml

from grading.authoring.chapter_errors import CellError
from helpers.exercises import package_answers
from helpers.exercises.manifest import Rule

LEVEL = '###'
CHECK_TAGS = ('nbval-ignore-output',)
BEGIN = re.compile(r'```+\s*\{exercise\}(.*)')
_HEAD = re.compile(r'(\d+\.[1-9]\d*)\s+(\S.*)')
_ROLE = re.compile(r'\{rule\}`([^`\n]*)`[ \t]*')
_NAME = re.compile(r'[a-z][a-z0-9]*([-_][a-z0-9]+)*')
_ITEM = re.compile(r'(\s*)([-*+]|\d+[.)])\s+')
EXAMPLE = '```{exercise} 3.1 a beacon'
_OPTIONS = ('points', 'names', 'check', 'folder', 'earlier')
_EARLIER = re.compile(r'[0-9a-f]{12,64}')
_FOLDER = re.compile(r'\w+_ws/src/\w+')


class CardError(CellError):
    """A mistake in a card."""


@dataclass(frozen=True)
class Card:
    """What the directive declares."""

    id: str
    title: str
    points: float
    names: tuple[str, ...]
    check_tags: tuple[str, ...]
    folder: str = ''
    earlier: tuple[str, ...] = ()

    @property
    def heading(self) -> str:
        """The card's heading, a line of Markdown."""
        return f'{LEVEL} Exercise {self.id}: {self.title} ({self.points} point{"" if self.points == 1 else "s"})'

    @property
    def first_line(self) -> str:
        """The answer cell's first line."""
        return f'# Exercise {self.id}: {self.title}'

    @property
    def check(self) -> str:
        """The check cell's text."""
        return f'check("{self.id}")'

    @property
    def metadata(self) -> dict:
        """What the answer cell's metadata say of the exercise."""
        place = {'folder': self.folder} if self.folder else {}
        return {'id': self.id, 'points': self.points, 'names': list(self.names)} | place


@dataclass(frozen=True)
class MarkdownCell:
    """A Markdown cell, read."""

    text: str  # as the notebooks show it
    card: Card | None  # that is declared in it
    rules: tuple[tuple[int, Rule], ...]  # with the offset of the line of each
    begin: int = 0  # offset of the line of the directive


def read(source: str, chapter: int, in_card: bool) -> MarkdownCell:
    """Read a Markdown cell. `in_card` says that the card of an exercise goes on in it.

    :raises CardError: a directive or a role is wrong, or a role stands outside of a card.
    """
    lines, card, begin, shown = source.split('\n'), None, 0, []
    index = 0
    while index < len(lines):
        match = BEGIN.fullmatch(lines[index].rstrip())
        if not match:
            shown.append(lines[index])
            index += 1
            continue
        if card is not None or in_card:
            raise CardError(index, 'an exercise inside the card of another', 'write its answer cell before this')
        end = next((k for k in range(index + 1, len(lines)) if lines[k].strip().startswith('```')), None)
        if end is None:
            raise CardError(index, 'the directive of an exercise has no end', 'close it with ```')
        card, begin = declared(match[1].strip(), lines[index + 1 : end], index, chapter), index
        shown.append(card.heading)
        index = end + 1
    found = [(index, match) for index, line in enumerate(lines) for match in _ROLE.finditer(line)]
    for index, _ in found:
        if not in_card and (card is None or index < begin):
            raise CardError(
                index, 'a rule outside of the card of an exercise', 'write it between the directive and the answer cell'
            )
    rules = tuple(_rule(lines, index, match) for index, match in found)
    return MarkdownCell(_ROLE.sub(lambda match: f'**{match[1]}**: ', '\n'.join(shown)), card, rules, begin)


def declared(head: str, options: list[str], offset: int, chapter: int) -> Card:
    """Return the card of a directive, from the text behind its name and the lines of its options."""
    match = _HEAD.fullmatch(head)
    if not match:
        raise CardError(offset, f'exercise {head!r} without id or title', f'write {EXAMPLE}')
    identity, title = match[1], match[2].strip()
    label = f'exercise {identity}'
    if identity.partition('.')[0] != str(chapter):
        raise CardError(offset, f'{label} in chapter {chapter}', f'give it the id {chapter}.N')
    values = {}
    for number, line in enumerate(options, start=offset + 1):
        option = re.fullmatch(r':(\w+):\s*(.*?)\s*', line)
        if not option and line.strip():
            raise CardError(number, f'{label} has a line that is no option', 'write :name: value')
        if option and (option[1] not in _OPTIONS or option[1] in values):
            raise CardError(
                number,
                f'{label} has an option {option[1]!r} that is unknown or given twice',
                f'use {", ".join(_OPTIONS)}, each once',
            )
        if option:
            values[option[1]] = option[2]
    try:
        points = yaml.safe_load(values.get('points', ''))
    except yaml.YAMLError:
        points = None
    if isinstance(points, bool) or not isinstance(points, (int, float)) or not points > 0:
        raise CardError(offset, f'{label} without points', 'add :points: N, more than 0')
    names = tuple(filter(None, re.split(r'[,\s]+', values.get('names', ''))))
    if not names or not all(name.isidentifier() for name in names):
        raise CardError(offset, f'{label} without names', 'add :names: what the answer cell must define')
    tags = tuple(filter(None, re.split(r'[,\s]+', values.get('check', ''))))
    folder = values.get('folder', '')
    if folder and (not _FOLDER.fullmatch(folder) or names != (package_answers.NAME,)):
        raise CardError(
            offset,
            f'{label} has the folder {folder!r} and the names {", ".join(names)}',
            f'write :folder: NAME_ws/src/PACKAGE and :names: {package_answers.NAME}',
        )
    earlier = tuple(part.strip() for part in values.get('earlier', '').split(',') if part.strip())
    if wrong := [part for part in earlier if not _EARLIER.fullmatch(part)]:
        raise CardError(offset, f'{label} has the earlier digest {wrong[0]!r}', 'write 12 hexadecimal digits or more')
    return Card(identity, title, points, names, tags or CHECK_TAGS, folder, earlier)


def _rule(lines: list[str], index: int, match: re.Match) -> tuple[int, Rule]:
    """The rule that a role names, with the offset of its line."""
    name = match[1]
    if not _NAME.fullmatch(name):
        raise CardError(
            index, f'the name of a rule cannot be {name!r}', 'use words in lower case with hyphens or underscores'
        )
    parts = [lines[index][match.end() :]]
    item = _ITEM.match(lines[index])
    for line in lines[index + 1 :]:
        other = _ITEM.match(line)
        nested = item and len(line) - len(line.lstrip()) > len(item[1])
        if not line.strip() or line.lstrip().startswith(('```', '#', '<')) or other and not nested:
            break
        parts.append(line[other.end() :] if other else line)
    text = plain('\n'.join(parts).partition('{rule}`')[0])
    if not text:
        raise CardError(index, f'the rule {name!r} has no text', 'write its sentence after it')
    return index, Rule(name, text)


def plain(markdown: str) -> str:
    """Return Markdown as one line without its marks; what is in backticks keeps them."""
    spans: list[str] = []

    def keep(match: re.Match) -> str:
        spans.append(match[0])
        return f'\0{len(spans) - 1}\0'

    text = re.sub(r'(`+).+?\1', keep, markdown, flags=re.DOTALL)
    text = re.sub(r'!?\[([^\]]*)\]\((?:[^()]|\([^()]*\))*\)', r'\1', text)
    for mark in (r'\*\*\*', r'\*\*', r'\*'):
        text = re.sub(rf'{mark}(?=\S)(.+?)(?<=\S){mark}', r'\1', text, flags=re.DOTALL)
    text = re.sub(r'(?<!\w)(_{1,2})(?=\S)(.+?)(?<=\S)\1(?!\w)', r'\2', text, flags=re.DOTALL)
    text = re.sub(r'\0(\d+)\0', lambda match: spans[int(match[1])], text)
    return ' '.join(text.split())
