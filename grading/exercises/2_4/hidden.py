"""Hidden tests of exercise 2.4, a library and its user."""

import pytest

from helpers.checks.chapter_02 import reporting
from helpers.checks.chapter_02.test_2_4 import (  # noqa: F401 - they draw other inputs here
    test_called_later,
    test_comes_from_library,
    test_library_stands_alone,
    test_needed_at_run_time,
)

pytestmark = pytest.mark.exercise('2.4')


@pytest.mark.rules('needs', 'order')
def test_order(learner):
    """`colcon build --packages-up-to odometry` builds wheel_math, and then odometry.

    colcon knows what odometry needs only from its package.xml.
    """
    reporting.judge_order(learner)


@pytest.mark.rules('argument', 'prints')
@pytest.mark.weight(2)
def test_other_numbers(learner):
    """`ros2 run odometry report TICKS` prints the distance for these ticks, also with other numbers.

    import distance from wheel_math.geometry, and take the ticks from sys.argv.
    """
    reporting.judge_report(learner, zero=True)
