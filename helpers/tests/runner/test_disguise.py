"""Programs in disguise do what they did, and their conditions tell nothing."""

from random import Random

import pytest

from helpers.runner import disguise

TEXT = """
def which(value):
    if 1 < 2 and value:
        return 'first'
    return 'second' if 2 < 1 else 'third'
"""


@pytest.mark.parametrize('seed', range(5))
def test_a_condition_is_as_true_as_before(seed):
    space: dict = {}
    text = disguise.disguised(TEXT, ['append'], Random(seed))
    exec(text, space)
    assert (space['which'](True), space['which'](False)) == ('first', 'third')
    assert '1 < 2' not in text
    assert '2 < 1' not in text


def test_right_and_wrong_programs_differ_in_numbers_only():
    right, wrong = (
        disguise.disguised(f'def drive():\n    return 1 if {condition} else 0\n', ['append'], Random(3)).splitlines()
        for condition in ('1 < 2', '2 < 1')
    )
    digits = str.maketrans('', '', '0123456789')
    assert [line.translate(digits) for line in right] == [line.translate(digits) for line in wrong]
