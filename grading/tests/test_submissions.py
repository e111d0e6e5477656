"""Submissions from anywhere: zips, folders, notebooks; nothing is written, nothing is trusted."""

import io
import json
import stat
import zipfile

import pytest

from grading import submissions
from grading.submissions import Unusable
from grading.tests import small
from helpers.exercises.notebooks import InvalidSubmission

LABEL = json.dumps({'format': 1, 'learner': 'ada'}).encode()


def zipped(path, *members):
    with zipfile.ZipFile(path, 'w') as archive:
        for name, data in members:
            archive.writestr(name, data)
    return path


def test_the_three_forms(tmp_path):
    data = small.solved()
    path = zipped(tmp_path / 'x.zip', (small.NOTEBOOK, data), ('submission.json', LABEL))
    assert submissions.read(path).learner == 'ada'
    folder = tmp_path / 'bob'
    folder.mkdir()
    (folder / small.NOTEBOOK).write_bytes(data)
    (folder / 'notes.txt').write_text('x')
    (tmp_path / 'eve.ipynb').write_bytes(data)
    paths = [tmp_path / 'eve.ipynb', folder, path]
    for found in submissions.find(paths):
        assert found.cells(small.NOTEBOOK, [small.exercise()])[1].source.startswith('# Exercise 90.1')
        assert not found.problem and len(found.files) == 1
    assert [found.learner for found in submissions.find(paths)] == ['ada', 'bob', 'eve']


def test_a_folder_of_submissions(tmp_path):
    for name in ('ada', 'bob'):
        zipped(tmp_path / f'submission-{name}.zip', (small.NOTEBOOK, small.solved()))
    (tmp_path / 'eve').mkdir()
    (tmp_path / 'eve' / small.NOTEBOOK).write_bytes(small.solved())
    (tmp_path / '.hidden').mkdir()
    assert [found.learner for found in submissions.find([tmp_path])] == ['ada', 'bob', 'eve']


@pytest.mark.parametrize(('members', 'problem'), [
    ([], 'no notebook'),
    ([('a/x.ipynb', b'{}'), ('b/x.ipynb', b'{}')], 'two notebooks called x.ipynb'),
    ([('submission.json', b'nonsense'), ('x.ipynb', b'{}')], 'submission.json in the zip is damaged'),
    ([('submission.json', b'{"learner": "../../etc"}'), ('x.ipynb', b'{}')], 'unusable'),
    ([('submission.json', b'{"learner": 5}'), ('x.ipynb', b'{}')], 'unusable'),
    ([('submission.json', b'x' * 20_000), ('x.ipynb', b'{}')], 'larger than'),
    ([(f'{number}.txt', b'') for number in range(300)], 'has 300 members'),
])
def test_unusable_zips(tmp_path, members, problem):
    found = submissions.read(zipped(tmp_path / 'x.zip', *members))
    assert problem in found.problem and not found.files
    with pytest.raises(InvalidSubmission, match=problem):
        found.cells(small.NOTEBOOK, [small.exercise()])


def test_names_in_a_zip_are_never_paths(tmp_path):
    outside = tmp_path / 'evil.ipynb'
    path = zipped(tmp_path / 'x.zip', ('../evil.ipynb', small.solved()), ('/abs/other.ipynb', b'{}'),
                  ('__MACOSX/._x.ipynb', b'x'))
    assert sorted(submissions.read(path).files) == ['evil.ipynb', 'other.ipynb']
    assert not outside.exists() and sorted(tmp_path.iterdir()) == [path]


def test_symbolic_links(tmp_path):
    link = zipfile.ZipInfo('x.ipynb')
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    assert 'symbolic link' in submissions.read(zipped(tmp_path / 'x.zip', (link, b'/etc/passwd'))).problem
    folder = tmp_path / 'ada'
    folder.mkdir()
    (folder / 'x.ipynb').symlink_to('/etc/passwd')
    assert 'no notebook' in submissions.read(folder).problem


def test_zip_bomb(tmp_path):
    path = tmp_path / 'x.zip'
    with zipfile.ZipFile(path, 'w', zipfile.ZIP_DEFLATED) as archive:
        archive.writestr('x.ipynb', b'0' * (20 * 2**20))
    assert 'larger than 10 MB' in submissions.read(path).problem
    # One that lies about its size: the header says 10 bytes.
    data = bytearray(path.read_bytes())
    size = (20 * 2**20).to_bytes(4, 'little')
    path.write_bytes(bytes(data).replace(size, (10).to_bytes(4, 'little')))
    found = submissions.read(path)
    assert found.problem or len(found.files['x.ipynb']) <= 10


@pytest.mark.parametrize('data', [b'', b'PK\x03\x04', b'nonsense', b'PK\x05\x06' + b'\0' * 18])
def test_damaged_zips(tmp_path, data):
    (tmp_path / 'x.zip').write_bytes(data)
    assert submissions.read(tmp_path / 'x.zip').problem


def test_truncated_zip(tmp_path):
    path = zipped(tmp_path / 'x.zip', (small.NOTEBOOK, small.solved()))
    whole = path.read_bytes()
    for size in range(0, len(whole), 97):
        path.write_bytes(whole[:size])
        assert submissions.read(path).problem
    bad = bytearray(whole)
    bad[80] ^= 0xFF  # in the content: the checksum does not fit
    path.write_bytes(bytes(bad))
    assert submissions.read(path).problem


def test_encrypted_zip(tmp_path):
    path = zipped(tmp_path / 'x.zip', (small.NOTEBOOK, small.solved()))
    data = bytearray(path.read_bytes())
    data[6] |= 1
    data[data.rfind(b'PK\x01\x02') + 8] |= 1
    path.write_bytes(bytes(data))
    assert 'encrypted' in submissions.read(path).problem


def test_a_notebook_under_another_name(tmp_path):
    folder = tmp_path / 'ada'
    folder.mkdir()
    (folder / '90_small (1).ipynb').write_bytes(small.solved())
    (folder / 'scratch.ipynb').write_bytes(small.notebook('x = 1'))
    assert submissions.read(folder).cells(small.NOTEBOOK, [small.exercise()])
    (folder / 'copy.ipynb').write_bytes(small.solved())
    with pytest.raises(InvalidSubmission, match='both hold exercises'):
        submissions.read(folder).cells(small.NOTEBOOK, [small.exercise()])
    assert submissions.read(folder).cells('91_x.ipynb', [small.exercise(id='91.1', notebook='91_x.ipynb')]) is None


def test_a_single_damaged_notebook(tmp_path):
    (tmp_path / 'ada.ipynb').write_bytes(b'{')
    with pytest.raises(InvalidSubmission, match='not valid JSON'):
        submissions.read(tmp_path / 'ada.ipynb').cells(small.NOTEBOOK, [small.exercise()])


def test_two_of_one_learner(tmp_path):
    first = zipped(tmp_path / 'a.zip', (small.NOTEBOOK, small.solved()), ('submission.json', LABEL))
    second = zipped(tmp_path / 'b.zip', (small.NOTEBOOK, small.solved()), ('submission.json', LABEL))
    with pytest.raises(Unusable, match=r'a.zip and .*b.zip are both of the learner ada'):
        submissions.find([first, second])


def test_paths_that_are_no_submission(tmp_path):
    (tmp_path / 'x.txt').write_text('x')
    (tmp_path / 'empty').mkdir()
    for path in (tmp_path / 'none', tmp_path / 'x.txt', tmp_path / 'empty'):
        with pytest.raises(Unusable):
            submissions.find([path])


@pytest.mark.parametrize('name', ['=cmd()', '../../x', '\u202egpj', 'a b', '.', '<script>'])
def test_ids_are_names_of_files(tmp_path, name):
    made = submissions._id(name)
    assert submissions.LEARNER.fullmatch(made) and '..' != made


def test_digest_sees_every_change(tmp_path):
    path = tmp_path / 'ada.ipynb'
    digests = set()
    for data in (b'a', b'b', b''):
        path.write_bytes(data)
        digests.add(submissions.read(path).digest())
    (tmp_path / 'bob.ipynb').write_bytes(b'a')
    digests.add(submissions.read(tmp_path / 'bob.ipynb').digest())
    assert len(digests) == 4


def test_reading_keeps_nothing_open(tmp_path):
    data = io.BytesIO()
    with zipfile.ZipFile(data, 'w') as archive:
        archive.writestr(small.NOTEBOOK, small.solved())
    path = tmp_path / 'x.zip'
    path.write_bytes(data.getvalue())
    submissions.read(path)
    path.unlink()
