"""Hidden tests of exercise 2.3, an interface."""

import pytest

from helpers.checks.chapter_02 import docking

pytestmark = pytest.mark.exercise('2.3')


@pytest.mark.rules('to-build', 'to-run', 'group')
def test_declarations(learner):
    """package.xml declares everything that the package needs to be built and to be used.

    std_msgs is needed for both; the generators to build, the runtime to run.
    """
    docking.judge_declared(learner)


@pytest.mark.rules('charge', 'full', 'std-msgs')
def test_charge(learner):
    """Charge has the fields of the specification, in its order, and the constant FULL with the value 100.

    A field is a type, a space and a name. A constant is written with capital letters and `=`.
    """
    docking.judge_charge(learner)


@pytest.mark.rules('request', 'response', 'default')
def test_dock(learner):
    """Dock has the fields of the specification; the speed of a request is 0.2 if nobody sets it.

    In a .srv file, `---` divides the request from the response. A default value stands after the name.
    """
    docking.judge_dock(learner)


@pytest.mark.rules('both', 'std-msgs')
@pytest.mark.weight(2)
def test_on_the_wire(learner):
    """A node offers Dock and publishes Charge; calls are answered and messages arrive, whatever is in their fields.

    This uses the types as chapter 3 and 4 do.
    """
    docking.judge_use(learner, others=True)
