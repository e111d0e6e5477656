"""Hidden tests of exercise 7.6, where is the sensor? Every tree is drawn."""

import pytest

from helpers.checks.chapter_07.findings import compare
from helpers.checks.chapter_07.frames import CAUSES, WHY, Tree

pytestmark = pytest.mark.exercise('7.6')


def test_healthy_tree(learner):
    """A tree without a fault gives an empty list, and stays as it is.

    Transforms that are not on the way may be old; older ones of a frame are no news.
    """
    for _ in range(4):
        tree = Tree(learner.random)
        compare(learner.call('diagnose_tf', *tree.arguments), [], WHY)
        tree.check(learner.call('repaired_tf', *tree.arguments))


@pytest.mark.weight(2)
@pytest.mark.parametrize('cause', CAUSES)
def test_one_fault(learner, cause):
    """Each cause is found where it is alone.

    The table says in which order to look.
    """
    for number in range(10):
        tree = Tree(learner.random, cause, moves=number % 2 == 0)
        compare(learner.call('diagnose_tf', *tree.arguments), tree.expected, WHY)


def test_nobody_near(learner):
    """Without a name that is near, the evidence is empty and nothing is changed.

    nearest returns '' then.
    """
    for cause in ('unknown', 'not connected'):
        tree = Tree(learner.random, cause, near=False)
        compare(learner.call('diagnose_tf', *tree.arguments), tree.expected, WHY)
        repaired = learner.call('repaired_tf', *tree.arguments)
        compare(learner.call('diagnose_tf', *repaired, *tree.arguments[2:]), tree.expected, WHY)


def test_hidden_fault(learner):
    """One fault hides another: only the first one of the table is found.

    `unknown` is the only finding then; `old` is looked for only if nothing else is wrong.
    """
    for causes in (('unknown', 'old'), ('unknown', 'two parents'), ('two parents', 'old'), ('not connected', 'old')):
        tree = Tree(learner.random, *causes)
        first = [one for one in tree.expected if one[2] == causes[0]]
        compare(learner.call('diagnose_tf', *tree.arguments), first, WHY)


@pytest.mark.weight(2)
@pytest.mark.parametrize('cause', ['unknown', 'two parents', 'not connected'])
def test_found_again(learner, cause):
    """In a tf2 buffer with your repaired transforms, the sensor is found, and at the right place.

    Names are exchanged or replaced; numbers stay.
    """
    for number in range(4):
        tree = Tree(learner.random, cause, moves=number % 2 == 0)
        tree.check(learner.call('repaired_tf', *tree.arguments))
