"""Visible tests of exercise 6.3, where was the cup?"""

import pytest

from helpers.checks.chapter_06.carrying import CarriedCup, told
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('6.3')


@pytest.mark.rules('name', 'point', 'then', 'robot-now', 'stamp', 'far', 'none', 'too-long')
@about('none')
def test_cup(learner):
    """Robot and cup move on; the node is asked before it can know, some seconds later, and half a minute later.

    lookup_transform_full has a time for the target, one for the source, and a frame that did not move in between.
    """
    draw = learner.random.uniform
    there = CarriedCup(
        learner,
        robot=[(draw(-1, 1), draw(-1, 1), draw(-3, 3)), (draw(0.5, 1), draw(0.5, 1), draw(0.3, 0.5))],
        cup=[(draw(3, 5), draw(3, 5), draw(-3, 3)), (draw(-0.8, -0.3), draw(0.3, 0.8), draw(-0.5, 0.5))],
    )
    node = learner.start('CupFinder')
    other = learner.start('CupFinder', beside=node)
    expect(node.name == '/cup_finder', f'Your node is called {node.name}, expected /cup_finder.', 'name')
    learner.run(0.2)
    found = node.call('where_was', 0.3)
    expect(found is None, f'No transforms have come, and where_was(0.3) gave {told(found)}, expected None.')
    only = learner.random.choice(['base_link', 'cup'])
    there.tell(only)
    learner.run(0.3)
    found = node.call('where_was', 0.3)
    expect(found is None, f'Only `{only}` has said where it is, and where_was(0.3) gave {told(found)}, expected None.')
    with about('then'):
        there.run(10)
        seconds = round(draw(1.1, 1.8), 2)  # one whole second and a part
        there.ask(node, seconds)
        there.run(2)
        there.ask(node, round(draw(0.5, 2.1), 2))
        there.ask(node, seconds)  # the same question has another answer now
        there.ask_too_early(node)
        there.ask_first(other)
        there.ask_now(node)
    with about('too-long'):
        seconds = round(draw(3.2, 9.0), 1)
        found = node.call('where_was', seconds)
        expect(
            found is None,
            f'The first transforms came less than 3 s ago, and where_was({seconds}) gave {told(found)}, '
            'expected None: nobody knows. Do not take another time instead.',
        )
    with about('robot-now'):
        there.ask_quiet_robot(node)
    with about('far'):
        there.ask_long_ago(node)
