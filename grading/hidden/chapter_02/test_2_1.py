"""Hidden tests of exercise 2.1, entry points."""

import pytest

from helpers.checks.chapter_02 import builds
from helpers.runner import expect

pytestmark = pytest.mark.exercise('2.1')


def test_only_these_programs(learner):
    """The package greeter has exactly the programs battery, goodbye and hello.

    One entry point for each; the left side is the name of the program.
    """
    done = builds.greeter(learner).run('ros2', 'pkg', 'executables', 'greeter')
    there = [line.split()[-1] for line in done.lines if line.startswith('greeter ')]
    expect(sorted(there) == ['battery', 'goodbye', 'hello'],
           f'The programs are {", ".join(sorted(there)) or "none"}; expected battery, goodbye, hello.')


def test_hello(learner):
    """`ros2 run greeter hello NAME` runs main of greeter/hello.py.

    The right side is a module as import writes it, then a colon, then a function.
    """
    name = f'robot{learner.random.randint(10, 99)}'
    done = builds.greeter(learner).run('ros2', 'run', 'greeter', 'hello', name)
    expect('not callable' not in done.last_line,
           'The entry point of hello names a module only: add a colon and the function, `:main`.')
    expect(done.last_line == f'Hello, {name}', f'`ros2 run greeter hello {name}` ended with: {done.last_line}')


def test_goodbye(learner):
    """`ros2 run greeter goodbye NAME` runs main of greeter/farewell.py.

    The name of the program is goodbye; the module is greeter.farewell.
    """
    name = f'robot {learner.random.randint(10, 99)}'
    done = builds.greeter(learner).run('ros2', 'run', 'greeter', 'goodbye', *name.split())
    expect(done.last_line == f'Goodbye, {name}', f'`ros2 run greeter goodbye {name}` ended with: {done.last_line}')


@pytest.mark.weight(2)
def test_battery(learner):
    """`ros2 run greeter battery NAME` runs the function report of greeter/power/battery.py.

    The module is greeter.power.battery, and the function need not be called main. The folder must be installed, too.
    """
    name = f'robot{learner.random.randint(10, 99)}'
    done = builds.greeter(learner).run('ros2', 'run', 'greeter', 'battery', name)
    expect(done.last_line != 'battery.py tests itself',
           'The program battery runs `main` of battery.py; the specification asks for the function `report`.')
    expect("No module named 'greeter.power'" not in done.output,
           'The folder greeter/power is not installed: `packages` in setup.py must name it, or find it.')
    expect(done.last_line == f'The battery of {name} is full',
           f'`ros2 run greeter battery {name}` ended with: {done.last_line}')
