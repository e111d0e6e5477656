"""Hidden tests of exercise 6.1, a sensor mast."""

import pytest

from helpers.checks.chapter_06 import mast
from helpers.checks.chapter_06.test_6_1 import test_numbers, test_upwards  # noqa: F401 - they draw other inputs here

pytestmark = pytest.mark.exercise('6.1')


@pytest.mark.rules('name', 'late', 'tree')
@pytest.mark.weight(2)
def test_tree(learner):
    """The four frames are a tree as in the table, and whoever comes late hears of all of it.

    header.frame_id is the parent, child_frame_id the child. A StaticTransformBroadcaster, and one list.
    """
    mast.judge_tree(mast.Mast(learner))


@pytest.mark.rules('places')
@pytest.mark.weight(2)
def test_places(learner):
    """Each frame is where the table says, for any height.

    A place is given in the frame of the parent: the camera on the mast, not in base_link.
    """
    mast.judge_places(mast.Mast(learner))


@pytest.mark.rules('tilt')
@pytest.mark.weight(2)
def test_camera(learner):
    """The camera looks down by the tilt, which is in degrees.

    Convert with math.radians. By the right-hand rule a positive pitch turns the nose down.
    """
    mast.judge_camera(mast.Mast(learner))


@pytest.mark.rules('lidar')
def test_lidar(learner):
    """The lidar hangs upside down: it looks ahead, its left is the robot's right, and its z points to the floor.

    Half a turn about x: the roll is pi.
    """
    mast.judge_lidar(mast.Mast(learner))


@pytest.mark.rules('optical')
@pytest.mark.weight(2)
def test_optical(learner):
    """In camera_optical, z looks where the camera looks, x to the right, and y down.

    Two quarter turns: a roll and a yaw, both negative.
    """
    mast.judge_optical(mast.Mast(learner))
