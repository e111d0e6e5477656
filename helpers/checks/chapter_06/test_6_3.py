"""Visible tests of exercise 6.3, where was the cup?"""

import pytest

from helpers.checks.chapter_06.carrying import Scene
from helpers.runner import expect

pytestmark = pytest.mark.exercise('6.3')


def test_two_seconds_ago(learner):
    """Robot and cup move on; where_was(2.0) tells where the cup was, seen from the robot as it stands now.

    lookup_transform_full has a time for the target, one for the source, and a frame that did not move in between.
    """
    scene = Scene(learner, robot=[(0, 0, 0), (1, 0, 0)], cup=[(3, 0, 0), (1, 0.5, 0)])
    node = learner.start('CupFinder')
    scene.run(20)
    scene.ask(node, 2.0)


def test_unknown(learner):
    """As long as tf2 knows nothing, where_was gives None.

    Look-ups raise a TransformException: catch it.
    """
    node = learner.start('CupFinder')
    learner.run(0.5)
    found = node.call('where_was', 0.3)
    expect(found is None, f'No transforms have come, and where_was(0.3) gave {found}, expected None.')
