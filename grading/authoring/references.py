"""Roles that become links: ``{section}`8.10` ``, ``{exercise-ref}`3.1` ``, ``{chapter}`5` ``,
``{term}`callback group` ``.

A role may have a text of its own: ``{section}`the recording <8.10>` ``. Links lead from notebook to notebook of the
same folder; the web edition gives them the names of its pages.
"""

import re
from functools import partial

from grading.authoring import glossary
from grading.authoring.book import ROLE, Book, prose, target
from grading.authoring.chapter_errors import CellError

_REST_OF_LINK = re.compile(r'[^\[\]]*\]\(')  # what follows a role in the text of a link

ROLES = ('section', 'exercise-ref', 'chapter', 'term')
_ELSEWHERE = ('rule',)  # roles that others read


def render(source: str, book: Book) -> str:
    """Return `source` with its roles as links, line by line.

    :raises CellError: an unknown role, one within a link, or what it refers to does not exist.
    """
    lines = source.split('\n')
    for offset, line in prose(lines):
        lines[offset] = ROLE.sub(partial(_link, offset=offset, book=book), line)
    return '\n'.join(lines)


def _link(match: re.Match, offset: int, book: Book) -> str:
    role, content = match[1], match[2]
    if role is None or role in _ELSEWHERE:
        return match[0]
    if role not in ROLES:
        raise CellError(offset, f'unknown role {role!r}', f'use one of {", ".join((*ROLES, *_ELSEWHERE))}')
    if _REST_OF_LINK.match(match.string, match.end()):
        problem = f'the role {role!r} is in the text of a link: Markdown has no link in a link'
        raise CellError(offset, problem, 'write one after the other')
    wanted, text = target(content)
    if role == 'term':
        if wanted not in book.terms:
            raise CellError(offset, f'the glossary has no term {wanted!r}', f'enter it in {glossary.FILE}')
        return f'[*{text or wanted}*]({book.terms[wanted].address})'
    if role == 'chapter':
        number = int(wanted) if wanted.isdecimal() else None
        if number not in book.chapters:
            raise CellError(offset, f'there is no chapter {wanted!r}', 'refer to one that exists')
        return f'[{text or f"chapter {number}"}]({book.chapters[number]})'
    kind, places = ('section', book.sections) if role == 'section' else ('exercise', book.exercises)
    if wanted not in places:
        near = [name for name in places if name.partition('.')[0] == wanted.partition('.')[0]]
        remedy = f'there are: {", ".join(near)}' if near else 'refer to one that exists'
        raise CellError(offset, f'there is no {kind} {wanted!r}', remedy)
    if not places[wanted].linkable:
        problem = f'the heading of {kind} {wanted} has characters at which a link in JupyterLab fails'
        raise CellError(offset, problem, 'write it with letters, digits and simple signs, without quotes')
    return f'[{text or f"{kind} {wanted}"}]({places[wanted].address})'
