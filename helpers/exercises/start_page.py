"""The page on which JupyterLab opens: the chapters, what they teach, how long they take, and the learner's progress.

Everything in it comes from the notebooks' first cells, the list of exercises and the marks of the checks, so that it
always agrees with them.
"""

import json
import re
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from environment.setup import whole_file
from helpers import paths
from helpers.exercises import manifest, progress_file

FILE = 'START.md'
# Pages for all chapters beside the notebooks, made by the build.
PAGES = (('GLOSSARY.md', 'glossary'), ('SYMPTOMS.md', 'symptoms and their causes'))
_STEPS = 10  # boxes in a bar

_TEMPLATE = """\
# ROS 2 from zero

Eight notebooks, from the first command to a robot that obeys you. Open a chapter with a click, or press Tab until its
name is marked, then Enter. {% if next %}**Go on with [{{ next.says.title }}]({{ next.notebook }}).**{% else %}\
**You have solved every exercise.**{% endif %}


| chapter | time | exercises solved | rules kept | points |
|---|---|---|---|---|
{% for one in chapters %}
| [{{ one.says.title }}]({{ one.notebook }}) | {{ one.says.time }} \
| {{ one.bar }} {{ one.solved }} of {{ one.exercises }} | {{ one.kept }} of {{ one.rules }} \
| {{ one.score }} of {{ one.points }} |
{% endfor %}
| **all chapters** | | **{{ solved }} of {{ exercises }}** | **{{ kept }} of {{ rules }}** \
| **{{ score }} of {{ points }}** |

{% if damaged or missing %}
> {% if missing %}**Not in this folder:** {{ missing | join(', ') }}. {% endif %}
{% if damaged %}**Damaged, cannot be opened:** {{ damaged | join(', ') }}. {% endif %}
Take a fresh copy from the course as you got it. What you last saved may be in the folder `.ipynb_checkpoints`.

{% endif %}
An exercise is solved when its last check has seen every rule of its card kept, as far as this machine can look. The
points are those of that check. Graders judge the same rules again, with other values.

| key | does |
|---|---|
| Shift+Enter | run the cell, go to the next one |
| Enter, Esc | write in the cell, leave it |
| A, B | (outside of a cell) a new cell above, below |
| 0 0 | restart the kernel: everything is forgotten, nothing is lost in the notebook |

To go on in the middle of a chapter after a restart, add a cell there with `from helpers import resume; resume()`, save
the notebook and run the cell: it brings back what the cells above it define, without their demonstrations.

{% if pages %}
For all chapters: {% for name, title in pages %}[{{ title }}]({{ name }}){{ ' · ' if not loop.last }}{% endfor %}.

{% endif %}
A second terminal with ROS in it: `./course shell`. Chapters that are open at the same time share one ROS domain: the
nodes of one are in the graph of the other. When you are done: `./course submit --id YOUR-NAME`.

{% for one in chapters %}
## {{ one.says.title }}

> {{ one.says.thesis }}

{{ one.says.goals }}

[Open chapter {{ one.number }}]({{ one.notebook }})\
{% if one.open %} · still open: {{ one.open | join(', ') }}{% endif %}


{% endfor %}
_This page is made anew when JupyterLab starts, and after each check. Close it and open it again to see the new one._
"""


@dataclass(frozen=True)
class Introduction:
    """What a chapter's first cell says."""

    title: str  # '3. Nodes and topics'
    thesis: str
    goals: str  # Markdown
    time: str  # 'three hours'


@dataclass(frozen=True)
class ChapterRow:
    """What a chapter's notebook says of itself, and how far the learner is."""

    number: int
    notebook: str
    says: Introduction
    exercises: int
    solved: int
    rules: int
    kept: int
    points: str
    score: str
    open: list[str]  # exercises that are not solved
    readable: bool

    @property
    def bar(self) -> str:
        full = _STEPS * self.solved // self.exercises if self.exercises else _STEPS
        return '■' * full + '□' * (_STEPS - full)


def write(folder: Path = paths.NOTEBOOKS) -> Path:
    """Write the page into the folder of the notebooks and return its path.

    :raises OSError: the folder cannot be written to.
    :raises helpers.exercises.manifest.ManifestError: the list of exercises is damaged.
    """
    whole_file.write(folder / FILE, text(folder))
    return folder / FILE


def keep(report, folder: Path = paths.NOTEBOOKS) -> None:
    """Note what a check has found (`helpers.runner.session.SessionReport`) and make the page anew.

    A folder that cannot be written to changes nothing.
    """
    from filelock import Timeout

    with suppress(OSError, Timeout, manifest.ManifestError):
        progress_file.note(report, folder)
        write(folder)


def text(folder: Path = paths.NOTEBOOKS) -> str:
    """The page as Markdown."""
    from jinja2 import Environment  # imported here, so that a notebook's start does not wait for it

    known = manifest.load()
    found = progress_file.load(folder)
    chapters = [_chapter(path, known, found) for path in sorted(folder.glob('[0-9][0-9]_*.ipynb'))]
    mine = [exercise for exercise in known.values() if any(exercise.notebook == one.notebook for one in chapters)]
    return (
        Environment(trim_blocks=True, lstrip_blocks=True)
        .from_string(_TEMPLATE)
        .render(
            chapters=chapters,
            next=next((one for one in chapters if one.open and one.readable), None),
            pages=[(name, title) for name, title in PAGES if (folder / name).is_file()],
            damaged=[f'`{one.notebook}`' for one in chapters if not one.readable],
            missing=[
                f'`{name}`'
                for name in sorted({exercise.notebook for exercise in known.values()})
                if not (folder / name).is_file()
            ],
            solved=sum(one.solved for one in chapters),
            exercises=len(mine),
            kept=sum(one.kept for one in chapters),
            rules=sum(one.rules for one in chapters),
            points=_number(sum(exercise.points for exercise in mine)),
            score=_number(sum(found[exercise.id].score for exercise in mine if exercise.id in found)),
        )
    )


def introduction(path: Path) -> Introduction:
    """Read a chapter's first cell. What is not in it is empty; the title is then the file's name."""
    head = _head(path) or ''

    def said(pattern: str, default: str = '') -> str:
        match = re.search(pattern, head, re.MULTILINE | re.DOTALL)
        return ' '.join(match[1].split()) if match else default

    goals = re.search(r'^\*\*Goals\.\*\*.*?(?=^\*\*|\Z)', head, re.MULTILINE | re.DOTALL)
    return Introduction(
        said(r'^# (.+?)$', path.stem),
        said(r'^> (.+?)$'),
        goals[0].strip() if goals else '',
        said(r'^\*\*Time\.\*\* (?:About )?(.+?)(?: with .*?)?\.$'),
    )


def _chapter(path: Path, known: dict, found: dict[str, progress_file.Mark]) -> ChapterRow:
    mine = [exercise for exercise in known.values() if exercise.notebook == path.name]
    still = [exercise.id for exercise in mine if exercise.id not in found or not found[exercise.id].passed]
    return ChapterRow(
        int(path.name[:2]),
        path.name,
        introduction(path),
        len(mine),
        len(mine) - len(still),
        sum(len(exercise.rules) for exercise in mine),
        sum(min(found[exercise.id].kept, len(exercise.rules)) for exercise in mine if exercise.id in found),
        _number(sum(exercise.points for exercise in mine)),
        _number(sum(found[exercise.id].score for exercise in mine if exercise.id in found)),
        still,
        _head(path) is not None,
    )


def _head(path: Path) -> str | None:
    """The notebook's first cell; None if the notebook cannot be read."""
    try:
        source = json.loads(path.read_text(encoding='utf-8'))['cells'][0]['source']
    except (OSError, ValueError, LookupError, TypeError):
        return None
    return source if isinstance(source, str) else ''.join(source)


def _number(value: float) -> str:
    return f'{value:.2f}'.rstrip('0').rstrip('.')
