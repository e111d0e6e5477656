"""Where to read on: the section of the notebook in which an exercise stands."""

import json
import re
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from helpers import paths

_HEADING = re.compile(r'^(#{1,3})\s+(.+?)\s*#*$', re.MULTILINE)
_FENCE = re.compile(r'^(```|~~~).*?^\1', re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Place:
    """A section of a notebook. `parts` are the titles within it, up to the exercise."""

    notebook: str
    chapter: str  # '3. Nodes and topics'
    section: str = ''  # '3.8 Quality of service'; empty if the exercise stands before the first one
    parts: tuple[str, ...] = ()


def place(exercise: str) -> Place | None:
    """The place of an exercise of this course; None if its notebook is not there."""
    return next((found[exercise] for notebook in _notebooks() if exercise in (found := places(notebook))), None)


@lru_cache(maxsize=1)
def _notebooks() -> tuple[str, ...]:
    return tuple(path.name for path in sorted(paths.NOTEBOOKS.glob('*.ipynb')))


@lru_cache(maxsize=64)
def places(notebook: str, folder: Path = paths.NOTEBOOKS) -> dict[str, Place]:
    """The place of each exercise of a notebook, by the exercise's id; empty if the notebook cannot be read."""
    try:
        cells = json.loads((folder / notebook).read_text(encoding='utf-8'))['cells']
        texts = [''.join(cell['source']) for cell in cells if cell['cell_type'] == 'markdown']
    except (OSError, ValueError, KeyError, TypeError):
        return {}
    chapter = section = ''
    parts: list[str] = []
    found = {}
    for mark, title in (match.groups() for text in texts for match in _HEADING.finditer(_FENCE.sub('', text))):
        if exercise := re.match(r'Exercise (\d+\.\d+)\b', title):
            found[exercise[1]] = Place(notebook, chapter, section, tuple(parts))
        elif mark == '#':
            chapter, section, parts = title, '', []
        elif mark == '##':
            section, parts = title, []
        else:
            parts.append(title)
    return found
