"""Programs in disguise do what they did, and their conditions tell nothing."""

import re
import types
from collections import Counter, defaultdict
from random import Random

import pytest

from helpers.runner import disguise

TEXT = """
def which(value, other=1 < 2):
    def inner():
        return 2 < 1

    if 1 < 2 and value:
        return 'first'
    return 'second' if 2 < 1 or inner() or not other else 'third'
"""


@pytest.mark.parametrize('seed', range(5))
def test_a_condition_is_as_true_as_before(seed):
    space: dict = {}
    text = disguise.disguised(TEXT, ['append'], Random(seed))
    exec(text, space)
    assert (space['which'](True), space['which'](False)) == ('first', 'third')
    assert re.findall(r'\b1 < 2\b|\b2 < 1\b', text) == ['1 < 2']  # where there is no variable yet


def both(seed):
    """A program with a condition that is true, and the same with one that is false."""
    return (
        disguise.disguised(f'def drive():\n    return 1 if {condition} else 0\n', ['append'], Random(seed))
        for condition in ('1 < 2', '2 < 1')
    )


@pytest.mark.parametrize('seed', range(5))
def test_right_and_wrong_programs_differ_in_numbers_only(seed):
    digits = str.maketrans('', '', '0123456789')
    right, wrong = (text.translate(digits) for text in both(seed))
    assert right == wrong


def test_no_constant_tells_what_a_condition_is():
    """Not which of them is large or larger than its neighbour, nor whether the condition is turned around."""
    signs: dict[str, Counter] = defaultdict(Counter)
    for seed in range(400):
        for true, text in zip((True, False), both(seed), strict=True):
            (code,) = (one for one in compile(text, 'drive.py', 'exec').co_consts if isinstance(one, types.CodeType))
            numbers = [one for one in code.co_consts if isinstance(one, int) and one > 1]
            value, factor, modulus, limit = numbers
            signs['turned'][true, ' not ' in text] += 1
            signs['limit'][true, limit > modulus / 2] += 1
            for name, pair in {'value, factor': (value, factor), 'factor, modulus': (factor, modulus)}.items():
                signs[name][true, pair[0] < pair[1]] += 1
    for name, seen in signs.items():
        for guess in (True, False):
            assert abs(seen[True, guess] - seen[False, guess]) < 80, (name, seen)


MODULE = """
class Base:
    def ask(self):
        return self._found()


class Robot(Base):
    limit = 3

    def __init__(self):
        self.state, self.server, self.seen = 'idle', 1, 'by getattr: seen'
        self.here = {'here': 1}

    def _found(self):
        self.count = getattr(self, 'count', 0) + self.server
        return self.count + self.limit, self.state, self.seen, self.here['here']

    def step(self):
        return Robot.step
"""


def test_attributes_have_other_names_where_nothing_depends_on_them():
    text = disguise.with_other_attributes(MODULE, {'state', 'ask'}, Random(1))
    space: dict = {}
    exec(text, space)
    robot = space['Robot']()
    assert robot.ask() == (4, 'idle', 'by getattr: seen', 1)
    assert not hasattr(robot, 'server') and not hasattr(robot, '_found')
    assert {'state', 'ask', 'count', 'limit', 'seen', 'here', 'step'} <= set(dir(robot))
