"""Visible tests of exercise 6.6, a crate."""

import pytest

from helpers.checks.chapter_06.falling import Crate

pytestmark = pytest.mark.exercise('6.6')


def test_crate(learner):
    """crate(6.0, 0.4, 0.3, 0.2) falls, stands on the floor, and has the inertia 0.065, 0.1 and 0.125 kg m².

    A <collision> like the <visual>, and an <inertial> with origin, mass and inertia.
    """
    crate = Crate(learner, 6.0, 0.4, 0.3, 0.2)
    crate.check_fall()
    crate.check_weight()
