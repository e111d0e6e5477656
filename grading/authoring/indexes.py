"""Pages for all chapters, made from their sources: the glossary, and the index of symptoms."""

import re
from pathlib import Path

from grading.authoring import glossary, references, table_names
from grading.authoring.book import Book, Heading, prose

SYMPTOMS = 'SYMPTOMS.md'
PAGES = (glossary.PAGE, SYMPTOMS)
_CELL = re.compile(r'(?<!\\)\|')
_WRONG = 'When it goes wrong'


def pages(folder: Path, book: Book) -> dict[str, str]:
    """Return the pages by file name, those that have something to say.

    :param folder: of the sources.
    :raises CellError: a role in a table of symptoms is wrong.
    """
    made = {glossary.PAGE: _glossary(book), SYMPTOMS: _symptoms(folder, book)}
    return {name: table_names.marked(text) for name, text in made.items() if text}


def new_words(book: Book, chapter: int) -> str:
    """Return links to the terms that are used first in this chapter, as Markdown; empty if there are none."""
    mine = [name for name, uses in book.uses.items() if uses[0].chapter == chapter and name in book.terms]
    return ' · '.join(f'[{name}]({book.terms[name].address})' for name in sorted(mine, key=str.lower))


def _glossary(book: Book) -> str:
    entries = []
    for name in sorted(book.terms, key=str.lower):
        term = book.terms[name]
        said = [term.says]
        if (uses := book.uses.get(name)) and (place := uses[0].place):
            said.append(f'First in [section {place.number}]({place.address}).')
        if term.link:
            said.append(f'More: [docs.ros.org]({term.link}).')
        entries.append(f'## {name}\n\n{" ".join(said)}\n')
    if not entries:
        return ''
    head = '# Glossary\n\nThe words of this course, from A to Z, each with the section that uses it first.\n'
    return '\n'.join([head, *entries])


def _symptoms(folder: Path, book: Book) -> str:
    parts = []
    for number, notebook in sorted(book.chapters.items()):
        lines = (folder / notebook).with_suffix('.md').read_text(encoding='utf-8').splitlines()
        if rows := _rows(lines, number, book):
            table = '\n'.join(
                f'| {symptom} | {cause} | [{place.number}]({place.address}) |' for symptom, cause, place in rows
            )
            parts.append(f'## {book.titles[notebook]}\n\n| symptom | cause | section |\n|---|---|---|\n{table}\n')
    if not parts:
        return ''
    head = (
        '# Symptoms\n\nWhat you see, and what its cause often is, from all chapters. '
        'The section says how to make sure, and what to do.\n'
    )
    return '\n'.join([head, *parts])


def _rows(lines: list[str], chapter: int, book: Book) -> list[tuple[str, str, Heading]]:
    """Symptom, cause and section of each row of a chapter's table."""
    rows, header, place = [], None, None
    for _, line in prose(lines):
        if line.startswith('## '):
            sections = [one for one in book.sections.values() if one.notebook == book.chapters[chapter]]
            place = next((one for one in sections if one.heading.endswith(_WRONG) and _WRONG in line), None)
            header = None
        if place is None or not line.startswith('|'):
            continue
        cells = [cell.strip() for cell in _CELL.split(references.render(line, book).strip().strip('|'))]
        if header is None:
            header = cells
        elif set(line) - set('|-: '):
            symptom = cells[header.index('symptom')]
            cause = cells[next(k for k, name in enumerate(header) if name.endswith('cause'))]
            rows.append((symptom, cause, book.sections.get(cells[0], place)))
    return rows
