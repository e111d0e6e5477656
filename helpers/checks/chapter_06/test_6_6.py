"""Visible tests of exercise 6.6, a crate."""

import pytest

from helpers.checks.chapter_06.falling import Crate, a_mass, small
from helpers.runner import about

pytestmark = pytest.mark.exercise('6.6')


@pytest.mark.rules('urdf', 'visual', 'collision', 'place', 'mass', 'centre', 'inertia')
@about('urdf')
def test_crate(learner):
    """A crate of any size falls, stands on the floor, and has the mass and inertia of a solid box.

    A <collision> like the <visual>, and an <inertial> with origin, mass and inertia.
    """
    draw = learner.random.uniform
    sides = [round(side, 3) for side in (draw(0.2, 0.3), draw(0.4, 0.5), draw(0.6, 0.7))]
    learner.random.shuffle(sides)
    crate = Crate(learner, a_mass(learner.random, 2.0, 5.5), *sides)
    crate.check_fall()
    crate.check_weight()
    with about('inertia'):
        other = small(learner, crate)
        other.check_fall()
        other.check_weight()
