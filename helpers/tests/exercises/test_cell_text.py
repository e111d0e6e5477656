"""An earlier answer's text, as a lesson puts it into a file."""

import pytest

from helpers.exercises import cell_text, manifest
from helpers.kernel.journal import ExecutedCell
from helpers.tests import small

HEADING = '# Exercise 90.1: a talker\n'
ANSWER = f'{HEADING}class Talker:\n    pass'


@pytest.mark.parametrize(
    ('cells', 'expected'),
    [
        ([ANSWER], ANSWER),
        ([f'{ANSWER}\n\nspin_for(1, Talker())\nX = 2\nprint(1)'], f'{ANSWER}\nX = 2'),
        ([ANSWER, f'{HEADING}print(Talker())'], ANSWER),
        ([f'{ANSWER}\n!ls\n'], f'{ANSWER}\n!ls'),
        ([f'{HEADING}%%answer Talker file.py\nx = 1\n'], f'{HEADING}%%answer Talker file.py\nx = 1'),
    ],
)
def test_the_newest_answer(monkeypatch, cells, expected):
    monkeypatch.setattr(manifest, 'load', lambda: {'90.1': small.exercise()})
    monkeypatch.setattr(cell_text.journal, 'cells', [ExecutedCell('x', text) for text in cells])
    assert cell_text.cell_text('90.1') == expected


def test_an_answer_that_has_not_been_run(monkeypatch):
    monkeypatch.setattr(cell_text.journal, 'cells', [])
    with pytest.raises(LookupError, match='run the cell of exercise 8.5 first'):
        cell_text.cell_text('8.5')
