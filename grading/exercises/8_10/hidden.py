"""Hidden tests of exercise 8.10, start it: the same launch, judged once more where the marks are given."""

import pytest

from helpers.checks.chapter_08 import test_8_10
from helpers.checks.chapter_08.test_8_10 import story, values_of_the_file, values_of_the_launch

pytestmark = pytest.mark.exercise('8.10')


@pytest.mark.rules('values', 'types', 'robot', 'sim-time', 'world')
@pytest.mark.weight(2)
def test_values(learner):
    """The node has the values of delivery.yaml, and simulated time.

    parameters=[path of the installed file, {'use_sim_time': True}].
    """
    told = story(learner)
    values_of_the_file(learner)
    values_of_the_launch(told)


@pytest.mark.rules('arguments')
def test_arguments(learner):
    """The launch file has the arguments scene and real_time_factor, with their defaults."""
    test_8_10.test_arguments(learner)


@pytest.mark.rules('world')
@pytest.mark.weight(2)
def test_world(learner):
    """The world gets the scene and the real_time_factor that were given to the launch."""
    test_8_10.test_world(learner)


@pytest.mark.rules('drives', 'ends', 'world')
@pytest.mark.weight(4)
def test_drives(learner):
    """Launched, the robot drives off, stands when it is called back, reaches another station, and ends with Ctrl+C."""
    test_8_10.test_drives(learner)
