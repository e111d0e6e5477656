"""Visible tests of exercise 8.8, where am I?"""

import pytest

from helpers.checks.chapter_08.deliveries import Localizer, where
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.8')


def test_where(learner):
    """The robot is at (1, 2) and looks to the left: where() is (1, 2, 1.57).

    lookup_transform('map', 'base_footprint', Time()): where the robot is in the map.
    """
    localizer = Localizer(learner)
    node = learner.start('Courier')
    learner.run(0.2)
    localizer.tell(1.0, 2.0, 1.5708)
    learner.run(0.1)
    found = where(node)
    expect(found is not None and list(found) == pytest.approx([1.0, 2.0, 1.5708], abs=1e-4),
           f'where() is {found}, expected (1.0, 2.0, 1.5708).')


def test_unknown(learner):
    """Nobody has said where the robot is: where() is None.

    Catch TransformException.
    """
    Localizer(learner)
    node = learner.start('Courier')
    learner.run(0.2)
    found = where(node)
    expect(found is None, f'No transform has come, and where() is {found}, expected None.')
