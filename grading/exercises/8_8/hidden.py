"""Hidden tests of exercise 8.8, where am I?"""

import pytest

from helpers.checks.chapter_08 import whereabouts
from helpers.runner import about

pytestmark = [pytest.mark.exercise('8.8'), pytest.mark.wiring(type='place', qos='place')]


@pytest.mark.rules('place', 'yaw', 'newest')
@pytest.mark.weight(5)
def test_place(learner):
    """where() gives x, y and yaw of base_footprint in map.

    The first argument of lookup_transform is the frame in which you want to know the place. A quaternion and its
    negative are the same turn: math.remainder(…, math.tau).
    """
    with about('place'):
        lost = whereabouts.Lost(learner)
    whereabouts.judge_place(lost)


@pytest.mark.given
@pytest.mark.rules('given')
@pytest.mark.weight(1)
def test_given(learner):
    """A Courier drives as its given `drive` says, and is a StationKeeper.

    Write `class Courier(StationKeeper)`, and leave `drive` as it is.
    """
    whereabouts.judge_given(learner)


@pytest.mark.rules('unknown', 'at-once', 'place')
@pytest.mark.weight(2)
def test_unknown(learner):
    """Nothing is known, or only half of the way: where() is None, at once, without an exception.

    Catch TransformException: several errors of tf2 have it as their base.
    """
    with about('at-once'):
        lost = whereabouts.Lost(learner)
    whereabouts.judge_unknown(lost)
    whereabouts.judge_two(lost)


@pytest.mark.rules('old', 'again', 'at-once')
@pytest.mark.weight(3)
def test_old(learner):
    """A place that is older than 0.5 s is None; a new one counts again.

    Time() asks for the newest transform, however old it is. Compare its stamp with the clock of the node.
    """
    with about('old'):
        lost = whereabouts.Lost(learner)
    whereabouts.judge_age(lost)
