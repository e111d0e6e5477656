"""The five systems of exercise 7.8: they run, they are broken, and they are drawn from a name.

Each is the robot with its panel (`helpers.programs.faults.mystery`). Two have two faults. A learner works on a
`LiveSystem`, which notes each look and each change; the tests of the exercise read the truth of a `Planned` one.
"""

import ast
import difflib
import json
import os
import random
import re
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from environment.setup import whole_file
from helpers import paths
from helpers.programs.faults.finding import Finding
from helpers.programs.faults.mystery import Mystery

EXERCISE = '7.8'  # whose check tells the truth
NUMBERS = (1, 2, 3, 4, 5)
# The faults that are drawn. The order stays, so that a name draws the systems that it has always drawn.
POSSIBLE = ('no_data', 'unseen', 'waiting', 'hang', 'no_transform', 'wrong_time', 'too_slow', 'no_parameter')
FILE = '.looks.json'  # beside the notebooks
STACKS = 6  # after the five questions: where does the program stand?
# In which order a command is asked for: the first pattern that it has tells which question it answers.
_QUESTIONS = (
    (5, r'use_sim_time|/clock\b|topic echo.*\s/tf\b|\bdate\b|stamp|delay'),
    (4, r'ROS_|DOMAIN|RANGE|\benv\b|printenv|bashrc|rooms\.sh'),
    (3, r'topic info|topic type|service type|service find|interface|topic list -t|service list -t|doctor'),
    (2, r'node info|topic|service|tf2|view_frames|/tf'),
    (1, r'node list|param|\bps\b|start\.txt'),
)

Change = tuple[str, str, str]


def key(name: object) -> str:
    """What a name draws from: spaces around it do not count."""
    return str(name).strip()


class Planned(Mystery):
    """One of the five systems, not staged, with its truth.

    :raises ValueError: there is no system of that number.
    """

    name = 'live'

    def __init__(self, who: object, number: int, folder=None, domain: int | None = None):
        if number not in NUMBERS:
            raise ValueError(f'there is no system {number!r}: there are {", ".join(map(str, NUMBERS))}')
        self.who, self.number = key(who), number
        super().__init__(f'{self.who} {number}', None, folder or Path('faults_ws', f'system_{number}'), domain)

    def plan(self) -> None:
        draw = random.Random(f'live {self.who}')
        faults, sizes = draw.sample(POSSIBLE, len(POSSIBLE)), [1, 1, 1, 2, 2]
        draw.shuffle(sizes)
        begin = sum(sizes[: self.number - 1])
        self.plan_system(faults[begin : begin + sizes[self.number - 1]])

    def _again(self) -> str:
        return f'faults.live({self.who!r}, {self.number})'

    def questions(self) -> list[tuple[int, str]]:
        """For each fault: the question that shows it, and the command with which it is asked."""
        topic, service, node = (self._values[name] for name in ('topic', 'service', 'node'))
        asleep = 'panel' if any('panel_time' in one.change for one in self.drawn.values()) else node
        tools = {
            ('no_data', 'name'): (2, 'ros2 node info /panel'),
            ('no_data', 'type'): (3, f'ros2 topic info --verbose /{topic}'),
            ('no_data', 'reliability'): (3, f'ros2 topic info --verbose /{topic}'),
            ('unseen', 'domain'): (4, 'env | grep ROS_'),
            ('unseen', 'range'): (4, 'env | grep ROS_'),
            ('waiting', 'name'): (2, 'ros2 node info /panel'),
            ('waiting', 'type'): (3, f'ros2 service type /{service}'),
            ('hang', 'call'): (STACKS, 'system.stacks()'),
            ('no_transform', 'exchanged'): (2, 'ros2 run tf2_ros tf2_echo odom base_link'),
            ('no_transform', 'unknown'): (2, 'ros2 run tf2_ros tf2_echo odom base_link'),
            ('wrong_time', 'no clock'): (5, f'ros2 param get /{asleep} use_sim_time'),
            ('wrong_time', 'other clock'): (5, 'ros2 topic echo --once /tf'),
            ('too_slow', 'rate'): (2, f'ros2 topic hz /{topic}'),
            ('no_parameter', 'parameter'): (1, f'ros2 param get /{node} speed'),
        }
        return [tools[fault, one.cause] for fault, one in self.drawn.items()]


class LiveSystem(Planned):
    """A system of the exercise to work on; made by `live`. It notes each look and each change.

    It holds nothing of the truth: neither what was drawn nor the repaired files.
    """

    def plan(self) -> None:
        super().plan()
        self.drawn, self.repaired, self._truth = {}, {}, []

    def __repr__(self) -> str:
        return super().__repr__().replace('live: ', f'system {self.number} of {self.who!r}: ', 1)

    @property
    def diagnosis(self) -> list[Finding]:
        """The truth, as soon as the check of the exercise has passed."""
        if not records.passed(self.who):
            raise RuntimeError(
                f'the truth of this system comes when check("{EXERCISE}") has passed: until then, look with the tools'
            )
        return Planned(self.who, self.number).diagnosis

    def run(self, script: str, on: str = '') -> None:
        """Run commands, one a line, in a new terminal of this system; each is a look.

        :param on: the machine, 'robot' or 'panel'; by default the panel.
        """
        for line in filter(str.strip, script.splitlines()):
            self._look(question(line))
        super().run(script, on or 'panel')

    def show(self, file: str) -> None:
        """Print a file of the system; this is a look.

        :raises FileNotFoundError: there is no such file.
        """
        super().show(file)
        self._look(question(file))

    def stacks(self, name: str = '') -> None:
        """Print where each thread of a program stands, by default of the panel; this is a look."""
        super().stacks(name)
        self._look(STACKS)

    def graph(self):
        """The graph of the system's domain, as `show_graph()` draws it; this is a look."""
        from helpers.show.graph.view import show_graph

        self.up()
        self._look(2)
        return show_graph()

    def edit(self, file: str, old: str, new: str) -> None:
        """Replace a piece of text in a file, as an editor would; this is a change.

        :raises ValueError: the text is not there, or more than once.
        :raises FileNotFoundError: there is no such file.
        """
        super().edit(file, old, new)  # calls `write`

    def write(self, file: str, text: str) -> None:
        """Write a file of the system; this is a change.

        :raises ValueError: ``file`` is none of the system's files.
        """
        if self._staged:
            _known(self.files, file)
            records.of(self.who, self.number)['changes'] += 1
            records.keep()
        super().write(file, text)

    def repair(self) -> None:
        """Not for these systems: the repair is the exercise.

        :raises RuntimeError: always.
        """
        raise RuntimeError('these systems are yours to repair: find the fault, then use edit or write')

    def changes(self) -> list[Change]:
        """What is different now from the system as it was staged, as the exercise wants it: (file, old, new)."""
        now = {file: self._read(file) for file in self.files}
        return differences(self.files, now)

    def stage(self) -> 'LiveSystem':
        self._staged = False
        super().stage()
        self._staged, self._begun = True, _digest(self.files)
        return self

    def begin_with(self, texts: Mapping[str, str]) -> None:
        """Write the files as an answer to the exercise has them; no change is counted."""
        self._begun = _digest(texts)
        for file, text in texts.items():
            if text != self.files[file]:
                Planned.write(self, file, text)

    def stop(self) -> None:
        """End the programs and remove the folder; what was changed since the start is told, and kept; idempotent."""
        self._tell_changes()
        super().stop()

    def _tell_changes(self) -> None:
        staged, self._staged = getattr(self, '_staged', False), False
        if not staged or not all(self._file(file).is_file() for file in self.files):
            return
        changes = self.changes()
        noted = records.of(self.who, self.number)
        if changes and _digest({file: self._read(file) for file in self.files}) != self._begun:
            print(f'System {self.number} is stopped. What you have changed in it, for CHANGES[{self.number}]:')
            print(f'    {changes!r}')
        if changes or noted['last']:
            noted['last'] = changes
            records.keep()

    def _look(self, asked: int) -> None:
        records.of(self.who, self.number)['looks'].append(asked)
        records.keep()


def live(name: str, number: int, changes: Iterable[Change] = ()) -> LiveSystem:
    """Stage one of the five systems that are drawn from a name; an earlier one is stopped and removed.

    :param changes: what is changed in it at once, as in the answer to the exercise; not counted again.
    :raises ValueError: there is no such system, or a change does not fit.
    """
    from helpers.programs.faults.fault import stop_all

    system = LiveSystem(name, number)
    texts = changed(system.files, changes)
    stop_all()
    system.stage()
    system.begin_with(texts)
    if texts == system.files and (last := records.of(system.who, number)['last']):
        print(
            f'When you stopped this system, you had changed something. To go on from there: faults.live(NAME, {number},'
        )
        print(f'    {last!r})')
    return system


def question(command: str) -> int:
    """Which of the five questions a command asks; 0 if none of them."""
    return next((number for number, pattern in _QUESTIONS if re.search(pattern, command)), 0)


def changed(files: Mapping[str, str], changes: Iterable[Change]) -> dict[str, str]:
    """The files after these changes, each (file, old, new): `old` is replaced by `new`; all of the file, if it is ''.

    :raises ValueError: a change is no such triple, or does not fit; the message says why.
    """
    texts = dict(files)
    for change in changes:
        if (
            not isinstance(change, (tuple, list))
            or len(change) != 3
            or not all(isinstance(part, str) for part in change)
        ):
            raise ValueError(f'{change!r} is no change: write (file, old, new), three texts')
        file, old, new = change
        _known(files, file)
        if old and texts[file].count(old) != 1:
            raise ValueError(f'{old!r} is {texts[file].count(old)} times in {file}: it must be there once')
        texts[file] = texts[file].replace(old, new) if old else new.removeprefix('\n')
    return texts


def differences(before: Mapping[str, str], after: Mapping[str, str]) -> list[Change]:
    """The changes that make `after` of `before`, as `changed` takes them: whole lines."""
    found: list[Change] = []
    for file, text in before.items():
        pieces = [(file, old, new) for old, new in _pieces(text, after[file])]
        with suppress(ValueError):
            if changed({file: text}, pieces) == {file: after[file]}:
                found += pieces
                continue
        found.append((file, '', after[file]))
    return found


def _pieces(before: str, after: str) -> Iterable[tuple[str, str]]:
    old, new = before.splitlines(keepends=True), after.splitlines(keepends=True)
    matcher = difflib.SequenceMatcher(None, old, new, autojunk=False)
    for tag, begin, end, first, last in matcher.get_opcodes():
        if tag == 'equal':
            continue
        while begin > 0 and (begin == end or before.count(''.join(old[begin:end])) != 1):
            begin, first = begin - 1, first - 1
        was, becomes = ''.join(old[begin:end]), ''.join(new[first:last])
        while end - begin == last - first == 1 and was[:1] == becomes[:1] == ' ' and before.count(was[1:]) == 1:
            was, becomes = was[1:], becomes[1:]
        if was.endswith('\n') and becomes.endswith('\n') and before.count(was[:-1]) == 1:
            was, becomes = was[:-1], becomes[:-1]
        yield was, becomes


def _digest(texts: Mapping[str, str]) -> int:
    return hash(tuple(sorted(texts.items())))


def _known(files: Mapping[str, str], file: str) -> None:
    if file not in files:
        raise ValueError(f'{file!r} is no file to change: there are {", ".join(files)}')


class Records:
    """How often somebody has looked and changed, and whether the check has passed, by name.

    It is kept beside the notebooks, so that `./course check` knows it, too. No mark depends on it.
    """

    def __init__(self) -> None:
        self._names: dict[str, dict[str, Any]] | None = None

    def of(self, who: str, number: int = 0) -> dict[str, Any]:
        """What is noted of a name: ``passed``, ``systems``; of one of its systems: ``looks``, ``changes``, ``last``."""
        if self._names is None:
            self._names = _load()
        mine = self._names.setdefault(who, {'passed': False, 'systems': {}})
        return mine['systems'].setdefault(str(number), {'looks': [], 'changes': 0, 'last': []}) if number else mine

    def passed(self, who: str) -> bool:
        """Whether a check has passed with this name, here or by `./course check`."""
        self.of(who)['passed'] |= _load().get(who, {}).get('passed', False)
        return bool(self.of(who)['passed'])

    def keep(self) -> None:
        """Write it down; not for copies, nor when an instructor's solutions are built."""
        if Path.cwd() != paths.NOTEBOOKS or os.environ.get('COURSE_PROGRESS') == 'off':
            return
        for who in self._names or ():
            self.passed(who)
        with suppress(OSError):
            whole_file.write(paths.NOTEBOOKS / FILE, json.dumps(self._names, indent=1))


def _load() -> dict[str, dict[str, Any]]:
    try:
        rows = json.loads((paths.NOTEBOOKS / FILE).read_text(encoding='utf-8'))
        return {
            str(who): {
                'passed': bool(row['passed']),
                'systems': {
                    str(int(number)): {
                        'looks': [int(one) for one in noted['looks']],
                        'changes': int(noted['changes']),
                        'last': [(str(file), str(old), str(new)) for file, old, new in noted.get('last', [])],
                    }
                    for number, noted in row['systems'].items()
                },
            }
            for who, row in rows.items()
        }
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return {}


records = Records()


def name_in(source: str) -> str | None:
    """The name that the exercise's cell assigns to NAME, if it stands there as a text; else None."""
    try:
        body = ast.parse(source).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    for node in body:
        match node:
            case ast.Assign(targets=[ast.Name(id='NAME')], value=ast.Constant(value=str(name))):
                return key(name)
    return None


def way(who: str, passed: bool) -> list[str]:
    """How somebody came to the answer, for after the check: looks and changes, and which question is the shortest.

    The questions tell the causes, so they come only when the check has passed.
    """
    if passed and not records.of(who)['passed']:
        records.of(who)['passed'] = True
        records.keep()
    lines = []
    for number in NUMBERS:
        noted = records.of(who, number)
        looks, changes = noted['looks'], noted['changes']
        if looks or changes:
            line = f'System {number}: {_count(len(looks), "look")}, {_count(changes, "change")}.'
            asked = [_asked(looks, *one) for one in Planned(who, number).questions()] if passed else []
            lines.append(' '.join([line, *asked]))
    return lines


def _asked(looks: list[int], number: int, command: str) -> str:
    name = 'The question where a program stands' if number == STACKS else f'Question {number}'
    shows = f'{name} shows a fault ({command}): '
    if number not in looks:
        return f'{shows}you did not ask it.'
    place = looks.index(number) + 1
    return shows + (
        'you asked it first.'
        if place == 1
        else f'you asked it with look {place}; as the first one it would have been shorter.'
    )


def _count(number: int, noun: str) -> str:
    return f'{number} {noun}{"" if number == 1 else "s"}'
