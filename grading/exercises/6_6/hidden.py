"""Hidden tests of exercise 6.6, a crate."""

import pytest

from helpers.checks.chapter_06.falling import Crate, a_mass, small
from helpers.runner import about

pytestmark = pytest.mark.exercise('6.6')


def crate(learner) -> Crate:
    """A crate of any size; no two sides are equal."""
    draw = learner.random.uniform
    sides = [draw(0.2, 0.3), draw(0.4, 0.5), draw(0.6, 0.7)]
    learner.random.shuffle(sides)
    return Crate(learner, a_mass(learner.random, 3.0, 8.0), *(round(side, 3) for side in sides))


@pytest.mark.rules('urdf', 'visual', 'collision', 'place')
@about('urdf')
def test_fall(learner):
    """The crate falls, touches the floor with its bottom, and stands.

    The <collision> has the shape and the origin of the <visual>.
    """
    one = crate(learner)
    one.check_fall()
    small(learner, one).check_fall()


@pytest.mark.rules('urdf', 'mass', 'centre', 'inertia')
@about('urdf')
def test_weight(learner):
    """Mass, centre and inertia are those of a solid box.

    The inertia about an axis: mass / 12 times the sum of the squares of the two other sides. In kg and metres.
    """
    one = crate(learner)
    one.check_weight()
    small(learner, one).check_weight()
