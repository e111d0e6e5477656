"""What a check says of cells that were run and are gone."""

import pytest

from helpers.exercises import remarks
from helpers.exercises.notebooks import NotebookCell
from helpers.tests import small

ANSWER = small.cell('class Talker:\n    rate = RATE + len("abc")')
HELPER = NotebookCell('RATE = 5', 0, 'helper')


@pytest.mark.parametrize(
    ('saved', 'expected'),
    [
        ([ANSWER], 1),
        ([HELPER, ANSWER], 0),
        ([NotebookCell('RATE = 5', 0, 'pasted again'), ANSWER], 0),
        ([NotebookCell('RATE = 6', 0, 'helper'), ANSWER], 0),  # changed, and not run since
        ([NotebookCell('def f():\n    pass\nRATE = f()', 0, 'another'), ANSWER], 0),
        ([small.cell('class Talker: pass')], 0),  # the answer is not saved yet
        ([], 0),
    ],
)
def test_a_cell_that_was_deleted_is_missed(saved, expected):
    said = remarks.lost([NotebookCell('import os', 0, 'i'), HELPER, ANSWER], saved)
    assert len(said) == expected and all('`RATE` comes from a cell that is no longer' in line for line in said)
