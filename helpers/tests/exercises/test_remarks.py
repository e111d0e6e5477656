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


OTHER = NotebookCell('RATE = 6', 4, 'other')
VIA = NotebookCell('def double():\n    return 2 * RATE', 2, 'via')


@pytest.mark.parametrize(
    ('ran', 'saved', 'edited', 'expected'),
    [
        ([HELPER], [HELPER], (), ''),
        ([HELPER], [NotebookCell('RATE = 6', 1, 'helper')], ('helper',), 'changed and saved after you ran it'),
        ([HELPER], [NotebookCell('RATE = 6', 1, 'helper')], (), ''),  # run, and not saved yet
        ([HELPER, OTHER], [HELPER, OTHER], (), ''),
        ([OTHER, HELPER], [HELPER, OTHER], (), 'You ran the cell "RATE = 5" last'),
        ([OTHER, HELPER], [HELPER, OTHER, HELPER], (), ''),
        ([OTHER, NotebookCell('RATE = 7', 0, 'new')], [OTHER], (), ''),  # the new one is not saved yet
        ([OTHER, NotebookCell('print(5)', 0, 'new')], [OTHER], (), ''),
        ([HELPER], [NotebookCell('SPEED = 6', 1, 'helper')], ('helper',), ''),  # this is said elsewhere
    ],
)
def test_another_text_in_the_saved_notebook_is_told(ran, saved, edited, expected):
    said = remarks.changed([*ran, ANSWER], [*saved, ANSWER], edited)
    assert [expected in line for line in said] == ([True] if expected else [])


def test_the_same_import_beside_another_one_is_no_change():
    answer = small.cell('class Talker:\n    kind = String')
    one, two, three = (
        NotebookCell(f'from {module} import {names}', number, f'c{number}')
        for number, (module, names) in enumerate(
            [('std_msgs.msg', 'String'), ('std_msgs.msg', 'Bool, String'), ('my_msgs.msg', 'String')]
        )
    )
    assert not remarks.changed([two, one, answer], [one, two, answer], ())
    assert remarks.changed([two, three, answer], [three, two, answer], ())


def test_what_counts_is_what_the_program_has():
    """What an answer needs by way of another cell, too; what stands below it, only if nothing is above."""
    answer = small.cell('class Talker:\n    rate = double()')
    assert remarks.changed([VIA, OTHER, HELPER, answer], [HELPER, OTHER, VIA, answer], ())
    assert remarks.changed([VIA, HELPER, OTHER, answer], [HELPER, VIA, answer, OTHER], ())
    assert not remarks.changed([VIA, OTHER, answer], [VIA, answer, OTHER], ())
    assert not remarks.changed([VIA, HELPER, answer], [small.cell('class Talker: pass')], ())
