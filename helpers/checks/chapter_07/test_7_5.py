"""Visible tests of exercise 7.5, the robot that falls."""

import pytest

from helpers.checks.chapter_07.findings import compare
from helpers.checks.chapter_07.models import WHY, Robot

pytestmark = pytest.mark.exercise('7.5')


def test_mass(learner):
    """A mass that is not more than 0 is found, with its value as in the file.

    link.find('inertial/mass').get('value') is a text.
    """
    robot = Robot(learner.random, 'mass')
    compare(learner.call('diagnose_model', robot.urdf), robot.expected, WHY)


def test_collision(learner):
    """A link without <collision> is found, and gets origin and geometry of its visual.

    copy.deepcopy copies an element with all that is in it.
    """
    robot = Robot(learner.random, 'collision')
    compare(learner.call('diagnose_model', robot.urdf), robot.expected, WHY)
    robot.check(learner.call('repair_model', robot.urdf))
