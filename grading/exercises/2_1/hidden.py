"""Hidden tests of exercise 2.1, entry points."""

import pytest

from helpers.checks.chapter_02 import greeting
from helpers.checks.chapter_02.test_2_1 import test_rest  # noqa: F401 - they draw other inputs here

pytestmark = pytest.mark.exercise('2.1')


@pytest.mark.rules('builds', 'no-others', 'hello', 'goodbye', 'battery')
def test_only_these_programs(learner):
    """The package greeter has exactly the programs battery, goodbye and hello.

    One entry point for each; the left side is the name of the program.
    """
    greeting.judge_list(learner)


@pytest.mark.rules('hello')
def test_hello(learner):
    """`ros2 run greeter hello NAME` runs main of greeter/hello.py.

    The right side is a module as import writes it, then a colon, then a function.
    """
    greeting.judge_program(learner, 'hello')


@pytest.mark.rules('goodbye')
def test_goodbye(learner):
    """`ros2 run greeter goodbye NAME` runs main of greeter/farewell.py.

    The name of the program is goodbye; the module is greeter.farewell.
    """
    greeting.judge_program(learner, 'goodbye')


@pytest.mark.rules('battery', 'rest', 'goodbye')
@pytest.mark.weight(2)
def test_battery(learner):
    """`ros2 run greeter battery NAME` runs the function report of greeter/power/battery.py.

    The module is greeter.power.battery, and the function need not be called main. The folder must be installed, too.
    """
    greeting.judge_program(learner, 'battery')
