"""Hidden tests of exercise 6.7, a robot from an empty file."""

import pytest

from helpers.checks.chapter_06.scouts import Scout, journey
from helpers.runner import about

pytestmark = pytest.mark.exercise('6.7')


@pytest.mark.rules('urdf', 'tree', 'joints', 'places')
@about('urdf')
def test_frames_of_any_size(learner):
    """robot_state_publisher reads the description, and says where the links are, whatever the sizes.

    Each joint says where its child is in its parent, and how it can move.
    """
    scout = Scout(learner, 'frames')
    scout.check_tree()
    scout.check_joints()
    scout.check_places()


@pytest.mark.rules('tree', 'wheels', 'caster', 'floor', 'mass', 'inertia')
@about('urdf')
def test_bodies(learner):
    """What touches, what is heavy, and how heavy it is.

    The table of moments stands above the exercise. A cylinder that lies on its side has other axes.
    """
    scout = Scout(learner, 'bodies')
    scout.check_links()
    scout.check_wheels()
    scout.check_caster()
    scout.check_floor()
    scout.check_mass()
    scout.check_inertia()


@pytest.mark.weight(2)
@pytest.mark.rules('stands', 'scan', 'drive', 'odometry', 'arrives')
@about('urdf')
def test_ride(learner):
    """The robot stands, sees the walls, and drives to a station in the simulated world.

    What only a simulator reads stands in <gazebo> elements, as in the file of the course's robot.
    """
    station, given = journey(learner.random)
    scout = Scout(learner, 'ride', **given)
    scout.check_stands()
    scout.check_scan()
    scout.check_drive()
    scout.check_odometry()
    scout.check_arrival(station)
