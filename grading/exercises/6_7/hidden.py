"""Hidden tests of exercise 6.7, a robot from an empty file."""

import pytest

from helpers.checks.chapter_06 import scouts
from helpers.checks.chapter_06.test_6_7 import test_bodies  # noqa: F401 - they draw other inputs here
from helpers.runner import about

pytestmark = pytest.mark.exercise('6.7')


@pytest.mark.rules('urdf', 'tree', 'joints', 'places')
@about('urdf')
def test_frames_of_any_size(learner):
    """robot_state_publisher reads the description, and says where the links are, whatever the sizes.

    Each joint says where its child is in its parent, and how it can move.
    """
    scouts.judge_frames(learner)


@pytest.mark.weight(2)
@pytest.mark.rules('stands', 'scan', 'drive', 'odometry', 'arrives')
@about('urdf')
def test_ride(learner):
    """The robot stands, sees the walls, and drives to a station in the simulated world.

    What only a simulator reads stands in <gazebo> elements, as in the file of the course's robot.
    """
    scouts.judge_ride(learner)
