"""Visible tests of exercise 6.1, a sensor mast."""

import pytest

from helpers.checks.chapter_06 import mast

pytestmark = pytest.mark.exercise('6.1')


@pytest.mark.rules('name', 'late', 'tree')
def test_tree(learner):
    """Whoever comes late hears of all four frames, with the parents of the table.

    Send them as static transforms, all four in one list. header.frame_id is the parent, child_frame_id the child.
    """
    mast.judge_tree(mast.Mast(learner))


@pytest.mark.rules('places', 'tilt')
def test_camera(learner):
    """Each frame is where the table says, for any height, and the camera looks down by any tilt.

    The tilt is given in degrees; functions want radians. A positive pitch looks down.
    """
    there = mast.Mast(learner)
    mast.judge_places(there)
    mast.judge_camera(there)


@pytest.mark.rules('places', 'tilt')
def test_upwards(learner):
    """Also for a mast of a few centimetres, and a camera that looks up: a negative tilt.

    No number needs a case of its own.
    """
    mast.judge_upwards(learner)


@pytest.mark.rules('places', 'tilt', 'lidar', 'optical')
def test_numbers(learner):
    """Each mast has its own height and tilt, whatever they are: 0, large, or with others in the same program.

    No number needs a case of its own.
    """
    mast.judge_numbers(learner)


@pytest.mark.rules('lidar', 'optical')
def test_turned(learner):
    """Both frames of SensorMast(1.0, 20.0) that are turned by halves and quarters look where the table says.

    Half a turn about x is a roll. The optical frame needs two quarter turns: a roll and a yaw, both negative.
    """
    there = mast.Mast(learner, (1.0, 20.0))
    mast.judge_lidar(there)
    mast.judge_optical(there)
