"""Visible tests of exercise 8.8, where am I?"""

import pytest

from helpers.checks.chapter_08 import whereabouts
from helpers.runner import about

pytestmark = [pytest.mark.exercise('8.8'), pytest.mark.wiring(type='place', qos='place')]


@pytest.mark.rules('place', 'yaw', 'newest')
def test_where(learner):
    """where() is the newest place of base_footprint in map, with the yaw from -π to π.

    lookup_transform('map', 'base_footprint', Time()): where the robot is in the map.
    """
    with about('place'):
        lost = whereabouts.Lost(learner)
    whereabouts.judge_place(lost)


@pytest.mark.rules('unknown', 'place')
def test_two_robots(learner):
    """Each of two robots in one program knows what it has heard itself.

    self.buffer = Buffer(), in the constructor.
    """
    with about('place'):
        lost = whereabouts.Lost(learner)
    whereabouts.judge_two(lost)


@pytest.mark.given
@pytest.mark.rules('given')
def test_given(learner):
    """A Courier drives as its given `drive` says, and is a StationKeeper.

    Write `class Courier(StationKeeper)`, and leave `drive` as it is.
    """
    whereabouts.judge_given(learner)


@pytest.mark.rules('unknown', 'old', 'again', 'at-once')
def test_unknown_and_old(learner):
    """where() is None while nobody has said the place, and when what was said is older than 0.5 s.

    Catch TransformException. Compare the stamp of the transform with the clock of the node.
    """
    with about('at-once'):
        lost = whereabouts.Lost(learner)
    whereabouts.judge_unknown(lost)
    whereabouts.judge_age(lost)
