"""Hidden tests of exercise 7.6, where is the sensor? Every tree is drawn."""

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


@pytest.mark.rules('old', 'newest', 'kept', 'repaired')
def test_healthy_tree(learner):
    """A tree without a fault gives an empty list, and stays as it is.

    Transforms that are not on the way may be old; older ones of a frame are no news.
    """
    for _ in range(4):
        FaultyTree(learner.random).in_order().diagnose(learner)
        tree = FaultyTree(learner.random)
        tree.diagnose(learner, rule='newest')
        with about('repaired'):
            repaired = learner.call('repaired_tf', *tree.arguments)
        tree.check(repaired)
    trees = [FaultyTree(learner.random, cause).in_order() for cause in CAUSES]
    expect(
        any(learner.call('diagnose_tf', *tree.arguments) for tree in trees),
        f'Trees with a fault give an empty list, too: one for each of {", ".join(CAUSES)}.',
    )


@pytest.mark.rules('unknown', 'two-parents', 'not-connected', 'old')
@pytest.mark.weight(2)
@pytest.mark.parametrize('cause', CAUSES)
def test_one_fault(learner, cause):
    """Each cause is found where it is alone.

    The card says in which order to look.
    """
    for number in range(10):
        with about(cause.replace(' ', '-')):
            FaultyTree(learner.random, cause, moves=number % 2 == 0, decoy=number > 5).in_order().diagnose(learner)


@pytest.mark.rules('unknown', 'two-parents', 'not-connected', 'old', 'newest')
def test_other_places(learner):
    """A cause is found wherever in the trees it is.

    A frame may be a parent only. A frame with two parents need not be on the way; the sensor itself may move.
    """
    for _ in range(2):
        judge_other_places(learner)
        judge_rare_trees(learner)
        for aged in ('both', 'sensor'):
            FaultyTree(learner.random, 'old', aged=aged).in_order().diagnose(learner)


@pytest.mark.rules('newest')
def test_newest(learner):
    """The newest stamp of a frame counts, wherever it comes in the list.

    `max` of sec + nanosec / 1e9.
    """
    for _ in range(6):
        with about('newest'):
            FaultyTree(learner.random, 'old').diagnose(learner, rule='newest')


@pytest.mark.rules('unknown', 'not-connected', 'nothing')
def test_nobody_near(learner):
    """Without a name that is near, the evidence is empty and nothing is changed.

    nearest returns '' then.
    """
    for cause in ('unknown', 'not connected'):
        tree = FaultyTree(learner.random, cause, near=False, decoy=True, moves=True)
        tree.diagnose(learner)
        with about('nothing'):
            repaired = learner.call('repaired_tf', *tree.arguments)
        expect(
            repaired == [tree.moving, tree.static],
            'There is no evidence, and repair_tf has changed something.',
            'nothing',
        )
    tree = FaultyTree(learner.random, 'old')
    with about('nothing'):
        expect(
            learner.call('repaired_tf', *tree.arguments) == [tree.moving, tree.static],
            'Of `old` transforms repair_tf has changed something.',
            'nothing',
        )


@pytest.mark.rules('order')
def test_hidden_fault(learner):
    """One fault hides another: only the first one of the card is found.

    `unknown` is the only finding then; `old` is looked for only if nothing else is wrong.
    """
    for causes in (
        ('unknown', 'old'),
        ('unknown', 'two parents'),
        ('two parents', 'old'),
        (ASIDE, 'not connected'),
        *[('not connected', 'old')] * 6,
    ):
        tree = FaultyTree(learner.random, *causes, moves=True)
        tree.diagnose(learner, [one for one in tree.expected if one[2] == tree.expected[0][2]], 'order')


@pytest.mark.rules('repaired', 'kept')
@pytest.mark.weight(2)
@pytest.mark.parametrize('cause', ['unknown', 'two parents', 'not connected'])
def test_found_again(learner, cause):
    """In a tf2 buffer with your repaired transforms, the sensor is found, and at the right place.

    Names are exchanged or replaced; numbers stay.
    """
    for number in range(4):
        tree = FaultyTree(learner.random, cause, moves=number % 2 == 0)
        tree.diagnose(learner)
        with about('repaired'):
            tree.check(tree.repaired(learner, tree.expected))
    judge_names(learner)
