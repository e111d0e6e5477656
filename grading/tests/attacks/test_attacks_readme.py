"""The documentation of the attacks, and the form of the corpus."""

import ast

import pytest

from grading.tests.attacks import arena, readme
from helpers.runner import verdicts

KEYS = {'attack', 'row', 'aims at', 'stopped by', 'expect verdict', 'expect message'}
MORE = {'expect points', 'expect page'}


def test_no_two_have_one_name():
    names = [f'{attack.family}/{attack.name}' for attack in arena.attacks()]
    assert len(set(names)) == len(names) > 100


def test_the_table_is_up_to_date():
    assert readme.updated() == readme.README.read_text(encoding='utf-8'), 'python -m grading.tests.attacks.readme'


@pytest.mark.parametrize('attack', arena.attacks(), ids=lambda attack: f'{attack.family}-{attack.name}')
def test_header(attack):
    assert KEYS <= attack.header.keys() <= KEYS | MORE
    assert attack.aim in arena.TITLES
    assert attack.verdicts <= set(verdicts.VERDICTS) - {verdicts.PASSED, verdicts.GRADER_ERROR}
    assert 0 <= attack.points < arena.POINTS
    assert arena.NAMES[attack.aim] in attack.source
    ast.parse(attack.source)
    assert '|' not in attack.header['attack'] + attack.header['stopped by']
