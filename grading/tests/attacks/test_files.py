"""Hostile files: archives, notebooks, names. Made here by code; none of them lies in the repository.

All are handed in at once, beside an honest learner. Each gets one line that says what is wrong, and no mark.
"""

import io
import json
import os
import struct
import time
import zipfile
from pathlib import Path

import pytest

from grading import reader, submissions
from grading.submission import Submission
from grading.tests.attacks import arena
from helpers.tests import small

NOTEBOOK = small.NOTEBOOK
EMPTY = arena.notebook({})  # nothing in it is solved: no test runs for it


def archive(*members, level=zipfile.ZIP_DEFLATED) -> bytes:
    """A zip of (name or ZipInfo, data)."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, 'w', level, compresslevel=1) as made:
        for name, content in members:
            made.writestr(name, content)
    return data.getvalue()


def member(name, *, mode=0o644, kind=0o100000) -> zipfile.ZipInfo:
    """A member with the file mode of a Unix system."""
    info = zipfile.ZipInfo(name)
    info.external_attr = (kind | mode) << 16
    info.create_system = 3
    return info


def notebook(**changes) -> bytes:
    """The empty notebook with other fields."""
    return json.dumps({**json.loads(EMPTY), **changes}).encode()


def cell(**changes) -> dict:
    return {**json.loads(EMPTY)['cells'][-1], **changes}


def encrypted() -> bytes:
    data = bytearray(archive((NOTEBOOK, EMPTY)))
    data[6] |= 1
    data[data.index(b'PK\x01\x02') + 8] |= 1
    return bytes(data)


def bomb() -> bytes:
    return archive((NOTEBOOK, b' ' * 200 * 2**20))


def bomb_of_many() -> bytes:
    return archive(*((f'{number:02}_x.ipynb', b'[' + b' ' * 9 * 2**20) for number in range(20)))


def entries() -> bytes:
    return archive(*((f'{number}.txt', b'') for number in range(20_000)), level=zipfile.ZIP_STORED)


def codec(method) -> bytes:
    """A member whose compressed bytes are broken, in a format of which few think."""
    data = bytearray(archive((NOTEBOOK, EMPTY), level=method))
    data[60:90] = b'\xff' * 30
    return bytes(data)


def lying_size() -> bytes:
    """A member of 40 MB of which the directory says that it is 10 bytes long."""
    data = bytearray(archive((NOTEBOOK, b' ' * 40 * 2**20)))
    where = data.index(b'PK\x01\x02')
    data[where + 24 : where + 28] = struct.pack('<I', 10)
    return bytes(data)


def overlapping() -> bytes:
    """Many members that are all the same bytes: a bomb without nesting."""
    data = archive((NOTEBOOK, b' ' * 9 * 2**20))
    begin = data.index(b'PK\x01\x02')
    end = data.index(b'PK\x05\x06')
    entry = data[begin:end]
    count = 150
    names = [f'{number:02}_x{number:06}.ipynb'[: len(NOTEBOOK)].ljust(len(NOTEBOOK), 'x') for number in range(count)]
    names = [f'{number:03}{name[3:-6]}.ipynb' for number, name in enumerate(names)]
    entries = b''.join(entry.replace(NOTEBOOK.encode(), name.encode()) for name in names)
    tail = bytearray(data[end:])
    tail[8:12] = struct.pack('<HH', count, count)
    tail[12:16] = struct.pack('<I', len(entries))
    return data[:begin] + entries + bytes(tail)


# The bytes, or a function that returns them: what takes long is made when the tests run, not when they are collected.
ARCHIVES = {
    'bomb': (bomb, 'larger than'),
    'bomb-of-many': (bomb_of_many, 'larger than'),
    'bomb-overlapping': (overlapping, 'zip'),
    'bomb-nested': (archive(('inner.zip', archive(('inner.zip', archive((NOTEBOOK, EMPTY)))))), 'no notebook'),
    'lying-size': (lying_size, 'zip'),
    'entries': (entries, 'more than 10000'),
    'entries-of-work': (archive(*((f'{number}.ipynb', b'') for number in range(250))), 'more than 200'),
    'entries-of-products': (
        archive(*((f'my_ws/src/p/{"a/" * 20_000}{number}.pyc', b'') for number in range(400))),
        'no notebook',
    ),
    'symlink': (archive((member(NOTEBOOK, kind=0o120000), b'/etc/passwd')), 'symbolic link'),
    'device': (archive((member(NOTEBOOK, kind=0o060000), b'')), 'empty'),
    'encrypted': (encrypted(), 'encrypted'),
    'same-name-twice': (archive((f'a/{NOTEBOOK}', EMPTY), (f'b/{NOTEBOOK}', EMPTY + b' ')), 'two notebooks'),
    'codec': (codec(zipfile.ZIP_BZIP2), 'damaged'),
    'codec-memory': (codec(zipfile.ZIP_LZMA), 'damaged'),
    'truncated': (archive((NOTEBOOK, EMPTY))[:-30], 'damaged'),
    'wrong-checksum': (
        archive((NOTEBOOK, EMPTY), level=zipfile.ZIP_STORED).replace(b'"nbformat"', b'"nbfoRmat"', 1),
        'damaged',
    ),
    'no-zip': (b'#!/bin/sh\n', 'damaged'),
    'empty': (b'', 'damaged'),
    'unknown-method': (
        archive((NOTEBOOK, EMPTY), level=zipfile.ZIP_STORED).replace(
            b'\x50\x4b\x01\x02\x14\x03\x14\x00\x00\x00\x00\x00', b'\x50\x4b\x01\x02\x14\x03\x14\x00\x00\x00\x63\x00'
        ),
        'damaged',
    ),
    'no-notebook': (archive(('conftest.py', 'import os; os._exit(0)'), ('pytest.ini', '[pytest]')), 'no notebook'),
    'label-path': (archive((NOTEBOOK, EMPTY), ('submission.json', '{"learner": "../../zoe"}')), 'unusable'),
    'label-script': (
        archive((NOTEBOOK, EMPTY), ('submission.json', '{"learner": "<script>alert(1)</script>"}')),
        'unusable',
    ),
    'label-list': (archive((NOTEBOOK, EMPTY), ('submission.json', '[["learner"]]')), 'damaged'),
    'label-pickle': (archive((NOTEBOOK, EMPTY), ('submission.json', b'\x80\x04\x95')), 'damaged'),
    'label-deep': (archive((NOTEBOOK, EMPTY), ('submission.json', '[' * 9000)), 'damaged'),
    'label-huge': (archive((NOTEBOOK, EMPTY), ('submission.json', ' ' * 20_000)), 'larger than'),
}
NOTEBOOKS = {
    'nothing': (b'', 'empty'),
    'spaces': (b' \n\t', 'empty'),
    'truncated': (EMPTY[:-200], 'damaged or cut off'),
    'text': (b'print(1)', 'not valid JSON'),
    'number': (b'5', 'not a notebook'),
    'null': (b'null', 'not a notebook'),
    'list': (b'[]', 'not a notebook'),
    'cells-object': (notebook(cells={}), 'not a notebook'),
    'cells-numbers': (notebook(cells=[1, 2]), 'not a cell'),
    'cells-null': (notebook(cells=[None]), 'not a cell'),
    'version-3': (b'{"nbformat": 3, "nbformat_minor": 0, "metadata": {}, "worksheets": [], "cells": []}', 'format 3'),
    'version-99': (notebook(nbformat=99), 'format 99'),
    'version-text': (notebook(nbformat='\ud800<script>'), 'format'),
    'version-list': (notebook(nbformat=[4]), 'format'),
    'source-number': (notebook(cells=[cell(source=5)]), 'not a valid notebook'),
    'source-object': (notebook(cells=[cell(source={'a': 1})]), 'not a valid notebook'),
    'source-of-numbers': (notebook(cells=[cell(source=[1, 2])]), 'not a valid notebook'),
    'source-missing': (notebook(cells=[{'cell_type': 'code', 'metadata': {}}]), 'not a valid notebook'),
    'kind-unknown': (notebook(cells=[cell(cell_type='exec')]), 'not a valid notebook'),
    'id-number': (notebook(cells=[cell(id=7)]), 'not a text'),
    'infinity': (b'{"nbformat": Infinity, "nbformat_minor": 4, "metadata": {}, "cells": []}', 'format None'),
    'version-3-deep': (b'{"nbformat": 3, "worksheets": [{"cells": [[[[1]]]]}], "cells": []}', 'format 3'),
    'long-number': (b'{"nbformat": ' + b'4' * 10_000 + b', "cells": []}', 'not 4: save it'),
    'deep': (b'[' * 100_000, 'nested too deeply'),
    'deep-metadata': (
        b'{"nbformat": 4, "cells": [], "metadata": ' + b'{"a":' * 50_000 + b'1' + b'}' * 50_000 + b'}',
        'nested too deeply',
    ),
    'complex': (b'{"nbformat": 4, "cells": [' + b'[],' * 1_100_000 + b'1]}', 'too complex'),
    'large': (b'{"nbformat": 4, "cells": [], "x": "' + b'x' * 11 * 2**20 + b'"}', 'larger than'),
    'many-cells': (notebook(cells=[cell(source='')] * 2500), 'more than 2000'),
    'long-cell': (notebook(cells=[cell(source='x' * 300_000)]), 'more than 200000'),
    'much-code': (notebook(cells=[cell(source='x' * 150_000)] * 9), 'characters of code'),
    'utf-16': (EMPTY.decode().encode('utf-16'), 'not UTF-8'),
    'latin-1': (notebook(metadata={'x': 'y'}).replace(b'"y"', b'"\xe9"'), 'not UTF-8'),
    'binary': (bytes(range(256)) * 10, 'not'),
    'pickle': (b'\x80\x04\x95\x1f\x00\x00\x00cos\nsystem\n', 'not UTF-8'),
    'key-surrogate': (b'{"\\ud800": 1}', 'not a notebook'),
}
SOLVED = arena.SOLVED['90.1']
# Text of the first exercise's cell: the notebook can be used, this cell cannot, and the others are left as given.
CELLS = {
    'nested-sum': (f'{SOLVED}x = {"+".join(["1"] * 2500)}', 'nested too deeply'),
    'nested-names': (f'{SOLVED}x = a{".b" * 900}', 'nested too deeply'),
    'nested-calls': (f'{SOLVED}x = a{"()" * 900}', 'nested too deeply'),
    'nested-signs': (f'{SOLVED}x = {"-" * 50_000}1', 'Python cannot read'),
    'nested-brackets': (f'{SOLVED}x = {"(" * 50_000}', 'Python cannot read'),
    'zero-byte': (f'{SOLVED}\0', 'Python cannot read'),
    'half-surrogate': (f'{SOLVED}x = "\ud800"', 'Python cannot read'),
    'long-number': (f'{SOLVED}x = {"9" * 5000}', 'Python cannot read'),
    'slow-pattern': (f'{SOLVED}{" " * 150_000}x y', 'Python cannot read'),
    'slow-commands': (f'{SOLVED}{"!x" * 20_000}\n' + '!y\n' * 40_000, 'notebook command'),
    'magic': (f'%%bash\necho\n{SOLVED}', 'notebook command'),
    'look-alike-name': (SOLVED.replace('total', 't\u03bftal'), 'must define `total`'),
    'twice': (f'{SOLVED}"', 'Python cannot read'),
    'escapes': ('\x1b[2J\x1b]0;x\x07 = 1', 'Python cannot read'),
    'markup': ('<script>alert(1)</script>', 'Python cannot read'),
}
NAMES = [
    '<img src=x onerror=alert(1)>',
    '=HYPERLINK("x")',
    '-rf',
    '--help',
    '\x1b[31mred',
    '\u202egnp',
    'a\nb',
    '\udcff',
    'nul\u200bl',
    '{{7*7}}',
    '[red]',
    '%s%n',
    '::error::',
    'x' * 200,
    'results',
    'gradebook.csv',
    '~',
    '$HOME',
]


half_of_the_samples = pytest.mark.one_of(2, group=0)  # all of these need the batch


@pytest.fixture(scope='module')
def batch(tmp_path_factory):
    """All hostile files, graded at once."""
    works = {f'{name}.zip': data() if callable(data) else data for name, (data, _) in ARCHIVES.items()}
    works |= {f'nb-{name}.ipynb': data for name, (data, _) in NOTEBOOKS.items()}
    works |= {f'cell-{name}.ipynb': arena.notebook({'90.1': text}) for name, (text, _) in CELLS.items()}
    works |= {f'{name}.ipynb': EMPTY for name in NAMES}
    works |= {
        'doubled.ipynb': small.notebook(
            small.IMPORTS, *[f'# Exercise 90.1: a sum\n{SOLVED}{more}' for more in ('', 'x = 1')]
        ),
        'eve.zip': archive((NOTEBOOK, EMPTY), ('submission.json', '{"learner": "zoe"}')),
        'slip.zip': archive((f'../../{NOTEBOOK}', EMPTY)),
        'absolute.zip': archive((f'/tmp/{NOTEBOOK}', EMPTY)),
        'windows.zip': archive((f'C:\\..\\{NOTEBOOK}', EMPTY)),
    }

    def more(incoming):
        """What a folder may hold that is no file."""
        folder = incoming / 'links'
        folder.mkdir()
        (folder / NOTEBOOK).symlink_to(incoming / f'{arena.HONEST}.ipynb')
        folder = incoming / 'pipe'
        folder.mkdir()
        os.mkfifo(folder / NOTEBOOK)
        (folder / '91_x.ipynb').write_bytes(EMPTY)

    return arena.grade_batch(tmp_path_factory.mktemp('files'), works, more=more)


def _invalid(batch, learner, fragment):
    record = batch.records[learner]
    assert (record.status, record.score) == ('invalid', 0)
    messages = {exercise.message for exercise in record.exercises}
    assert len(messages) == 1 and fragment in messages.pop(), record.exercises[0].message
    assert fragment in batch.page(learner)


@half_of_the_samples
@pytest.mark.timeout(300)
@pytest.mark.parametrize('name', ARCHIVES)
def test_archive(batch, name):
    _invalid(batch, name, ARCHIVES[name][1])


@half_of_the_samples
@pytest.mark.parametrize('name', NOTEBOOKS)
def test_notebook(batch, name):
    _invalid(batch, f'nb-{name}', NOTEBOOKS[name][1])


@half_of_the_samples
@pytest.mark.parametrize('name', CELLS)
def test_cell(batch, name):
    found = batch.exercise(f'cell-{name}', '90.1')
    assert (found.verdict, found.score) == ('invalid_submission', 0)
    assert CELLS[name][1] in found.message
    assert [batch.exercise(f'cell-{name}', other).verdict for other in ('90.2', '90.3')] == ['not_attempted'] * 2


@half_of_the_samples
def test_doubled_exercise(batch):
    found = batch.exercise('doubled', '90.1')
    assert (found.verdict, found.score) == ('invalid_submission', 0)
    assert 'cells 2 and 3' in found.message


@half_of_the_samples
def test_another_learners_name(batch):
    """An id in a zip that is somebody else's neither takes their mark nor changes it."""
    assert batch.records[arena.HONEST].score == 30
    assert batch.records['eve'].score == 0
    assert any('eve' in line and arena.HONEST in line for line in batch.log)


@half_of_the_samples
@pytest.mark.parametrize('name', ['slip', 'absolute', 'windows'])
def test_paths_in_archives_are_only_names(batch, name):
    assert {result.verdict for result in batch.records[name].exercises} == {'not_attempted'}


@half_of_the_samples
def test_links_and_pipes_are_not_followed(batch):
    assert 'links' not in batch.records or batch.records['links'].score == 0
    assert batch.records['pipe'].score == 0


@half_of_the_samples
def test_around(batch):
    """The honest learner, the files outside, and what was written about all of them."""
    assert batch.records[arena.HONEST].score == 30
    assert not batch.planted and not batch.left
    assert 'Traceback' not in '\n'.join(batch.log)
    outside = {path.name for path in batch.folder.iterdir()}
    assert outside == {'incoming', 'home', 'victim.txt', 'out', 'checks', 'exercises'}
    assert len(batch.records) >= len(ARCHIVES) + len(NOTEBOOKS) + len(CELLS) + len(NAMES)
    for path in batch.output.rglob('*'):
        assert path.is_dir() or path.name.isascii() and path.name.isprintable()
        if path.suffix == '.html':
            assert '<script' not in path.read_text(encoding='utf-8').lower()
    for line in (batch.output / 'gradebook.csv').read_text(encoding='utf-8').splitlines():
        assert not line.startswith(('=', '+', '-', '@'))


def test_many_small_members_beside_large_ones():
    """What a reader's process sends back is taken apart without a copy of all the rest for each member."""
    sizes = [0] * 195 + [8 * 2**20] * 5
    data = json.dumps({'value': None, 'sizes': sizes}).encode() + b'\n' + bytes(sum(sizes))
    begin = time.process_time()
    _, blobs = reader._unpacked(data)
    assert time.process_time() - begin < 2
    assert [len(blob) for blob in blobs] == sizes


# By form, the names of many files that all are one learner's; the last one is the newest.
MANY = {
    'repository': [f'task-submissions/task-eve/{number}.zip' for number in range(100)],
    'repository-deep': [f'task-submissions/task-eve/{number % 7}/{number}.zip' for number in range(100)],
    'moodle': [f'eve_1_assignsubmission_file/{number}.zip' for number in range(100)],
    'canvas': [f'eve_7_{number}_x.zip' for number in range(100)],
    'canvas-notebooks': [f'eve_7_{number}_{NOTEBOOK}' for number in range(100)],
}


@pytest.mark.parametrize('much', [False, True], ids=['many', 'too-much'])
@pytest.mark.parametrize('form', MANY)
def test_one_learner_holds_nobody_up(tmp_path, monkeypatch, form, much):
    """Who hands in very many files, or many that nobody can read in time, has few of them read: the newest ones."""
    for number, name in enumerate(MANY[form]):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b'')
        os.utime(path, (1e9 + number, 1e9 + number))
    (tmp_path / f'{arena.HONEST}.zip').write_bytes(archive((NOTEBOOK, arena.notebook(arena.SOLVED))))
    asked = []

    def read(path):
        asked.append(path.name)
        problem = reader.TOO_MUCH if much and path.stem != arena.HONEST else ''
        return Submission('', path, problem=problem, own=path.stem, handed_in='2026-11-20T10:00:00Z')

    monkeypatch.setattr(submissions, 'read', read)
    found = submissions.find([tmp_path])
    hostile = [name for name in asked if name != f'{arena.HONEST}.zip']
    assert len(hostile) == (submissions.MOST_TOO_MUCH if much else submissions.MOST)
    assert len(asked) == len(hostile) + 1
    assert Path(MANY[form][-1]).name in hostile or form == 'repository-deep'
    (eve,) = [one for one in found if one.own.startswith('eve')]
    assert any('were not read' in note for note in eve.notes)
