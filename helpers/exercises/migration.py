"""Takes a learner's work from the notebooks of an older version of the course into those of this one.

What the learner wrote is found from the notebooks alone: an exercise's cell has its heading and its id, a given cell
that is untouched has the id of its text (`cell_ids`), and all other cells the learner wrote or changed. With the older
version's list of exercises beside its notebooks, untouched stubs are told from changed ones, too.

An answer that is a package is copied, if there is none in the new folder yet.

Nothing that the learner wrote is lost: an answer without a place becomes a raw cell, which does not run.
"""

import copy
import re
from dataclasses import dataclass
from pathlib import Path

from helpers import paths
from helpers.exercises import (
    cell_ids,
    definitions,
    file_answers,
    manifest,
    migration_files,
    notebooks,
    package_answers,
    program,
)
from helpers.exercises.migration_report import CarriedOver, MigrationError, MigrationReport
from helpers.runner.text import clean

MOST_POINTS = 1000  # that anybody declares
_TITLE = re.compile(r'\s*#\s*Exercise\s+[\d.]+\s*:\s*(.+?)\s*$', re.IGNORECASE | re.MULTILINE)


@dataclass(frozen=True)
class _Answer:
    """An exercise's cell in an old notebook."""

    exercise: str
    title: str | None
    source: str
    declared: dict  # the cell's metadata: points, names
    card: dict | None  # the cell with the exercise's text
    notebook: str
    after: str | None  # id of the nearest cell before it


def migrate(
    old: Path,
    folder: Path = paths.NOTEBOOKS,
    *,
    dry_run: bool = False,
    known: dict[str, manifest.Exercise] | None = None,
) -> MigrationReport:
    """Carry answers and own cells over from `old` into the notebooks in `folder`.

    :param old: the older version's folder, or its folder of notebooks.
    :param folder: this version's notebooks. One that changes is first copied into a new folder `backup-…` beside it.
    :param dry_run: only report.
    :param known: this version's exercises; those of the course if not given.
    :raises MigrationError: there is no notebook, one cannot be read or written, or both folders are the same.
    """
    source = migration_files.notebooks_of(old)
    if source.resolve() == folder.resolve():
        raise MigrationError(
            f'{source} holds the notebooks of this version itself: unpack the new version beside the '
            'old one, and give the old one.'
        )
    known = manifest.load() if known is None else known
    before = {path.name: migration_files.read(path) for path in migration_files.chapters(source)}
    target = {path.name: migration_files.read(path) for path in migration_files.chapters(folder)}
    if not target:
        raise MigrationError(f'{folder} has no notebooks of the course: get a complete copy of the course.')
    migration = _Migration(before, copy.deepcopy(target), known, migration_files.stubs(source))
    report = migration.run()
    for exercise in known.values():
        if exercise.folder:
            _carry_package(report, exercise, source, folder, dry_run)
    report.sort()
    if workspaces := sorted(path.name for path in source.glob('*_ws') if path.is_dir()):
        report.notes.append(
            f'{", ".join(workspaces)} in {source}: workspaces are made again by the cells. Copy what '
            'you changed in them by hand.'
        )
    changed = [name for name in target if migration.target[name] != target[name]]
    if changed and not dry_run:
        migration_files.write(report, folder, {name: migration.target[name] for name in changed})
    return report


class _Migration:
    def __init__(self, before: dict, target: dict, known: dict, stubs: dict[str, str]):
        self.before, self.target, self.known, self.stubs = before, target, known, stubs
        self.report = MigrationReport()
        self.trials = {identity for notebook in before.values() for identity in _trials(notebook['cells'], known)}

    def run(self) -> MigrationReport:
        answers = [answer for name in self.before for answer in self._answers(name)]
        times = {answer.exercise: sum(one.exercise == answer.exercise for one in answers) for answer in answers}
        for exercise, number in times.items():
            if number > 1:
                self._say(
                    exercise,
                    f'is there {number} times in the old notebook: keep one cell, then run this again',
                    lost=True,
                )
        for answer in answers:
            if times[answer.exercise] == 1:
                self._carry(answer)
        for name in self.before:
            self._carry_own(name)
        return self.report

    def _say(self, exercise: str, said: str, lost: bool = False) -> None:
        # What an old notebook declares is anybody's text.
        self.report.exercises.append(CarriedOver(exercise, clean(' '.join(said.split())), lost))

    # Answers

    def _exercise(self, cell: dict) -> str | None:
        """The id of the exercise whose answer this cell is."""
        return None if id(cell) in self.trials else _exercise(cell)

    def _answers(self, name: str) -> list[_Answer]:
        found, card, after = [], None, None
        for cell in self.before[name]['cells']:
            exercise = self._exercise(cell)
            if exercise:
                title = _TITLE.match(cell['source'])
                found.append(
                    _Answer(
                        exercise,
                        title[1] if title else None,
                        cell['source'],
                        _declared(cell['metadata']),
                        card,
                        name,
                        after,
                    )
                )
                card = None
            elif cell['cell_type'] == 'markdown':
                card = cell
            after = cell.get('id', after)
        return found

    def _carry(self, answer: _Answer) -> None:
        exercise = self._successor(answer)
        if exercise is None:
            place = self._beside(answer)
            self._say(
                answer.exercise,
                f'is no longer in the course; your answer is kept as a raw cell in {place}, which does not run',
                lost=True,
            )
            return
        cells = self.target[exercise.notebook]['cells']
        index = next((i for i, cell in enumerate(cells) if cell.get('id') == exercise.cell_id), None)
        if index is None:
            self._say(
                exercise.id,
                f'has no cell in the new {exercise.notebook}: get a fresh copy of that notebook, then run this again',
                lost=True,
            )
            return
        digest, moved = _digest(answer.source), ''
        if exercise.is_stub(digest) or digest and digest == self.stubs.get(answer.exercise):
            if not exercise.folder:  # its answer is no cell
                self._say(exercise.id, 'was not attempted; the new notebook stays as it is')
            return
        source = answer.source
        if (answer.exercise, answer.title) != (exercise.id, exercise.title):
            source = _with_heading(source, f'# Exercise {exercise.id}: {exercise.title}')
            moved = f' (it was {answer.exercise})' if answer.exercise != exercise.id else ''
        if cells[index]['source'] == source:
            self._say(exercise.id, 'has this answer already')
            return
        if not exercise.is_stub(_digest(cells[index]['source'])):
            _insert(cells, index + 1, _raw(answer.exercise, 'the answer from the old notebook', source))
            self._say(
                exercise.id,
                f'has another answer already, which stays{moved}; the old one stands below it as a raw cell',
                lost=True,
            )
            return
        given, cells[index]['source'] = cells[index]['source'], source
        changes = self._changes(answer, exercise, cells)
        quoted = file_answers.MAGIC in given and file_answers.MAGIC not in source
        if quoted or self.stubs.get(answer.exercise, exercise.stub) != exercise.stub:
            _insert(cells, index + 1, _raw(exercise.id, 'what the new version gives', given))
            changes.append('what is given, which stands below your answer as a raw cell')
        if quoted:
            changes.append(
                f'files now stand below lines `{file_answers.USAGE}`; your answer in quotes counts as before, '
                'but running it does not write the file'
            )
        self._say(exercise.id, f'carried over{moved}' + (f'; changed since: {"; ".join(changes)}' if changes else ''))

    def _successor(self, answer: _Answer) -> manifest.Exercise | None:
        """The exercise of this version that the answer belongs to. Its number may now belong to another exercise."""
        here = {key: one for key, one in self.known.items() if one.notebook in self.target}
        same = here.get(answer.exercise)
        if same and answer.title in (None, same.title):
            return same
        titled = [exercise for exercise in here.values() if exercise.title == answer.title]
        if len(titled) == 1:
            return titled[0]
        names = answer.declared.get('names')
        return same if same and (names is None or set(names) & set(same.names)) else None

    def _changes(self, answer: _Answer, exercise: manifest.Exercise, cells: list[dict]) -> list[str]:
        changes = []
        if answer.title not in (None, exercise.title):
            changes.append(f'the title, now "{exercise.title}"')
        if answer.card and not any(
            cell.get('id') == answer.card.get('id') or cell['source'] == answer.card['source'] for cell in cells
        ):
            changes.append('its text: read it again')
        points = answer.declared.get('points', exercise.points)
        if points != exercise.points:
            changes.append(f'points, {points:g} → {exercise.points:g}')
        names = answer.declared.get('names')
        if names is not None and set(names) != set(exercise.names):
            changes.append(f'it asks for {", ".join(exercise.names)}, no longer for {", ".join(names)}')
        return changes

    def _beside(self, answer: _Answer) -> str:
        """Keep an answer that has no exercise; returns the notebook in which it is."""
        name = self._new_name(answer.notebook) or next(reversed(self.target))
        cells = self.target[name]['cells']
        _insert(
            cells,
            _place(cells, answer.after),
            _raw(answer.exercise, 'an answer to an exercise that is gone', answer.source),
        )
        return name

    # The learner's own cells

    def _carry_own(self, name: str) -> None:
        cells = self.before[name]['cells']
        if not any(cell_ids.untouched(cell['cell_type'], cell['source'], cell.get('id', '')) for cell in cells):
            self.report.notes.append(
                f'{name}: its cells have lost their ids: only exercises are carried over; cells '
                'of your own are still in the old notebook. JupyterLab keeps ids.'
            )
            return
        new = self._new_name(name)
        count, anchor = 0, None
        for cell in cells:
            exercise = self._exercise(cell)
            identity = cell.setdefault('id', cell_ids.of_given(cell['cell_type'], cell['source'], 0))
            given = exercise or cell_ids.untouched(cell['cell_type'], cell['source'], identity)
            if not given and cell['source'].strip() and not identity.startswith('old-'):
                if new is None:
                    self.report.notes.append(
                        f'{name}: this version has no such chapter; your own cells are still in the old notebook.'
                    )
                    return
                count += self._add(self.target[new]['cells'], cell, anchor)
            if new and any(one.get('id') == identity for one in self.target[new]['cells']):
                anchor = identity
        if count and new is not None:
            self.report.own[new] = count

    def _add(self, cells: list[dict], cell: dict, anchor: str | None) -> bool:
        """Put in a cell of the learner's; False if it is there already."""
        if any(one['source'] == cell['source'] for one in cells):
            return False
        there = next((one for one in cells if one.get('id') == cell['id']), None)
        if there is None:
            cells.insert(_place(cells, anchor), _fresh(cell))
        elif cell_ids.untouched(there['cell_type'], there['source'], cell['id']):
            there['source'] = cell['source']  # given, the same in both versions, and changed by the learner
        else:  # changed in both
            again = _fresh(cell) | {'id': cell_ids.of_given(cell['cell_type'], cell['source'], 0)}
            cells.insert(_place(cells, cell['id']), again)
        return True

    def _new_name(self, name: str) -> str | None:
        if name in self.target:
            return name
        return next((new for new in self.target if new[:2] == name[:2]), None)


def _exercise(cell: dict) -> str | None:
    """The id of the exercise whose cell this is, by heading or by the cell's id."""
    if cell['cell_type'] != 'code':
        return None
    heading = program.exercise_id(notebooks.NotebookCell(cell['source'], 0))
    match = re.fullmatch(r'ex-([0-9]{1,4})-([0-9]{1,4})', cell.get('id') or '')
    return heading or (f'{match[1]}.{match[2]}' if match else None)


def _trials(cells: list[dict], known: dict[str, manifest.Exercise]) -> set[int]:
    """The cells, by `id()`, that have an exercise's heading and only try its answer: another one has the names."""
    claiming: dict[str, list[dict]] = {}
    for cell in cells:
        if exercise := _exercise(cell):
            claiming.setdefault(exercise, []).append(cell)
    found = set()
    for exercise, several in claiming.items():
        wanted = known[exercise].names if exercise in known else ()
        names = next((said['names'] for cell in several if 'names' in (said := _declared(cell['metadata']))), wanted)
        answers = [cell for cell in several if names and definitions.names_in(cell['source']).issuperset(names)]
        if len(answers) == 1:
            found |= {id(cell) for cell in several if cell is not answers[0]}
    return found


def _declared(metadata: dict) -> dict:
    """What the cell's metadata say about the exercise, as far as it has the right form."""
    said = metadata.get('exercise')
    if not isinstance(said, dict):
        return {}
    forms = {
        'points': lambda value: isinstance(value, (int, float)) and abs(value) < MOST_POINTS,
        'names': lambda value: isinstance(value, list) and all(isinstance(one, str) for one in value),
    }
    return {key: said[key] for key, fits in forms.items() if key in said and fits(said[key])}


def _digest(source: str) -> str | None:
    try:
        return manifest.stub_digest(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):  # not Python, so it cannot be the stub
        return None


def _with_heading(source: str, heading: str) -> str:
    lines = source.splitlines()
    first = next((i for i, line in enumerate(lines) if line.strip()), 0)
    if lines and program.HEADING.match(lines[first].strip()):
        del lines[: first + 1]
    return '\n'.join([heading, *lines])


def _raw(exercise: str, what: str, source: str) -> dict:
    head = f'Exercise {exercise}, {what}. This cell does not run: delete it when you have read it.'
    return {
        'id': f'old-{exercise.replace(".", "-")}',
        'cell_type': 'raw',
        'metadata': {},
        'source': f'{head}\n\n{source}',
    }


def _insert(cells: list[dict], index: int, cell: dict) -> None:
    """Insert a raw cell, once: not if the same is there from an earlier run."""
    if any(one['source'] == cell['source'] for one in cells):
        return
    names = {one.get('id') for one in cells}
    first, number = cell['id'], 1
    while cell['id'] in names:
        number += 1
        cell['id'] = f'{first}-{number}'
    cells.insert(index, cell)


def _place(cells: list[dict], anchor: str | None) -> int:
    """The index behind the cell `anchor`; the end if there is none."""
    return next((i + 1 for i, cell in enumerate(cells) if anchor and cell.get('id') == anchor), len(cells))


def _fresh(cell: dict) -> dict:
    """A copy that has not been run."""
    result = copy.deepcopy(cell)
    if result['cell_type'] == 'code':
        result['outputs'], result['execution_count'] = [], None
    return result


def _carry_package(
    report: MigrationReport, exercise: manifest.Exercise, source: Path, folder: Path, dry_run: bool
) -> None:
    """Copy the package that is the answer of an exercise, if there is one and its place is free."""
    name = exercise.folder

    def say(said: str, lost: bool = False) -> None:
        report.exercises.append(CarriedOver(exercise.id, clean(said), lost))

    try:
        old, new = package_answers.read(source, name), package_answers.read(folder, name)
    except program.InvalidExercise as error:
        say(f'its package cannot be copied: {error}', lost=True)
        return
    if not old.files:
        say(f'was not attempted: there is no {name} in {source}')
    elif new.files == old.files:
        say('has this answer already')
    elif new.files:
        say(f'has another package in {name} already, which stays; the old one is still in {source}', lost=True)
    else:
        say(f'carried over: {name}, {len(old.files)} files. Build it there again')
        report.packages.append(folder / name)
        if not dry_run:
            migration_files.write_package(folder / name, old.files)
