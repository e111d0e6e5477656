"""Visible tests of exercise 2.1, entry points."""

import pytest

from helpers.checks.chapter_02 import builds
from helpers.runner import expect

pytestmark = pytest.mark.exercise('2.1')


def test_programs(learner):
    """The package greeter has the programs hello, goodbye and battery, and no others.

    The left side of an entry point is the name of the program.
    """
    done = builds.greeter(learner).run('ros2', 'pkg', 'executables', 'greeter')
    there = sorted(line.split()[-1] for line in done.lines if line.startswith('greeter '))
    expect(there, 'The package has no programs: the list console_scripts is empty.')
    files = {'farewell', 'farewell.py', 'hello.py', 'battery.py'} & set(there)
    expect(not files, f'There is a program `{min(files, default="")}`. The name of a program is what the specification '
                      'says; it need not be the name of its file.')
    wanted = ['battery', 'goodbye', 'hello']
    expect(there == wanted, f'The programs are {", ".join(there)}; expected {", ".join(wanted)}.')


def test_hello(learner):
    """`ros2 run greeter hello Ada` prints `Hello, Ada`.

    The right side is a module as import writes it, then a colon, then a function.
    """
    done = builds.greeter(learner).run('ros2', 'run', 'greeter', 'hello', 'Ada')
    expect('not callable' not in done.last_line,
           'The entry point of hello names a module only: add a colon and the function, `:main`.')
    expect(done.last_line == 'Hello, Ada', f'`ros2 run greeter hello Ada` ended with: {done.last_line}')
