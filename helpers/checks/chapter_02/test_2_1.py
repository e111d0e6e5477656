"""Visible tests of exercise 2.1, entry points."""

import pytest

from helpers.checks.chapter_02 import greeting

pytestmark = pytest.mark.exercise('2.1')


@pytest.mark.rules('builds', 'no-others', 'hello', 'goodbye', 'battery')
def test_programs(learner):
    """The package builds, and has the programs hello, goodbye and battery, and no others.

    The left side of an entry point is the name of the program.
    """
    greeting.judge_list(learner)


@pytest.mark.rules('hello')
def test_hello(learner):
    """`ros2 run greeter hello NAME` prints `Hello, NAME`.

    The right side is a module as import writes it, then a colon, then a function.
    """
    greeting.judge_program(learner, 'hello')


@pytest.mark.rules('goodbye')
def test_goodbye(learner):
    """`ros2 run greeter goodbye NAME` prints `Goodbye, NAME`.

    The name of the program is goodbye; the module is greeter.farewell.
    """
    greeting.judge_program(learner, 'goodbye')


@pytest.mark.rules('battery', 'rest')
def test_battery(learner):
    """`ros2 run greeter battery NAME` prints `The battery of NAME is full`.

    The module is greeter.power.battery, and the function need not be called main.
    """
    greeting.judge_program(learner, 'battery')


@pytest.mark.given
@pytest.mark.rules('rest')
def test_rest(learner):
    """Name, version, modules, marker and package.xml are installed as before.

    Only the list console_scripts needs new lines.
    """
    greeting.judge_rest(learner)
