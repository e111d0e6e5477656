"""Run the learner's tests of exercises 8.4 and 8.6 with right and wrong functions: which of them do they reject?

Each function is a file such as `speed/limit.py` of its own, under a number that tells nothing. One process imports
pytest and forks for each of them, so that a dozen costs little more than one.
"""

import json
from dataclasses import dataclass
from pathlib import PurePosixPath

from helpers.runner import expect

MARK = 'OUTCOMES '
# pytest's exit status: 0 all passed, 1 some failed, 2 interrupted (as by an error of import), 5 no tests.
_RUN = f'''\
import json
import os
import sys

import pytest

os.environ['PYTEST_DISABLE_PLUGIN_AUTOLOAD'] = '1'
outcomes = {{}}
for number in sorted(os.listdir('functions')):
    child = os.fork()
    if child == 0:
        sys.path.insert(0, os.path.join('functions', number))
        for name in ('rclpy', 'rclpy.node'):
            sys.modules[name] = None  # importing it is an ImportError
        status = pytest.main(['-q', '-x', '--tb=line', '--color=no', '-p', 'no:cacheprovider', sys.argv[1]])
        sys.stdout.flush()
        os._exit(int(status))
    outcomes[number] = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
print({MARK!r} + json.dumps(outcomes))
'''
EMPTY = {'conftest.py': '', 'pytest.ini': '[pytest]\naddopts =\n'}


@dataclass(frozen=True)
class Subject:
    """What is tested: a module of a package, by the text that the learner's cell binds to `tests`."""

    module: PurePosixPath
    tests: str


LIMIT = Subject(PurePosixPath('speed/limit.py'), 'TEST_LIMIT')
STEERING = Subject(PurePosixPath('delivery_robot/steering.py'), 'TEST_STEERING')


def judge(learner, functions: dict[str, str], subject: Subject = LIMIT) -> dict[str, int]:
    """Run the learner's tests with each function (name → text of its module): name → pytest's exit status.

    The learner's side sees numbers in an order that is drawn, and no names.
    """
    names = list(functions)
    learner.random.shuffle(names)
    module, tests = subject.module, f'test/test_{subject.module.name}'
    files = {**EMPTY, 'run.py': _RUN, tests: learner.text(subject.tests)}
    for number, name in enumerate(names):
        folder = f'functions/{number:02}'
        files |= {f'{folder}/{module.parent}/__init__.py': '', f'{folder}/{module}': functions[name]}
    done = learner.workspace(files).run('python3', 'run.py', tests)
    expect(done.last_line.startswith(MARK), f'The run of your tests ended with: {done.last_line}')
    outcomes = json.loads(done.lines[-1].removeprefix(MARK))
    statuses = {name: outcomes[f'{number:02}'] for number, name in enumerate(names)}
    expect("No module named 'rclpy" not in done.output and 'import of rclpy' not in done.output,
           'Your tests import rclpy. The function needs no ROS, and its tests need none.')
    expect(5 not in statuses.values(), 'pytest found no test: the functions must begin with test_.')
    bad = next((line for line in done.lines if line.startswith('E ') or 'Error' in line), '')
    expect(not set(statuses.values()) - {0, 1}, f'pytest could not run your tests: {bad}')
    return statuses


def accepts(learner, functions: dict[str, str], subject: Subject = LIMIT) -> None:
    """Fail unless the learner's tests pass with each of these right functions; a name says what is special in it."""
    said = 'docstring' if subject is LIMIT else 'specification'
    for name, status in judge(learner, functions, subject).items():
        expect(status == 0, f'A test of yours fails with a function that does what its {said} says ({name}). '
                            'Compare computed numbers with pytest.approx, and ask for nothing that is not in the '
                            f'{said}.')


def rejects(learner, functions: dict[str, str], subject: Subject = LIMIT) -> None:
    """Fail unless the learner's tests notice each of these wrong functions; a name says what is wrong."""
    statuses = judge(learner, functions, subject)
    for name in functions:
        expect(statuses[name] == 1, f'No test of yours notices a function {name}.')
