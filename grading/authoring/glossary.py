"""The course's words: `solutions/glossary.yml`, a list of terms with what they mean.

Each entry has `term`, `says` (one or two sentences, Markdown) and, optionally, `link`, a page of docs.ros.org. Where a
term is used first is not written here: the role ``{term}`callback group` `` says so in the chapters.
"""

from dataclasses import dataclass
from pathlib import Path

import yaml

from grading.authoring.chapter_errors import AuthoringError

FILE = 'glossary.yml'
PAGE = 'GLOSSARY.md'


@dataclass(frozen=True)
class Term:
    """An entry."""

    name: str
    says: str
    link: str
    line: int  # in the file

    @property
    def anchor(self) -> str:
        """The id of its heading."""
        return self.name.replace(' ', '-')

    @property
    def address(self) -> str:
        """Where a link to it leads."""
        return f'{PAGE}#{self.anchor}'


def read(path: Path) -> dict[str, Term]:
    """Read the entries; none if there is no file.

    :raises AuthoringError: it cannot be read, or an entry is not complete or there twice.
    """
    if not path.is_file():
        return {}
    text = path.read_text(encoding='utf-8')
    try:
        entries, nodes = yaml.safe_load(text), yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.YAMLError as error:
        mark = getattr(error, 'problem_mark', None)
        raise AuthoringError(path, mark.line + 1 if mark else 1, 'no YAML', 'mend what stands there') from None
    if not isinstance(entries, list) or not isinstance(nodes, yaml.SequenceNode):
        raise AuthoringError(path, 1, 'no list of terms', 'write - term: …')
    terms: dict[str, Term] = {}
    for entry, node in zip(entries, nodes.value, strict=True):
        line = node.start_mark.line + 1
        if not isinstance(entry, dict) or not {'term', 'says'} <= set(entry) <= {'term', 'says', 'link'}:
            raise AuthoringError(path, line, 'an entry needs term and says, and may have link', 'complete it')
        term = Term(str(entry['term']), ' '.join(str(entry['says']).split()), str(entry.get('link', '')), line)
        if term.name in terms:
            raise AuthoringError(path, line, f'the term {term.name!r} is there twice', 'keep one')
        terms[term.name] = term
    return terms
