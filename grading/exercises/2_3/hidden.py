"""Hidden tests of exercise 2.3, an interface."""

import pytest

from helpers.checks.chapter_02 import docking
from helpers.checks.chapter_02.test_2_3 import test_charge, test_dock  # noqa: F401 - they draw other inputs here

pytestmark = pytest.mark.exercise('2.3')


@pytest.mark.rules('to-build', 'to-run', 'group')
def test_declarations(learner):
    """package.xml declares everything that the package needs to be built and to be used.

    std_msgs is needed for both; the generators to build, the runtime to run.
    """
    docking.judge_declared(learner)


@pytest.mark.rules('both', 'std-msgs')
@pytest.mark.weight(2)
def test_on_the_wire(learner):
    """A node offers Dock and publishes Charge; calls are answered and messages arrive, whatever is in their fields.

    This uses the types as chapter 3 and 4 do.
    """
    docking.judge_use(learner, others=True)
