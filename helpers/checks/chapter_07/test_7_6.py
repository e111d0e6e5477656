"""Visible tests of exercise 7.6, where is the sensor?"""

import pytest

from helpers.checks.chapter_07.findings import compare
from helpers.checks.chapter_07.frames import WHY, Tree

pytestmark = pytest.mark.exercise('7.6')


def test_unknown(learner):
    """A sensor's frame that nobody publishes is found, with the frame that has nearly its name.

    nearest(source, frames); a frame is a parent or a child.
    """
    tree = Tree(learner.random, 'unknown')
    compare(learner.call('diagnose_tf', *tree.arguments), tree.expected, WHY)


def test_repair(learner):
    """After your repair of a misspelt frame, tf2 finds the sensor.

    The frame that `evidence` names gets the name that was asked for.
    """
    tree = Tree(learner.random, 'unknown')
    tree.check(learner.call('repaired_tf', *tree.arguments))
