"""Hidden tests of exercise 6.3, where was the cup?"""

import pytest

from helpers.checks.chapter_06.carrying import CarriedCup, told
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('6.3')


def scene(learner) -> CarriedCup:
    """A robot that turns while it drives, and a cup that goes another way: no two places are the same."""
    draw = learner.random.uniform
    return CarriedCup(
        learner,
        robot=[(draw(-1, 1), draw(-1, 1), draw(-3, 3)), (draw(0.5, 1), draw(0.5, 1), draw(0.3, 0.5))],
        cup=[(draw(3, 5), draw(3, 5), draw(-3, 3)), (draw(-0.8, -0.3), draw(0.3, 0.8), draw(-0.5, 0.5))],
    )


@pytest.mark.weight(3)
@pytest.mark.rules('then', 'name', 'point', 'robot-now', 'stamp')
@about('then')
def test_seconds_ago(learner):
    """The place of the cup some seconds ago, seen from the robot as it stands now: two times in one look-up.

    Target time: the newest, Time(). Source time: the clock's now, less the seconds. The map did not move.
    """
    there = scene(learner)
    node = learner.start('CupFinder')
    expect(node.name == '/cup_finder', f'Your node is called {node.name}, expected /cup_finder.', 'name')
    there.run(25)
    for seconds in (learner.random.uniform(1.5, 2.5), learner.random.uniform(3.5, 4.5)):
        there.ask(node, round(seconds, 2))


@pytest.mark.rules('then', 'robot-now')
@about('then')
def test_again(learner):
    """A second question, later, gets a new answer.

    One buffer and one listener for the life of the node.
    """
    there = scene(learner)
    node = learner.start('CupFinder')
    there.run(10)
    there.ask(node, 1.1)
    there.run(10)
    there.ask(node, round(learner.random.uniform(0.4, 3.0), 2))
    there.ask(node, 1.1)
    there.ask_too_early(node)
    there.ask_now(node)
    there.ask_quiet_robot(node)


@pytest.mark.weight(2)
@pytest.mark.rules('far', 'then', 'too-long')
@about('far')
def test_long_ago(learner):
    """It can look back for 30 s.

    A buffer keeps 10 s, unless you say Buffer(Duration(seconds=…)).
    """
    there = scene(learner)
    node = learner.start('CupFinder')
    there.run(10, 1.0)
    there.ask(node, round(learner.random.uniform(5.0, 8.0), 1))
    there.ask_long_ago(node)


@pytest.mark.weight(2)
@pytest.mark.rules('none', 'too-long')
@about('none')
def test_unknown(learner):
    """None where tf2 cannot know: nothing has come, only the robot is known, or it is longer ago than anything.

    Catch TransformException: LookupException, ConnectivityException and ExtrapolationException are all of this kind.
    """
    learner.now = learner.random.randint(1000, 1900) * 10**9
    node = learner.start('CupFinder')
    learner.run(3.0, step=1.0)
    found = node.call('where_was', 1.0)
    expect(found is None, f'No transforms have come, and where_was(1) gave {told(found)}, expected None.', 'none')
    there = scene(learner)
    there.tell('cup')
    learner.run(0.3)
    found = node.call('where_was', 0.3)
    expect(found is None, f'Only the cup is known, and where_was(0.3) gave {told(found)}, expected None.', 'none')
    there = scene(learner)
    there.run(5)
    seconds = round(learner.random.uniform(2.0, 2.8), 1)
    found = node.call('where_was', seconds)
    expect(
        found is None,
        f'The first transforms came 1.3 s ago, and where_was({seconds}) gave {told(found)}, expected None: '
        'nobody knows. Do not take another time instead.',
        'too-long',
    )
    there.run(5)
    expect(
        node.call('where_was', 1.1) is not None,
        'Robot and cup have said where they are for 2 s, and where_was(1.1) still gave None.',
        'robot-now',
    )
