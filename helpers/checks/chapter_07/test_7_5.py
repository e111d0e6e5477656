"""Visible tests of exercise 7.5, the robot that falls."""

import pytest

from helpers.checks.chapter_07.faulty_robots import CAUSES, FRAMES, FaultyRobot, judge_rare_links
from helpers.runner import about

pytestmark = pytest.mark.exercise('7.5')


@pytest.mark.rules('collision', 'inertial', 'mass', 'inertia', 'frames', 'all')
def test_causes(learner):
    """Each cause is found where it is alone, and nothing is found in a robot that is right.

    link.find('inertial/mass').get('value') is a string.
    """
    for cause in CAUSES:
        for form in range({'mass': 3, 'inertia': 9}.get(cause, 1)):
            with about(cause):
                FaultyRobot(learner.random, cause, form=form).diagnose(learner)
    FaultyRobot(learner.random).diagnose(learner)
    for _ in range(4):
        FaultyRobot(learner.random, flat=True).diagnose(learner)
    for form in (2, 5, 8):  # a sum that is wrong
        with about('inertia'):
            FaultyRobot(learner.random, 'inertia', small=True, form=form).diagnose(learner)
    for frame in FRAMES:
        with about('frames'):
            for _ in range(2):
                FaultyRobot(learner.random, frame=frame).diagnose(learner, 'frames')
    with about('all'):
        FaultyRobot(learner.random, *[('base_link', cause) for cause in ('collision', 'mass', 'inertia')]).diagnose(
            learner, 'all'
        )
        many = [(f'part_{number}', learner.random.choice(['mass', 'inertial', 'collision'])) for number in range(5, 30)]
        FaultyRobot(learner.random, ('base_link', 'mass'), *many, 'mass', parts=30).diagnose(learner, 'all')
        FaultyRobot(learner.random, ('base_link', 'collision'), ('base_link', 'inertial')).diagnose(learner, 'all')
        FaultyRobot(learner.random, *CAUSES, double=True).diagnose(learner, 'all')


@pytest.mark.rules('shape', 'weight', 'kept', 'frames')
def test_repair(learner):
    """The repaired links have what a simulation needs, and all other links are as they were.

    copy.deepcopy copies an element with all that is in it; inertia(shape, mass) gives three numbers.
    """
    both = [('base_link', 'mass'), ('base_link', 'inertia')]
    for causes in ((), *[(cause,) for cause in CAUSES], both, CAUSES):
        # A negative mass shows whose mass the moments are; 0 does not.
        negative = causes in (('mass',), both)
        robot = FaultyRobot(
            learner.random,
            *causes,
            frame='inertial' if negative or not causes else 'empty',
            form=2 if negative else None,
        )
        robot.diagnose(learner, 'all' if causes else 'frames')
        with about('kept'):
            robot.check(learner.call('repair_model', robot.urdf))
    judge_rare_links(learner)
