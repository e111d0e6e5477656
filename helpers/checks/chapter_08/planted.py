"""Run the learner's tests of exercises 8.4, 8.6 and 8.11 with right and wrong programs: which of them do they reject?

Each program is a file such as `speed/limit.py` of its own, under a number that tells nothing. One process imports
pytest and forks for each of them, so that a dozen costs little more than one. Where ROS is needed, some run side by
side, each in a domain of its own.
"""

import hashlib
import json
import re
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from helpers import domains
from helpers.runner import expect
from helpers.runner.workspaces import package

MARK = 'OUTCOMES '
LIMIT_SECONDS = 40  # for the tests with one program that needs ROS
OWN = 'your own'  # the name of the learner's program, which may be wrong itself
ENDED = -14  # the status, if the alarm ended them
SIDE_BY_SIDE = 3  # as many of these at a time
# pytest's exit status: 0 all passed, 1 some failed, 2 interrupted (as by an error of import), 5 no tests.
_RUN = f'''\
import json
import re
import os
import signal
import sys

import pytest

tests, limit, free = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
os.environ['PYTEST_DISABLE_PLUGIN_AUTOLOAD'] = '1'
if free == ['none']:
    for name in ('rclpy', 'rclpy.node'):
        sys.modules[name] = None  # importing it is an ImportError
else:
    import rclpy.action, rclpy.executors, tf2_ros  # for all of them at once
    os.chmod('prefix/lib/delivery_robot/robot', 0o755)
    os.environ['AMENT_PREFIX_PATH'] = os.path.abspath('prefix') + ':' + os.environ.get('AMENT_PREFIX_PATH', '')
waiting, running, outcomes = sorted(os.listdir('functions')), {{}}, {{}}
while waiting or running:
    while waiting and free:
        number, domain = waiting.pop(0), free.pop()
        child = os.fork()
        if child == 0:
            os.setpgid(0, 0)
            signal.alarm(limit)
            output = os.open(number + '.txt', os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
            os.dup2(output, 1)
            os.dup2(output, 2)
            folder = os.path.abspath(os.path.join('functions', number))
            sys.path.insert(0, folder)
            os.environ['PYTHONPATH'] = folder + ':' + os.environ.get('PYTHONPATH', '')
            if domain != 'none':
                os.environ['ROS_DOMAIN_ID'] = domain
            status = pytest.main(['-q', '-x', '--tb=line', '--color=no', '-p', 'no:cacheprovider', tests])
            sys.stdout.flush()
            os._exit(int(status))
        running[child] = number, domain
    child, status = os.wait()
    if child in running:
        number, domain = running.pop(child)
        try:
            os.killpg(child, signal.SIGKILL)  # what the tests have left
        except ProcessLookupError:
            pass
        with open(number + '.txt', errors='replace') as file:
            outcomes[number] = os.waitstatus_to_exitcode(status), file.read()[-1200:]
        free.append(domain)
print({MARK!r} + json.dumps(outcomes))
'''
NOTHING = '    return None\n'  # the last part of a program that does nothing
EMPTY = {'conftest.py': '', 'pytest.ini': '[pytest]\naddopts =\n'}
GIVEN = Path(__file__).with_name('given')


@dataclass(frozen=True)
class Subject:
    """What is tested: a module of a package, by the text that the learner's cell binds to `tests`."""

    module: PurePosixPath
    tests: str
    what: str = 'function'
    said: str = 'specification'
    ros: bool = False
    more: dict[str, str] = field(default_factory=dict, hash=False)  # other files: path in the workspace → text


def _robot() -> dict[str, str]:
    """What stands around robot.py: the bench, and what `ros2 run delivery_robot robot` needs."""
    name = 'delivery_robot'
    files = package(GIVEN / name)
    return {'test/conftest.py': (GIVEN / 'bench' / 'conftest.py').read_text(),
            f'prefix/share/ament_index/resource_index/packages/{name}': '',
            f'prefix/share/{name}/package.xml': files[f'src/{name}/package.xml'],
            f'prefix/lib/{name}/robot': f'#!/usr/bin/env python3\nfrom {name}.main import main\n\nmain()\n'}


LIMIT = Subject(PurePosixPath('speed/limit.py'), 'TEST_LIMIT', said='docstring')
STEERING = Subject(PurePosixPath('delivery_robot/steering.py'), 'TEST_STEERING')
ROBOT = Subject(PurePosixPath('delivery_robot/robot.py'), 'TEST_ROBOT', 'robot', ros=True, more=_robot())


@dataclass(frozen=True)
class Outcome:
    """How pytest ended with one program, and what it said."""

    status: int
    output: str

    @property
    def reason(self) -> str:
        """The line that says why a test failed."""
        lines = [line.strip() for line in self.output.splitlines()]
        found = [line for line in lines if line.startswith(('E ', '/')) and 'Error' in line]
        return found[-1].rpartition('/')[2][:200] if found else ''


def judge(learner, functions: dict[str, str | dict[str, str]], subject: Subject = LIMIT) -> dict[str, Outcome]:
    """Run the learner's tests with each program: name → how they ended. Once in a session for the same ones.

    :param functions: name → text of its module, or the texts of several: path → text.
    The learner's side sees numbers in an order that is drawn, and no names.
    """
    tests = learner.text(subject.tests)
    key = 'planted', hashlib.sha256(json.dumps([str(subject.module), tests, functions]).encode()).hexdigest()
    if key not in learner.server.workspaces:
        learner.server.workspaces[key] = _run(learner, functions, subject, tests)
    outcomes = learner.server.workspaces[key]
    said = '\n'.join(outcome.output for outcome in outcomes.values())
    statuses = {outcome.status for outcome in outcomes.values()}
    expect(subject.ros or "No module named 'rclpy" not in said and 'import of rclpy' not in said,
           'Your tests import rclpy. The function needs no ROS, and its tests need none.')
    expect(5 not in statuses, 'pytest found no test: the functions must begin with test_.')
    expect(not statuses - {0, 1, ENDED}, f'pytest could not run your tests: {_unreadable(said)}')
    return outcomes


def _run(learner, functions, subject: Subject, tests: str) -> dict[str, Outcome]:
    names = list(functions)
    learner.random.shuffle(names)
    module, path = subject.module, f'test/test_{subject.module.name}'
    files = {**EMPTY, **subject.more, 'run.py': _RUN, path: tests}
    for number, name in enumerate(names):
        texts = functions[name] if isinstance(functions[name], dict) else {str(module): functions[name]}
        folder = f'functions/{number:02}'
        files |= {f'{folder}/{module.parent}/__init__.py': '',
                  **{f'{folder}/{one}': text for one, text in texts.items()}}
    with ExitStack() as held:
        free = [str(held.enter_context(domains.claim())) for _ in range(SIDE_BY_SIDE)] if subject.ros else ['none']
        # Without ROS, one after the other: each takes some milliseconds.
        limit, timeout = (LIMIT_SECONDS, 110.0) if subject.ros else (20, 20.0)
        done = learner.workspace(files).run('python3', 'run.py', path, str(limit), *free, timeout=timeout)
    expect(done.last_line.startswith(MARK.strip()), f'The run of your tests ended with: {done.last_line}')
    found = json.loads(done.lines[-1].removeprefix(MARK))
    return {name: Outcome(*found[f'{number:02}']) for number, name in enumerate(names)}


def _unreadable(said: str) -> str:
    """Why pytest could not even begin, from what it said: the error, and the line of the tests where that is known."""
    errors = (re.findall(r'^E +(\w*(?:Error|Exception)\b.*)$', said, re.MULTILINE)
              or re.findall(r'^.*Error.*$', said, re.MULTILINE))
    place = re.search(r'test_\w+\.py", line \d+|test_\w+\.py:\d+', said)
    where = re.sub(r'", line ', ':', place[0]) if place else ''
    return ' '.join([(errors or [''])[0].strip()[:200], *([f'({where})'] if where else [])])


def accepts(learner, functions: dict, subject: Subject = LIMIT, *, wrong: dict, among: dict | None = None) -> None:
    """Fail unless the learner's tests pass with each of these right programs; a name says what is special in it.

    :param wrong: tests that notice none of these assert nothing, and fail, too.
    :param among: all those that are run at once, with these.
    """
    outcomes = judge(learner, among or {**functions, **wrong}, subject)
    for name in functions:
        _passes(outcomes[name], name, subject)
    expect(any(outcomes[name].status == 1 for name in wrong),
           f'Your tests pass with every {subject.what}, whatever it does: they assert nothing.')


def rejects(learner, functions: dict, subject: Subject = LIMIT, *, right: dict, among: dict | None = None) -> None:
    """Fail unless the learner's tests notice each of these wrong programs; a name says what is wrong.

    :param right: tests that fail with one of these, too, show nothing.
    :param among: all those that are run at once, with these.
    """
    outcomes = judge(learner, among or {**functions, **right}, subject)
    for name in right:
        _passes(outcomes[name], name, subject)
    for name in functions:
        expect(outcomes[name].status != ENDED, f'With a {subject.what} {name}, your tests did not end in '
                                               f'{LIMIT_SECONDS} s. Give each wait a bound.')
        expect(outcomes[name].status == 1, f'No test of yours notices a {subject.what} {name}.')


def _passes(outcome: Outcome, name: str, subject: Subject) -> None:
    """Fail unless the learner's tests pass with a right program."""
    expect(outcome.status != ENDED, f'Your tests did not end in {LIMIT_SECONDS} s with a right {subject.what} ({name}).'
                                    ' Give each wait a bound.')
    expect(outcome.status == 0 or name != OWN, f'A test of yours fails with your own {subject.what}. '
                                               f'pytest says: {outcome.reason}')
    why = (f'pytest says: {outcome.reason}' if subject.ros else 'Compare computed numbers with pytest.approx, and ask '
           f'for nothing that is not in the {subject.said}.')
    expect(outcome.status == 0, f'A test of yours fails with a {subject.what} that does what its {subject.said} says '
                                f'({name}). {why}')
