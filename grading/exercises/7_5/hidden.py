"""Hidden tests of exercise 7.5, the robot that falls. Every robot is drawn."""

import pytest

from helpers.checks.chapter_07.faulty_robots import CAUSES, FRAMES, FaultyRobot, judge_rare_links
from helpers.runner import about

pytestmark = pytest.mark.exercise('7.5')


@pytest.mark.given
@pytest.mark.rules('frames', 'kept', 'mass', 'inertia')
def test_healthy_robot(learner):
    """A robot without a fault gives an empty list and is not changed. A link without <visual> is a frame.

    A frame needs neither mass nor collision.
    """
    for _ in range(8):
        FaultyRobot(learner.random, flat=True).diagnose(learner)
    for number in range(6):
        FaultyRobot(learner.random).diagnose(learner)
        robot = FaultyRobot(learner.random, frame=FRAMES[number % len(FRAMES)])
        robot.diagnose(learner, 'frames')
        with about('kept'):
            robot.check(learner.call('repair_model', robot.urdf))


@pytest.mark.rules('collision', 'inertial', 'mass', 'inertia')
@pytest.mark.weight(2)
@pytest.mark.parametrize('cause', CAUSES)
def test_one_link(learner, cause):
    """Each cause is found where it is alone.

    The table has four.
    """
    for form in range(12):
        with about(cause):
            FaultyRobot(learner.random, cause, form=form, small=form > 5).diagnose(learner)


@pytest.mark.rules('all')
def test_several_links(learner):
    """Several links, and several faults of one link, are several findings.

    Do not stop at the first one.
    """
    for _ in range(5):
        robot = FaultyRobot(
            learner.random,
            *learner.random.sample(CAUSES, 2),
            ('base_link', 'mass'),
            ('base_link', 'inertia'),
            ('base_link', 'collision'),
        )
        robot.diagnose(learner, 'all')
    many = [(f'part_{number}', learner.random.choice(CAUSES)) for number in range(12)]
    FaultyRobot(learner.random, *many, parts=12).diagnose(learner, 'all')
    FaultyRobot(learner.random, ('base_link', 'collision'), ('base_link', 'inertial')).diagnose(learner, 'all')
    for _ in range(2):
        FaultyRobot(learner.random, *CAUSES, double=True).diagnose(learner, 'all')


@pytest.mark.rules('shape', 'weight', 'kept')
@pytest.mark.weight(2)
def test_repaired_links(learner):
    """Repaired links have the collision of the visual, a mass, and moments that fit to shape and mass.

    If mass and moments are wrong, the moments are those for the new mass.
    """
    both = [('base_link', 'mass'), ('base_link', 'inertia')]
    for causes in (['collision'], ['mass'], ['inertia'], ['inertial'], both):
        for number in range(4):
            robot = FaultyRobot(learner.random, *causes, form=number, frame=FRAMES[number % len(FRAMES)])
            robot.diagnose(learner, 'all')
            with about('kept'):
                robot.check(learner.call('repair_model', robot.urdf))
    judge_rare_links(learner)


@pytest.mark.rules('shape', 'weight', 'kept')
@pytest.mark.weight(2)
def test_it_stands(learner):
    """Dropped from one metre, the repaired robot comes to rest on the floor.

    MuJoCo simulates it for two seconds.
    """
    robot = FaultyRobot(
        learner.random, ('base_link', 'collision'), ('base_link', 'inertia'), 'mass', 'collision', 'inertial'
    )
    robot.diagnose(learner, 'all')
    with about('kept'):
        repaired = learner.call('repair_model', robot.urdf)
    robot.drop(learner, repaired)
