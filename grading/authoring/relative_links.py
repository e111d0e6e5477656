"""Checks that every relative link of a chapter leads somewhere."""

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

from grading.authoring.book import HEADING, Book, prose
from grading.authoring.indexes import PAGES

_SPAN = re.compile(r'(`+)(?!`).*?(?<!`)\1(?!`)')
_LINK = re.compile(r'\]\(\s*<?([^)>\s]+)>?[^)]*\)|\b(?:href|src)="([^"]+)"')
_ABROAD = re.compile(r'[a-zA-Z][a-zA-Z0-9+.-]*:|//')  # with a scheme


def broken(text: str, notebook: str, book: Book, folder: Path) -> Iterator[tuple[int, str, str]]:
    """Yield offset, problem and remedy of each link in a Markdown cell that leads nowhere.

    :param notebook: in which the cell stands; :param folder: where the notebooks are.
    """
    for offset, line in prose(text.split('\n')):
        for match in _LINK.finditer(_SPAN.sub('', line)):
            target = match[1] or match[2]
            if _ABROAD.match(target):
                continue
            path, _, fragment = target.partition('#')
            page = unquote(path) or notebook
            if page in PAGES:
                continue
            if page not in book.anchors:
                if not (folder / page).exists():
                    yield offset, f'a link to {target!r}, which does not exist', 'mend its path, seen from notebooks/'
            elif fragment and unquote(fragment).removeprefix(HEADING) not in book.anchors[page]:
                yield (
                    offset,
                    f'a link to {target!r}: {page} has no such heading',
                    'write {section}`N.M`, or the heading with - for blanks',
                )
