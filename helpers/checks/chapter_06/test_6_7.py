"""Visible tests of exercise 6.7, a robot from an empty file."""

import pytest

from helpers.checks.chapter_06 import scouts
from helpers.runner import about

pytestmark = pytest.mark.exercise('6.7')


@pytest.mark.rules('urdf', 'tree', 'joints', 'places')
@about('urdf')
def test_frames(learner):
    """robot_state_publisher reads the description, and says where the links are.

    Each joint says where its child is in its parent, and how it can move.
    """
    scouts.judge_frames(learner, 'large')


@pytest.mark.rules('tree', 'places', 'wheels', 'caster', 'floor', 'mass', 'inertia')
@about('urdf')
def test_bodies(learner):
    """What touches, what is heavy, and how heavy it is.

    The table of moments stands above the exercise. A cylinder that lies on its side has other axes.
    """
    scouts.judge_bodies(learner)


@pytest.mark.rules('stands', 'scan', 'drive', 'odometry', 'arrives')
@about('urdf')
def test_ride(learner):
    """The robot stands, sees the walls, and drives to a station in the simulated world.

    What only a simulator reads stands in <gazebo> elements, as in the file of the course's robot.
    """
    scouts.judge_ride(learner)
