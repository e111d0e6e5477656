"""How mutants and alternatives change the solution's text."""

import pytest

from grading import trial, variants
from grading.variants import Alternative, Mutant, VariantError

SOLVED = """# Exercise 9.1: add
def add(a, b):
    if a:
        return a + b
    return b


def run():
    return add(1, 2)
"""


@pytest.mark.parametrize(
    ('old', 'new', 'expected'),
    [
        ('a + b', 'a - b', ('a + b', 'a - b')),
        ('if a:\n    return a + b', 'return a', ('    if a:\n        return a + b\n', '    return a\n')),
        # The first line is further in than the last one.
        (
            '    return b\n\n\ndef run():',
            '    return a\n\n\ndef run():',
            ('    return b\n\n\ndef run():', '    return a\n\n\ndef run():'),
        ),
    ],
)
def test_an_edit_takes_the_place_of_a_part_or_of_whole_lines(old, new, expected):
    assert Mutant('m', old=old, new=new).applied(SOLVED, '9.1') == SOLVED.replace(*expected)


@pytest.mark.parametrize(
    ('variant', 'message'),
    [
        (Mutant('m', old='nowhere', new='x'), 'holds this text 0 times, not 1'),
        (Mutant('m', old='return', new='x'), 'holds this text 3 times, not 1'),
        (Mutant('m', old='a + b', new='a + b'), 'changes nothing'),
        (Mutant('m'), 'give either an edit'),
    ],
)
def test_an_edit_that_does_not_fit_is_an_error(variant, message):
    with pytest.raises(VariantError, match=message):
        variant.applied(SOLVED, '9.1')


def test_an_edit_that_does_not_fit_is_told_before_any_answer_is_judged(monkeypatch):
    monkeypatch.setattr(variants, 'alternatives', lambda exercise: [Alternative('odd', old='no text', new='1')])
    with pytest.raises(VariantError, match="exercise 1.1, alternative 'odd': the solution holds this text 0"):
        trial.answers('1.1')
