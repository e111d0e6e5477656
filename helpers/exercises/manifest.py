"""The list of all exercises, ``helpers/checks/exercises.json``; how a stub and a file of tests are recognised.

``./course build`` (grading.authoring) writes the list from the sources of the chapters; ``check``, ``submit`` and
``grade`` read it. Both sides take the format and the digest from here.
"""

import ast
import hashlib
import json
import re
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

from helpers.exercises import file_answers

MANIFEST = Path(__file__).resolve().parents[1] / 'checks' / 'exercises.json'
_TESTS = re.compile(r'(?:.*/)?(?:test_(\d+_\d+)|(\d+_\d+)/hidden)\.py')


@dataclass(frozen=True)
class Rule:
    """One sentence of an exercise's card that an answer can keep or break."""

    name: str  # 'rate'
    text: str  # 'It publishes 4 times a second, the first time one period after its start.'


@dataclass(frozen=True)
class Exercise:
    """One exercise, as its cell in the chapter's source declares it."""

    id: str  # '3.2'
    chapter: int
    notebook: str  # file name in notebooks/, '03_nodes_and_topics.ipynb'
    title: str
    points: float
    names: tuple[str, ...]  # what the cell must define
    cell_id: str  # 'ex-3-2'
    stub: str  # stub_digest of the cell as the learner gets it
    rules: tuple[Rule, ...] = ()  # in the order of the card
    folder: str = ''  # of the package that is the answer, from the folder of the notebooks on; else it is a cell
    earlier: tuple[str, ...] = ()  # how the digests of stubs begin that earlier versions of the course gave

    def is_stub(self, digest: str | None) -> bool:
        """Tell whether this is the digest of the cell as a learner gets it, or as one got it earlier."""
        return digest is not None and (digest == self.stub or digest.startswith(self.earlier or ('-',)))


class ManifestError(Exception):
    """The list of exercises is missing or damaged; the message names the remedy."""


def stub_digest(source: str) -> str:
    """Return the SHA-256 of the program that a cell is, the same for other comments, blank lines and layout.

    It hashes the syntax tree as ``ast.dump`` would show it, less the empty fields: which of those exist and which are
    printed differs between Python versions, and the digest must be the same in all of them.

    :raises SyntaxError: ``source`` does not parse.
    """
    return hashlib.sha256(_dump(ast.parse(file_answers.as_python(source))).encode()).hexdigest()


def tested_in(path: Path) -> str | None:
    """Return the exercise that a file's tests belong to; None if its path does not say.

    It is '3.1' for the visible tests, test_3_1.py, and for the hidden ones, 3_1/hidden.py.
    """
    found = _TESTS.fullmatch(path.as_posix())
    return (found[1] or found[2]).replace('_', '.') if found else None


def visible_tests(folder: Path, exercise: str) -> Path:
    """Return where the visible tests of `exercise`, such as '3.1', are; `folder` holds the chapters' folders."""
    chapter = int(exercise.partition('.')[0])
    return folder / f'chapter_{chapter:02}' / f'test_{exercise.replace(".", "_")}.py'


def hidden_tests(folder: Path, exercise: str) -> Path:
    """Return where the hidden tests of `exercise`, such as '3.1', are; `folder` holds the exercises' folders."""
    return folder / exercise.replace('.', '_') / 'hidden.py'


def load(path: Path = MANIFEST) -> dict[str, Exercise]:
    """Return all exercises by id, in the order of the chapters.

    :raises ManifestError: the file is missing or damaged.
    """
    try:
        rows = json.loads(path.read_text(encoding='utf-8'))['exercises']
        exercises = [
            Exercise(
                **{
                    **row,
                    'names': tuple(row['names']),
                    'rules': tuple(Rule(**rule) for rule in row.get('rules', ())),
                    'earlier': tuple(row.get('earlier', ())),
                }
            )
            for row in rows
        ]
    except FileNotFoundError:
        raise ManifestError(f'{path} is missing: get a complete copy of the course, or run ./course build') from None
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise ManifestError(f'{path} is damaged ({error}): get a fresh copy of it, or run ./course build') from None
    return {exercise.id: exercise for exercise in exercises}


def near(identity: str, exercises: Iterable[str]) -> str:
    """Which of the exercises may be meant by an id that is none: all of its chapter, else the range of each chapter."""
    chapters: dict[str, list[str]] = {}
    for one in exercises:
        chapters.setdefault(one.partition('.')[0], []).append(one)
    mine = chapters.get(identity.partition('.')[0])
    return ', '.join(mine or (f'{ids[0]} to {ids[-1]}' if len(ids) > 1 else ids[0] for ids in chapters.values()))


def dumps(exercises: Iterable[Exercise]) -> str:
    """Return the text of the file for ``exercises``, sorted by chapter and number."""
    ordered = sorted(exercises, key=lambda exercise: [int(part) for part in exercise.id.split('.')])
    rows = [
        {key: value for key, value in asdict(exercise).items() if key not in ('folder', 'earlier') or value}
        for exercise in ordered
    ]
    return json.dumps({'exercises': rows}, indent=2, ensure_ascii=False) + '\n'


def _dump(node: object) -> str:
    if isinstance(node, ast.AST):
        fields = ((name, getattr(node, name, None)) for name in node._fields)
        shown = ', '.join(f'{name}={_dump(value)}' for name, value in fields if value is not None and value != [])
        return f'{type(node).__name__}({shown})'
    if isinstance(node, list):
        return f'[{", ".join(map(_dump, node))}]'
    return repr(node)
