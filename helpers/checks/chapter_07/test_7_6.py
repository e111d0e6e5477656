"""Visible tests of exercise 7.6, where is the sensor?"""

import pytest

from helpers.checks.chapter_07.tf_trees import (
    ASIDE,
    CAUSES,
    FaultyTree,
    judge_names,
    judge_other_places,
    judge_rare_trees,
)
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('7.6')


@pytest.mark.rules('unknown', 'two-parents', 'not-connected', 'old', 'newest', 'order')
def test_causes(learner):
    """Each cause is found where it is alone, and nothing in a tree that is well.

    `nearest(name, names)` finds the name that was meant. A way upward goes from each frame to its parent.
    """
    for cause in CAUSES[:3]:
        for moves in (True, False):
            with about(cause.replace(' ', '-')):
                FaultyTree(learner.random, cause, moves=moves).diagnose(learner)
    judge_other_places(learner)
    judge_rare_trees(learner)
    with about('unknown'):
        FaultyTree(learner.random, 'unknown', near=False, moves=True).diagnose(learner)
    for near in (True, False):
        FaultyTree(learner.random, 'not connected', near=near, moves=True, decoy=True).diagnose(learner)
    for aged in ('upper', 'lower', 'both', 'sensor'):
        FaultyTree(learner.random, 'old', aged=aged).in_order().diagnose(learner)
    for _ in range(3):
        with about('newest'):
            FaultyTree(learner.random, 'old').diagnose(learner, rule='newest')
            FaultyTree(learner.random).diagnose(learner, rule='newest')
    for causes in (
        ('unknown', 'old'),
        ('unknown', 'two parents'),
        ('two parents', 'old'),
        (ASIDE, 'not connected'),
        *[('not connected', 'old')] * 6,
    ):
        tree = FaultyTree(learner.random, *causes, moves=True)
        tree.diagnose(learner, [one for one in tree.expected if one[2] == tree.expected[0][2]], 'order')


@pytest.mark.rules('repaired', 'kept', 'nothing')
def test_repair(learner):
    """After your repair of wrong names tf2 finds the sensor; where no name is known, nothing changes.

    Look at both names of every transform.
    """
    for cause in CAUSES[:3]:
        for moves in (True, False):
            tree = FaultyTree(learner.random, cause, moves=moves)
            tree.diagnose(learner)
            with about('repaired'):
                tree.check(tree.repaired(learner, tree.expected))
    judge_names(learner)
    tree = FaultyTree(learner.random)
    with about('repaired'):
        repaired = learner.call('repaired_tf', *tree.arguments)
    tree.check(repaired)
    for cause, near in (('unknown', False), ('not connected', False), ('old', True)):
        tree = FaultyTree(learner.random, cause, near=near)
        with about('nothing'):
            after = tree.repaired(learner, tree.expected)
        expect(
            after == [tree.moving, tree.static],
            f'{tree.expected[0]} cannot be repaired here: repair_tf must return the transforms as they are.',
            'nothing',
        )
