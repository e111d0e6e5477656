"""Reading notebooks from anywhere: one typed error with a clear sentence for whatever is wrong."""

import json
import subprocess
import sys

import nbformat
import pytest

from helpers.exercises import notebooks
from helpers.exercises.notebooks import InvalidSubmission
from helpers.tests import small

GOOD = json.loads(small.notebook('x = 1'))
CODE = GOOD['cells'][0]


def changed(**changes):
    return json.dumps({**GOOD, **changes}).encode()


MALFORMED = {
    'empty': b'',
    'blank': b'  \n',
    'truncated': json.dumps(GOOD).encode()[:-20],
    'no JSON': b'hello',
    'list': b'[]',
    'number': b'5',
    'no cells': b'{"nbformat": 4}',
    'cells no list': changed(cells={}),
    'cell no object': changed(cells=[5]),
    'cell without type': changed(cells=[{'source': ''}]),
    'unknown cell type': changed(cells=[{**CODE, 'cell_type': 'spell'}]),
    'source a number': changed(cells=[{**CODE, 'source': 5}]),
    'source of numbers': changed(cells=[{**CODE, 'source': [5]}]),
    'source missing': changed(cells=[{'cell_type': 'code', 'metadata': {}, 'outputs': [], 'execution_count': None}]),
    'id a number': changed(cells=[{**CODE, 'id': 7}]),
    'format 3': changed(nbformat=3),
    'format text': changed(nbformat='4'),
    'format huge': changed(nbformat=10**30),
    'format infinity': changed(nbformat=float('inf')),
    'deep': b'[' * 20000 + b']' * 20000,
    'deep objects': b'{"cells":' * 20000 + b'1' + b'}' * 20000,
    'UTF-16': json.dumps(GOOD).encode('utf-16'),
    'null bytes': b'\0' * 100,
    'latin-1': b'{"cells": "\xe9"}',
    'too many cells': changed(cells=[CODE] * (notebooks.MAX_CELLS + 1)),
    'huge cell': changed(cells=[{**CODE, 'source': 'x' * (notebooks.MAX_SOURCE + 1)}]),
    'too large': b' ' * (notebooks.MAX_BYTES + 1),
    'many brackets': b'[' + b'{},' * 1_000_001 + b'{}]',
}


@pytest.mark.parametrize('data', MALFORMED.values(), ids=MALFORMED.keys())
def test_malformed(data):
    with pytest.raises(InvalidSubmission, match='^mine.ipynb') as caught:
        notebooks.parse(data, 'mine.ipynb')
    text = str(caught.value)
    assert len(text) < 200 and '\n' not in text and 'Error' not in text


def test_good_forms():
    lines = changed(cells=[{**CODE, 'source': ['x = 1\n', 'y = 2']}, {'cell_type': 'markdown', 'source': '# Hi'}])
    assert [(cell.source, cell.number) for cell in notebooks.parse(lines, 'n')] == [('x = 1\ny = 2', 1)]
    assert notebooks.parse(b'\xef\xbb\xbf' + small.notebook('x'), 'n')[0].source == 'x'
    assert notebooks.parse(small.notebook('x\r\ny'), 'n')[0].source == 'x\ny'
    minor = changed(nbformat_minor=2, cells=[{key: value for key, value in CODE.items() if key != 'id'}])
    assert notebooks.parse(minor, 'n')[0].id is None


def test_a_notebook_of_format_3():
    """As IPython wrote them until 2015, and some tools still do."""
    old = nbformat.writes(nbformat.convert(nbformat.reads(small.notebook('x = 1'), as_version=4), 3), version=3)
    assert [cell.source for cell in notebooks.parse(old.encode(), 'n')] == ['x = 1']


def test_no_numbers_in_outputs():
    """Python writes NaN for what a plot has left out."""
    data = json.dumps({**GOOD, 'cells': [{**CODE, 'outputs': [{'data': [float('nan'), float('inf')]}]}]}).encode()
    assert b'NaN' in data and notebooks.parse(data, 'n')[0].source == 'x = 1'
    data = data.replace(b'NaN', b'7' * 5000)  # more digits than Python reads
    assert notebooks.parse(data, 'n')[0].source == 'x = 1'


def test_outputs_are_not_read():
    wild = changed(cells=[{**CODE, 'outputs': 'nonsense', 'execution_count': 'x', 'metadata': {'a': [1]}}])
    assert notebooks.parse(wild, 'n')[0].source == 'x = 1'


def test_read_names_a_missing_file(tmp_path):
    with pytest.raises(InvalidSubmission, match='none.ipynb cannot be read'):
        notebooks.read(tmp_path / 'none.ipynb')
    with pytest.raises(InvalidSubmission, match='cannot be read'):
        notebooks.read(tmp_path)


def test_who_reads_a_notebook_makes_no_grammar():
    """Packages that jsonschema imports if they are there may take a second, in each kernel and each grader."""
    code = 'import sys; from helpers.exercises import notebooks; print(*{"lark", "rfc3987_syntax"} & set(sys.modules))'
    assert subprocess.check_output([sys.executable, '-c', code], text=True).split() == []
