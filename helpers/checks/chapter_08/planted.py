"""Run the learner's tests of exercises 8.4, 8.6 and 8.11 with right and wrong programs: which of them do they reject?

pytest's exit status: 0 all passed, 1 some failed, 2 interrupted (as by an error of import), 5 no tests.

Each program is alone in a place of its own. A function stays on the tests' side: what the learner's tests import is the
same stub for all. A program that needs ROS is there without its text, and disguised for this run. Some of these run
side by side, each in a domain of its own.
"""

import hashlib
import json
import os
import re
from collections.abc import Iterable
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path, PurePosixPath
from random import SystemRandom
from time import monotonic as _now
from typing import Any

from ament_index_python import get_packages_with_prefixes

from helpers.kernel import domains
from helpers.runner import disguise, expect, explanations, imports
from helpers.runner.functions import Served, stub
from helpers.runner.load import busy
from helpers.runner.workspaces import package

OWN = 'your own'  # the name of the learner's program, which may be wrong itself
ENDED = -14  # the status, if they did not end
SIDE_BY_SIDE = 3  # as many programs that need ROS at a time
_MODULES = ('rclpy.action', 'rclpy.executors', 'tf2_ros')  # that are imported once for all of these
Program = str | dict[str, str]  # the text of a module, or path → text of several
NOTHING = '    return None\n'  # the last part of a program that does nothing
_OPTIONS = ('-q', '-x', '--tb=line', '--color=no', '-p', 'no:cacheprovider')
EMPTY = {'conftest.py': '', 'pytest.ini': '[pytest]\naddopts =\n'}
GIVEN = Path(__file__).with_name('given')


@dataclass(frozen=True)
class Subject:
    """What is tested: a module of a package, by the text that the learner's cell binds to `tests`."""

    module: PurePosixPath
    tests: str
    function: str = ''  # its first line, if the subject is a function and needs no ROS
    what: str = 'function'
    said: str = 'specification'
    ros: bool = False
    more: dict[str, str] = field(default_factory=dict, hash=False)  # other files: path in the workspace → text

    @property
    def limit(self) -> float:
        """Seconds for the tests with one program, on a machine that is not busy."""
        return 40.0 if self.ros else 20.0


def _robot() -> dict[str, str]:
    """What stands around robot.py: the bench, and what `ros2 run delivery_robot robot` needs."""
    name = 'delivery_robot'
    files = package(GIVEN / name)
    return {
        'test/conftest.py': (GIVEN / 'bench' / 'conftest.py').read_text(),
        f'prefix/share/ament_index/resource_index/packages/{name}': '',
        f'prefix/share/{name}/package.xml': files[f'src/{name}/package.xml'],
        f'prefix/lib/{name}/robot': f'#!/usr/bin/env python3\nfrom {name}.main import main\n\nmain()\n',
    }


LIMIT = Subject(PurePosixPath('speed/limit.py'), 'TEST_LIMIT', 'limit(speed, max_speed, distance)', said='docstring')
STEERING = Subject(
    PurePosixPath('delivery_robot/steering.py'),
    'TEST_STEERING',
    'steer(x, y, yaw, goal_x, goal_y, max_linear, max_angular)',
)
ROBOT = Subject(PurePosixPath('delivery_robot/robot.py'), 'TEST_ROBOT', what='robot', ros=True, more=_robot())


@dataclass(frozen=True)
class TestsOutcome:
    """How pytest ended with one program, and what it said."""

    status: int
    output: str

    @property
    def reason(self) -> str:
        """The name and the line of the test that failed, and what pytest says of it; '' if that is not known."""
        named = re.findall(r'^(?:FAILED|ERROR) \S+?::(.+?)(?: - (.*))?$', self.output, re.MULTILINE)
        placed = re.findall(r'test_\w+\.py:(\d+): (.*)$', self.output, re.MULTILINE)
        name, said = named[-1] if named else ('', '')
        line, error = placed[-1] if placed else ('', '')
        error = error or next(iter(re.findall(r"^E +(fixture '.*' not found)", self.output, re.MULTILINE)), '')
        if not said or said.endswith('...'):  # cut at the width of a terminal
            said = error or said
        said = said.strip()[:200]
        return ', '.join([*([f'your test {name}'] if name else []), *([f'line {line}'] if line else [])]) + (
            f': {said}' if said else ''
        )

    @property
    def missing_name(self) -> str:
        """A sentence on a name that the learner's tests use and nothing defines, or on a place that is none; or ''."""
        if re.search(r'conftest\.py:\d+: ValueError: .*values to unpack \(expected 3', self.output):
            return 'A place has three numbers, (x, y, yaw), or it is None.'
        return _missing_name(self.reason)


def judge(
    learner, right: dict[str, Program], others: dict[str, Program], subject: Subject = LIMIT, *, told: bool = False
) -> dict[str, TestsOutcome]:
    """Run the learner's tests with each program: name → how they ended. Once in a session for the same ones.

    When they have not passed with a right program, no other one is run: the cause is known, and each run takes time.
    The programs that were not run are not in what is returned.

    :param right: right programs: name → text of its module, or the texts of several: path → text.
    :param others: all other ones.
    :param told: the learner may read what their tests have said: with programs that are no secret.
    The order is drawn, and the learner's side sees no names.
    """
    tests = learner.text(subject.tests)
    key = 'planted', hashlib.sha256(json.dumps([str(subject.module), tests, right, others]).encode()).hexdigest()
    if key not in learner.server.workspaces:
        order = _order(right, others)
        run = _run_robots if subject.ros else _run_functions
        programs = {name: (right | others)[name] for name in order}
        learner.server.workspaces[key] = run(learner, programs, list(right), subject, tests)
    outcomes = learner.server.workspaces[key]
    said = '\n'.join(outcome.output for outcome in outcomes.values())
    statuses = {outcome.status for outcome in outcomes.values()}
    asked = {name for pair in _NOT_THERE.findall(said) for name in pair} & _packages_of_ros()
    expect(
        subject.ros or not asked,
        f'Your tests import {" and ".join(sorted(asked))}. The function needs no ROS, and its tests need none.',
        'no-ros',
    )
    expect(5 not in statuses, 'pytest found no test: the functions must begin with test_.')
    why = f': {_unreadable(said)}' if told else '. Run the check in the notebook, and read what pytest says there.'
    expect(not statuses - {0, 1, ENDED}, f'pytest could not run your tests{why}')
    return outcomes


def _order(right: Iterable[str], others: Iterable[str]) -> list[str]:
    """In which order the programs are run. The right ones keep their own: what the first of them shows is told first.

    They may be anywhere. The learner's tests can find out how many were run before (by the time, or by the numbers of
    processes), and must not know from it which are right. So no seed gives the order: seeds stand in reports.
    """
    right, others, random = list(right), list(others), SystemRandom()
    random.shuffle(others)
    places = set(random.sample(range(len(right) + len(others)), len(right)))
    return [(right if place in places else others).pop(0) for place in range(len(right) + len(others))]


_NOT_THERE = re.compile(r"import of (\w+)(?:\.[\w.]*)? halted|No module named '(\w+)")


@cache
def _packages_of_ros() -> frozenset[str]:
    """The names of all that is installed as a package of ROS, and of what finds them."""
    return frozenset({*get_packages_with_prefixes(), 'ament_index_python'})


def _run_functions(
    learner, programs: dict[str, Any], right: list[str], subject: Subject, tests: str
) -> dict[str, TestsOutcome]:
    """One after the other: each takes some milliseconds."""
    module, path = subject.module, f'test/test_{subject.module.name}'
    files = {
        **EMPTY,
        path: tests,
        str(module.parent / '__init__.py'): '',
        str(module): stub(subject.function, 'Stands for the function that is tested.'),
    }
    outcomes: dict[str, TestsOutcome] = {}
    longest = 0.0  # seconds with a right program
    for name, text in programs.items():
        place = learner.workspace(files, alone=True)
        namespace: dict = {}
        exec(text, namespace)  # noqa: S102 - a program of the course's
        served = Served(namespace[subject.function.partition('(')[0]])
        try:
            task = place.pytest(
                *_OPTIONS, path, functions=served.other, without=_packages_of_ros() - {module.parent.name}
            )
            begun = _now()
            # Where it is known how long they take with a right one, tests that do not end are given up sooner.
            sooner = longest and name not in right
            outcomes[name] = _outcome(task, min(subject.limit, 3.0 + 5 * longest) if sooner else subject.limit)
        finally:
            served.close()
            place.forget()
        if _is_cause(outcomes[name], name in right):
            break
        if name in right:
            longest = max(longest, _now() - begun)
    return outcomes


def _is_cause(outcome: TestsOutcome, is_right: bool) -> bool:
    """Whether the tests can count for nothing, whatever comes of the other programs."""
    return outcome.status not in (0, 1, ENDED) or is_right and outcome.status != 0


def _run_robots(
    learner, programs: dict[str, Any], right: list[str], subject: Subject, tests: str
) -> dict[str, TestsOutcome]:
    """Some side by side."""
    path, random = f'test/test_{subject.module.name}', SystemRandom()  # as for the order
    pool = disguise.names(text for texts in programs.values() for text in texts.values())
    waiting, outcomes = list(programs), {}
    with ExitStack() as held:
        free = [str(held.enter_context(domains.claim())) for _ in range(SIDE_BY_SIDE)]

        def run(name: str) -> None:
            texts = {one: disguise.disguised(text, pool, random) for one, text in programs[name].items()}
            place = learner.workspace(
                {
                    **EMPTY,
                    **subject.more,
                    path: tests,
                    str(subject.module.parent / '__init__.py'): '',
                    **{one.removesuffix('.py') + '.pyc': disguise.compiled(text) for one, text in texts.items()},
                },
                alone=True,
            )
            domain = free.pop()
            running[name] = (
                place,
                domain,
                place.pytest(
                    *_OPTIONS,
                    path,
                    modules=_MODULES,
                    environment={
                        'ROS_DOMAIN_ID': domain,
                        'PYTHONPATH': f'{place.path}:{os.environ.get("PYTHONPATH", "")}',
                        'AMENT_PREFIX_PATH': f'{place.path}/prefix:{os.environ.get("AMENT_PREFIX_PATH", "")}',
                    },
                ),
                _now(),
            )

        running: dict[str, tuple] = {}
        while waiting or running:
            while waiting and free:
                run(waiting.pop(0))
            for name, (place, domain, task, begun) in list(running.items()):
                if (status := task.wait(0.05)) is not None or _now() > begun + subject.limit * (4 if busy() else 1):
                    outcomes[name] = _outcome(task, 0.0) if status is not None else TestsOutcome(ENDED, task.output)
                    place.forget()
                    free.append(domain)
                    del running[name]
            if causes := [name for name in outcomes if _is_cause(outcomes[name], name in right)]:
                waiting.clear()
                # What fails with the right ones before it is said first.
                earlier = right[: min((right.index(name) for name in causes if name in right), default=0)]
                for name in running.keys() - set(earlier):
                    place, domain, *_ = running.pop(name)
                    place.forget()
                    free.append(domain)
    return {name: outcomes[name] for name in programs if name in outcomes}


def _outcome(task, limit: float) -> TestsOutcome:
    """How the tests with one program have ended, after so many seconds at most, or more on a busy machine."""
    status = task.wait(limit)
    if status is None and busy():
        status = task.wait(3 * limit)
    return TestsOutcome(ENDED if status is None else status, task.output[-1200:])


def _missing_name(said: str) -> str:
    if found := re.search(r"fixture '(.*)' not found", said):
        return f'A parameter of a test is a fixture, or is named in parametrize, and nothing is called `{found[1]}`.'
    if found := re.search(r"NameError: name '(\w+)' is not defined", said):
        return imports.advice(found[1]) or (
            f'Nothing in your tests defines `{found[1]}`. An import is missing, or it is a fixture: then it is a '
            'parameter of the test function.'
        )
    if found := re.search(r"AttributeError: ((?:type object )?'\w+' (?:object )?has no attribute '\w+')", said):
        return explanations.explain('AttributeError', found[1])
    return ''


def _unreadable(said: str) -> str:
    """Why pytest could not even begin, from what it said: the error, and the line of the tests where that is known."""
    patterns = r'^E +(\w*(?:Error|Exception)\b.*)$', r'^.*Error.*$', r'^In \S+?::(.*)$', r'^E +(\S.*)$'
    errors = next((found for found in (re.findall(one, said, re.MULTILINE) for one in patterns) if found), [])
    place = re.search(r'test_\w+\.py", line \d+|test_\w+\.py:\d+', said)
    where = re.sub(r'", line ', ':', place[0]) if place else ''
    error = (errors or ['it says why in the notebook'])[0].strip()[:200]
    told = f'{error} ({where})' if where else error
    return f'{told}. {_missing_name(error)}' if _missing_name(error) else told
