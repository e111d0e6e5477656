"""Visible tests of exercise 2.4, a library and its user."""

import pytest

from helpers.checks.chapter_02 import builds, reporting

pytestmark = pytest.mark.exercise('2.4')


@pytest.mark.rules('needs', 'order')
def test_both_are_built(learner):
    """`colcon build --packages-up-to odometry` builds wheel_math, and then odometry.

    colcon knows what odometry needs only from its package.xml.
    """
    reporting.judge_order(learner)


@pytest.mark.rules('needs', 'nothing-else')
def test_needed_at_run_time(learner):
    """odometry says that wheel_math must be there when it runs, and declares nothing else.

    exec_depend, or depend.
    """
    reporting.judge_needs(learner)


@pytest.mark.given
@pytest.mark.rules('nothing-else', 'order', 'build-type')
def test_library_stands_alone(learner):
    """wheel_math needs nobody; the build type of both packages is ament_python.

    A dependency goes in one direction.
    """
    reporting.judge_alone(learner)
    builds.check_build_types(learner)


@pytest.mark.rules('argument', 'prints', 'library')
def test_report(learner):
    """`ros2 run odometry report TICKS` prints the distance for these ticks, such as `0.207 m`.

    import distance from wheel_math.geometry, and take the ticks from sys.argv.
    """
    reporting.judge_report(learner)


@pytest.mark.given
@pytest.mark.rules('argument')
def test_called_later(learner):
    """main takes the ticks from the command line when it is called, and not when its module is imported.

    Read sys.argv inside of main.
    """
    reporting.judge_call(learner)


@pytest.mark.rules('library', 'argument', 'prints')
def test_comes_from_library(learner):
    """The report says what distance of wheel_math returns for the ticks.

    With another library below it, the same program says something else.
    """
    reporting.judge_library(learner)
