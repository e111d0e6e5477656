"""Submissions from anywhere: zips, folders, notebooks; nothing is written, nothing is trusted."""

import io
import json
import os
import stat
import time
import unicodedata
import zipfile
from itertools import count
from pathlib import Path

import pytest

from grading import late, reader, submission, submissions
from grading.submission import Unusable
from helpers import paths
from helpers.exercises import handing_in, manifest
from helpers.tests import small

LABEL = json.dumps({'format': 1, 'learner': 'ada'}).encode()


def program_of(found) -> dict:
    """The program of exercise 90.1."""
    return found.programs([small.exercise()], [small.exercise()]).programs['90.1']


def why(found) -> str:
    """Why there is no program of exercise 90.1."""
    return found.programs([small.exercise()], [small.exercise()]).without['90.1'][1]


def zipped(path, *members):
    with zipfile.ZipFile(path, 'w') as archive:
        for name, data in members:
            archive.writestr(name, data)
    return path


def test_the_three_forms(tmp_path):
    data = small.solved()
    path = zipped(tmp_path / 'x.zip', (small.NOTEBOOK, data), ('submission.json', LABEL))
    assert submissions.read(path).label == 'ada'
    folder = tmp_path / 'bob'
    folder.mkdir()
    (folder / small.NOTEBOOK).write_bytes(data)
    (folder / 'notes.txt').write_text('x')
    (tmp_path / 'eve.ipynb').write_bytes(data)
    paths = [tmp_path / 'eve.ipynb', folder, path]
    for found in submissions.find(paths):
        assert program_of(found)['cells'][-1]['source'].startswith('# Exercise 90.1')
        assert not found.problem and len(found.files) == 1
    assert [found.learner for found in submissions.find(paths)] == ['ada', 'bob', 'eve']


def test_a_zip_that_windows_has_packed_again(tmp_path):
    """Some programs write backslashes between the names of folders."""
    path = zipped(
        tmp_path / 'x.zip',
        (f'work\\notebooks\\{small.NOTEBOOK}', small.solved()),
        ('work\\notebooks\\my_ws\\src\\patrol\\setup.py', b'pass'),
        ('work\\__MACOSX\\x.ipynb', b'{}'),
        ('submission.json', LABEL),
    )
    (found,) = submissions.find([path])
    assert list(found.files) == [small.NOTEBOOK, 'my_ws/src/patrol/setup.py'] and found.learner == 'ada'


def test_capital_letters_at_the_end_of_a_name(tmp_path):
    """Some systems write them."""
    zipped(tmp_path / 'ADA.ZIP', (small.NOTEBOOK.upper(), small.solved()))
    (tmp_path / 'Eve.IPYNB').write_bytes(small.solved())
    found = submissions.find([tmp_path])
    assert [one.learner for one in found] == ['ADA', 'Eve']
    assert all(program_of(one) for one in found)


def test_a_folder_of_submissions(tmp_path):
    for name in ('ada', 'bob'):
        zipped(tmp_path / f'submission-{name}.zip', (small.NOTEBOOK, small.solved()))
    (tmp_path / 'eve').mkdir()
    (tmp_path / 'eve' / small.NOTEBOOK).write_bytes(small.solved())
    (tmp_path / '.hidden').mkdir()
    assert [found.learner for found in submissions.find([tmp_path])] == ['ada', 'bob', 'eve']


def test_notebooks_named_after_learners_are_one_submission_each(tmp_path):
    for name in ('ada.ipynb', 'bob.ipynb'):
        (tmp_path / name).write_bytes(small.solved())
    zipped(tmp_path / 'x.zip', (small.NOTEBOOK, small.solved()), ('submission.json', b'{"learner": "eve"}'))
    assert [found.learner for found in submissions.find([tmp_path])] == ['ada', 'bob', 'eve']


@pytest.mark.parametrize(
    'names',
    [
        [f'Jane Doe_{number}_assignsubmission_file/{small.NOTEBOOK}' for number in (1, 2)],
        [f'{name}_7_{number}_{small.NOTEBOOK}' for number, name in enumerate(('bob', 'doejane'))],
    ],
)
def test_the_zip_of_a_whole_class_is_to_be_unpacked(tmp_path, names):
    path = zipped(tmp_path / 'class.zip', *((name, small.solved()) for name in names))
    with pytest.raises(Unusable, match='several learners: unpack it'):
        submissions.find([path])
    assert submissions.find([zipped(tmp_path / 'one.zip', (names[0], small.solved()))])


def test_a_chapter_beside_a_zip_is_refused_not_lost(tmp_path):
    (tmp_path / small.NOTEBOOK).write_bytes(small.solved())
    zipped(tmp_path / 'x.zip', (small.NOTEBOOK, small.solved()))
    with pytest.raises(Unusable, match='holds both 90_small.ipynb.* and x.zip'):
        submissions.find([tmp_path])


@pytest.mark.parametrize(
    ('members', 'problem'),
    [
        ([], 'no notebook'),
        ([('submission.json', b'nonsense'), ('x.ipynb', b'{}')], 'submission.json in the zip is damaged'),
        ([('submission.json', b'{"learner": "../../etc"}'), ('x.ipynb', b'{}')], 'unusable'),
        ([('submission.json', b'{"learner": 5}'), ('x.ipynb', b'{}')], 'unusable'),
        ([('submission.json', b'x' * 20_000), ('x.ipynb', b'{}')], 'larger than'),
        ([(f'{number}.ipynb', b'') for number in range(300)], 'has 300 notebooks and files of packages'),
        ([(f'{number}.txt', b'') for number in range(20_000)], 'has 20000 members'),
    ],
)
def test_unusable_zips(tmp_path, members, problem):
    found = submissions.read(zipped(tmp_path / 'x.zip', *members))
    assert problem in found.problem and not found.files
    assert problem in why(found)


def test_two_files_of_a_notebook_leave_the_other_chapters(tmp_path):
    """What is wrong with the file of a notebook concerns its own exercises."""
    other = small.exercise(id='91.1', notebook='91_x.ipynb')
    other_notebook = small.notebook('# Exercise 91.1: y\nclass Talker: pass')
    for name, members, problem in (
        ('two', [(f'a/{small.NOTEBOOK}', b'{}'), (f'b/{small.NOTEBOOK}', b'{} ')], 'two notebooks called'),
        ('large', [(small.NOTEBOOK, b' ' * 11 * 2**20)], 'larger than 10 MB'),
        ('renamed', [('90_small (1).ipynb', b' ' * 11 * 2**20)], 'larger than 10 MB'),
    ):
        found = submissions.read(zipped(tmp_path / f'{name}.zip', *members, ('91_x.ipynb', other_notebook)))
        assert problem in why(found) and not found.problem
        assert found.programs([other], [other]).programs['91.1']


@pytest.mark.parametrize(
    'place',
    [
        '.ipynb_checkpoints/90_small-checkpoint.ipynb',
        'backup-20261101-101500/90_small.ipynb',
        '.venv/share/90_small.ipynb',
        'again/90_small.ipynb',
    ],
)
def test_copies_that_programs_have_made_are_left_out(tmp_path, place):
    """A learner packs the whole folder. A copy that is the same is none."""
    data = small.solved() if 'again' in place else small.solved() + b' '
    found = submissions.read(
        zipped(tmp_path / 'x.zip', (f'nb/{small.NOTEBOOK}', small.solved()), (f'nb/{place}', data))
    )
    assert program_of(found)


def test_a_folder_that_was_packed_by_hand_has_products_of_builds_in_it(tmp_path):
    """With --symlink-install, colcon leaves links, and each build leaves its log."""
    link = zipfile.ZipInfo('nb/my_ws/install/patrol/lib/patrol/route')
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    logs = [(f'nb/my_ws/log/build_{number}/events.log', 'x') for number in range(300)]
    package = [
        ('nb/my_ws/src/patrol/setup.py', 'x'),
        ('nb/my_ws/src/patrol/patrol/__pycache__/route.cpython-311.pyc', b'\xff'),
        ('nb/my_ws/src/patrol/patrol.egg-info/PKG-INFO', 'Name: patrol'),
        *((f'nb/my_ws/src/patrol/build/{number}', b'\xff') for number in range(150)),
    ]
    found = submissions.read(
        zipped(tmp_path / 'x.zip', (f'nb/{small.NOTEBOOK}', small.solved()), (link, '/home/ada/x'), *logs, *package)
    )
    assert program_of(found)
    assert sorted(found.files) == [small.NOTEBOOK, 'my_ws/src/patrol/setup.py']


def test_a_zip_in_a_zip(tmp_path):
    """Some platforms, and some people, pack the file of `submit` once more. Twice more is too much."""
    inner = zipped(tmp_path / 'inner.zip', (small.NOTEBOOK, small.solved()), ('submission.json', LABEL)).read_bytes()
    once = zipped(tmp_path / 'once.zip', ('submission-ada.zip', inner))
    found = submissions.read(once)
    assert program_of(found) and found.label == 'ada'
    twice = submissions.read(zipped(tmp_path / 'twice.zip', ('once.zip', once.read_bytes())))
    assert 'no notebook' in twice.problem


@pytest.mark.parametrize('method', [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_a_broken_codec_stops_nobody(tmp_path, method):
    """Such a zip is given by its name, as a shell does for *.zip."""
    with zipfile.ZipFile(tmp_path / 'x.zip', 'w', method) as archive:
        archive.writestr(small.NOTEBOOK, small.solved())
    data = bytearray((tmp_path / 'x.zip').read_bytes())
    data[60:90] = b'\xff' * 30
    (tmp_path / 'x.zip').write_bytes(data)
    (found,) = submissions.find([tmp_path / 'x.zip'])
    assert found.problem and not found.files


def test_names_in_a_zip_are_never_paths(tmp_path):
    outside = tmp_path / 'evil.ipynb'
    path = zipped(
        tmp_path / 'x.zip', ('../evil.ipynb', small.solved()), ('/abs/other.ipynb', b'{}'), ('__MACOSX/._x.ipynb', b'x')
    )
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
    assert 'larger than 10 MB' in submissions.read(path).unusable['x.ipynb']
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
    assert program_of(submissions.read(folder))
    (folder / 'copy.ipynb').write_bytes(small.solved())
    assert 'both hold exercises' in why(submissions.read(folder))
    other = small.exercise(id='91.1', notebook='91_x.ipynb')
    assert submissions.read(folder).programs([other], [other]).without == {
        '91.1': ('not_attempted', '91_x.ipynb was not handed in.')
    }


def test_a_single_damaged_notebook(tmp_path):
    (tmp_path / 'ada.ipynb').write_bytes(b'{')
    assert 'not valid JSON' in why(submissions.read(tmp_path / 'ada.ipynb'))


def test_two_names_that_claim_one_learner(tmp_path):
    first = zipped(tmp_path / 'a.zip', (small.NOTEBOOK, small.solved()), ('submission.json', LABEL))
    second = zipped(tmp_path / 'b.zip', (small.NOTEBOOK, small.solved()), ('submission.json', LABEL))
    found = {one.learner: one.notes for one in submissions.find([first, second])}
    assert sorted(found) == ['a', 'b']
    assert "a, b all say that they are ada's" in found['a'][0]


def test_paths_that_are_no_submission(tmp_path):
    (tmp_path / 'x.txt').write_text('x')
    (tmp_path / 'empty').mkdir()
    for path in (tmp_path / 'none', tmp_path / 'x.txt', tmp_path / 'empty'):
        with pytest.raises(Unusable):
            submissions.find([path])


@pytest.mark.parametrize('name', ['=cmd()', '../../x', '\u202egpj', 'a b', '.', '<script>', '王芳', 'x' * 300, 'Zoë'])
def test_ids_are_names_of_files(tmp_path, name):
    made = submission.identity(name)
    assert submission.LEARNER.fullmatch(made) and '..' != made


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


def test_ids_stay_apart():
    assert submission.identity('Zoë') == 'Zoe'
    for copy in ('submission-ada (1)', 'ada - Copy (2)', 'ada copy', 'ada copy 3', 'ada (1) (1)'):
        assert submission.identity(copy) == submission.identity('ada') == 'ada'
    names = ('王芳', '李娜', 'x' * 70, 'x' * 71)
    assert len({submission.identity(name) for name in names}) == len(names)


# Many submissions


def learners(path, *more):
    return [found.learner for found in submissions.find([path, *more])]


def work(path, source=small.TALKER):
    """A notebook, or a zip without a label."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.suffix == '.zip':
        return zipped(path, (small.NOTEBOOK, small.solved(source)))
    path.write_bytes(small.solved(source))
    return path


def labelled(path, learner, **label):
    path.parent.mkdir(parents=True, exist_ok=True)
    return zipped(
        path,
        (small.NOTEBOOK, small.solved(f'# {path}\n{small.TALKER}')),
        ('submission.json', json.dumps({'learner': learner, **label})),
    )


def test_moodle(tmp_path):
    work(tmp_path / 'Jane Doe_123_assignsubmission_file_' / small.NOTEBOOK)
    work(tmp_path / 'Zoë Ng_124_assignsubmission_file' / 'anything.zip')
    labelled(tmp_path / 'Max Um_125_assignsubmission_file_submission-max.zip', 'max')
    (tmp_path / 'Li Lo_126_assignsubmission_file_').mkdir()
    (tmp_path / 'Li Lo_126_assignsubmission_file_' / 'work.pdf').write_bytes(b'x')
    found = {one.learner: one for one in submissions.find([tmp_path])}
    assert sorted(found) == ['Jane_Doe_123', 'Li_Lo_126', 'Max_Um_125', 'Zoe_Ng_124']
    assert 'no notebook' in found['Li_Lo_126'].problem and not found['Zoe_Ng_124'].problem


def test_one_zip_handed_in_by_two(tmp_path):
    for name, label in (('Jane Doe_123', 'jane'), ('Max Um_125', 'jane'), ('Li Lo_126', 'li')):
        labelled(tmp_path / f'{name}_assignsubmission_file_x.zip', label)
    found = {one.learner: one.notes for one in submissions.find([tmp_path])}
    assert found == {
        'Jane_Doe_123': ['Max_Um_125 handed in a zip with the same id inside, jane'],
        'Max_Um_125': ['Jane_Doe_123 handed in a zip with the same id inside, jane'],
        'Li_Lo_126': [],
    }


def test_canvas(tmp_path):
    for name in ('doejane_LATE_1234_5678_03_a.ipynb', 'doejane_1234_5679_04_b.ipynb', 'um_1300_5680_x.zip'):
        work(tmp_path / name)
    jane, um = submissions.find([tmp_path])
    assert (jane.learner, sorted(jane.files)) == ('doejane_1234', ['03_a.ipynb', '04_b.ipynb'])
    assert um.learner == 'um_1300'


def test_one_chapter_that_was_delivered_twice_costs_no_other(tmp_path):
    for name in ('doejane_1234_5678_03_a.ipynb', 'doejane_1234_5680_03_a.ipynb', 'doejane_1234_5679_04_b.ipynb'):
        work(tmp_path / name)
    (jane,) = submissions.find([tmp_path])
    assert not jane.problem and sorted(jane.files) == ['03_a.ipynb', '04_b.ipynb']  # equal ones are one
    (tmp_path / 'doejane_1234_5680_03_a.ipynb').write_bytes(b'{}')
    (jane,) = submissions.find([tmp_path])
    assert not jane.problem and 'two notebooks called 03_a' in jane.unusable['03_a.ipynb']
    assert '04_b.ipynb' in jane.files


def test_github_classroom(tmp_path):
    """Clones of the learners' repositories; a link in one of them is not followed."""
    folder = tmp_path / 'talker-submissions'
    work(folder / 'talker-jane' / 'notebooks' / small.NOTEBOOK)
    work(folder / 'talker-max-um' / small.NOTEBOOK)
    (folder / 'talker-eve').mkdir()
    (folder / 'talker-eve' / 'notebooks').symlink_to(folder / 'talker-jane' / 'notebooks')
    found = {one.learner: one for one in submissions.find([folder])}
    assert sorted(found) == ['eve', 'jane', 'max-um']
    assert 'no notebook' in found['eve'].problem
    assert learners(tmp_path) == ['eve', 'jane', 'max-um']


def test_folders_in_folders_and_what_is_left_out(tmp_path):
    labelled(tmp_path / 'monday' / 'ada.zip', 'ada')
    work(tmp_path / 'tuesday' / 'group' / 'bob' / small.NOTEBOOK)
    (tmp_path / 'list.csv').write_text('x')
    (tmp_path / 'empty').mkdir()
    skipped = []
    assert [one.learner for one in submissions.find([tmp_path], skipped)] == ['ada', 'bob']
    assert sorted(path.name for path in skipped) == ['empty', 'list.csv']
    assert learners(tmp_path, tmp_path / 'monday' / 'ada.zip') == ['ada', 'bob'], 'one file is one submission'


def test_the_latest_counts(tmp_path):
    """By the stamp inside the zip, then by the file's time; the others are on record."""
    first = labelled(tmp_path / '1' / 'ada.zip', 'ada', saved='2026-11-02T10:00:00Z')
    second = labelled(tmp_path / '2' / 'ada.zip', 'ada', saved='2026-11-01T10:00:00Z')
    third = work(tmp_path / '3' / 'ada (1).ipynb')
    os.utime(first, (0, 0))
    os.utime(third, (10**9, 10**9))
    (one,) = submissions.find([first, second, third])
    assert (one.source, one.handed_in) == (first, '2026-11-02T10:00:00Z')
    assert [(attempt.source, attempt.handed_in) for attempt in one.earlier] == [
        ('ada (1).ipynb', '2001-09-09T01:46:40Z'),
        ('ada.zip', '2026-11-01T10:00:00Z'),
    ]
    assert submissions.find([third, second, first]) == [one]


def test_nobody_hands_in_for_another(tmp_path):
    """A zip that claims to be ada's does not take the place of ada's own."""
    ada = labelled(tmp_path / 'ada.zip', 'ada', saved='2026-11-01T10:00:00Z')
    labelled(tmp_path / 'eve.zip', 'ada', saved='2026-12-01T10:00:00Z')
    found = {one.learner: one for one in submissions.find([tmp_path])}
    assert found['ada'].source == ada and not found['ada'].earlier
    assert "submission.json says that it is ada's" in found['eve'].notes[0]


def test_names_that_give_the_same_id_are_different_learners(tmp_path):
    for name in ('José', 'Jose', 'anna müller', 'anna_muller', 'bob'):
        (tmp_path / f'{name}.ipynb').write_bytes(small.solved())
    found = {one.learner: one for one in submissions.find([tmp_path])}
    assert {one.own for one in found.values()} == {'José', 'Jose', 'anna müller', 'anna_muller', 'bob'}
    assert found['Jose'].own == 'Jose' and found['anna_muller'].own == 'anna_muller' and not found['bob'].notes
    other = submission.apart('José')
    assert (
        f'José and Jose give the same id, Jose, and are taken for different learners: this one is {other}'
        in found[other].notes
    )


def test_who_finds_a_name_with_the_same_short_id_is_told_apart(tmp_path):
    """The ids of names that are not of ASCII letters are short, so others with the same id can be looked for."""
    wanted = submission.identity('王芳')[-4:]
    other = next(name for number in count() if submission.identity(name := f'李{number}')[-4:] == wanted)
    assert submission.apart(other)[-20:] != submission.apart('王芳')[-20:]
    made = [submission.Submission('x-1', Path(f'{name}.ipynb'), own=name) for name in ('王芳', other)]
    submissions._tell_apart(made)
    assert len({one.learner for one in made}) == 2


@pytest.mark.parametrize(
    'name', ['jane/evil.zip', 'jane/work.ipynb', 'evil.zip', 'Jane_5_assignsubmission_file_x.ipynb']
)
def test_what_is_no_file_stops_nobody_else(tmp_path, name):
    """A pipe, as an archive of a learner's may have made it."""
    work(tmp_path / 'zoe' / small.NOTEBOOK)
    (tmp_path / name).parent.mkdir(exist_ok=True)
    os.mkfifo(tmp_path / name)
    found = {one.learner: one for one in submissions.find([tmp_path])}
    bad = found.pop(next(learner for learner in found if learner != 'zoe'))
    assert 'cannot be read' in bad.problem and late.is_stamp(bad.handed_in)
    assert set(found) == {'zoe'} and not found['zoe'].problem


def test_a_protected_folder_stops_nobody_else(tmp_path, monkeypatch):
    work(tmp_path / 'zoe' / small.NOTEBOOK)
    work(tmp_path / 'jane' / small.NOTEBOOK)
    plain = Path.iterdir

    def iterdir(path):
        if path.name == 'jane':  # also for root, whom no mode keeps out
            raise PermissionError(13, 'Permission denied')
        return plain(path)

    monkeypatch.setattr(Path, 'iterdir', iterdir)
    found = {one.learner: one.problem for one in submissions.find([tmp_path])}
    assert found['zoe'] == '' and 'cannot be read' in found['jane']


def test_one_name_in_two_forms_of_unicode_is_one_learner(tmp_path):
    for folder, form in (('a', 'NFC'), ('b', 'NFD')):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / unicodedata.normalize(form, 'José.zip')).write_bytes(
            zipped(tmp_path / 'x', (small.NOTEBOOK, small.solved(folder))).read_bytes()
        )
    (one,) = submissions.find([tmp_path / 'a', tmp_path / 'b'])
    assert one.learner == 'Jose' and len(one.earlier) == 1


@pytest.mark.parametrize(
    'saved',
    [
        '2026-13-45T00:00:00Z',
        '2026-02-30T10:00:00Z',
        '9999-99-99T99:99:99Z',
        '０000-01-01T00:00:00Z',
        5,
        ['x'],
        '2026-11-20T10:00:00Z\n',
        '２０２６-11-20T10:00:00Z',
        '2026-11-2٠T10:00:00Z',
        '0001-01-01T00:00:00Z',
    ],
)
def test_a_date_that_there_is_not_is_not_taken(tmp_path, saved):
    label = json.dumps({'learner': 'ada', 'saved': saved}).encode()
    found = submissions.read(zipped(tmp_path / 'x.zip', (small.NOTEBOOK, small.solved()), ('submission.json', label)))
    assert late.is_stamp(found.handed_in) and 'which is no time' in found.notes[0] and found.files


@pytest.mark.parametrize(
    'source',
    [
        'def f(): pass\n' * 13_000,
        'x = ' + ' ' * 60_000 + '!',
        '%' + ' ' * 60_000 + 'x' + ' ' * 60_000 + '?',
        '(' * 150_000,
        '-' * 190_000 + '1',
        'x = ' + '[' * 90 + ']' * 90 + '\n' + 'lambda: ' * 20_000,
        '\\\n' * 60_000,
        "f'" + '{' * 60_000,
        'a' + ' ' * 60_000 + 'b',
        '@a\n' * 40_000,
    ],
    ids=range(10),
)
def test_reading_takes_no_time(tmp_path, source):
    """Not even with cells that are made for it: each is bounded, and another exercise is graded."""
    (tmp_path / 'eve.ipynb').write_bytes(small.notebook(source, '# Exercise 90.1: a talker\n' + small.TALKER))
    begin = time.monotonic()
    found = submissions.read(tmp_path / 'eve.ipynb').programs([small.exercise()], [small.exercise()])
    assert '90.1' in found.programs
    assert time.monotonic() - begin < 10


def test_a_relative_path_is_one_of_this_moment(tmp_path, monkeypatch):
    """The reader's server was started in another folder."""
    submissions.find([work(tmp_path / 'eve.ipynb')])
    monkeypatch.chdir(tmp_path)
    assert [one.learner for one in submissions.find([Path('eve.ipynb')])] == ['eve']


def test_what_cannot_be_read_is_that_submissions_own(tmp_path):
    """A reader that is killed, that crashes, or whose answer is none, harms nobody else."""
    (tmp_path / 'eve.ipynb').write_bytes(small.solved())
    for way in ('spin', 'crash', 'memory', 'raise', 'answer'):
        with pytest.raises(reader.TooMuch):
            reader.ask('grading.tests.trouble:run', way)
        assert submissions.read(tmp_path / 'eve.ipynb').files, way


def test_what_submit_packs_can_be_graded(tmp_path):
    packed = handing_in.pack('ada', tmp_path / 'ada.zip')
    read = submissions.read(packed.path)
    exercises = list(manifest.load().values())
    assert read.label == 'ada' and read.programs(exercises, exercises).without[exercises[0].id][0] == 'not_attempted'
    books = [name for name in read.files if submission.is_notebook(name)]
    assert sorted(books) == sorted(path.name for path in paths.NOTEBOOKS.glob('*.ipynb'))


PACKAGE = small.exercise(2, names=('PACKAGE',), folder='my_ws/src/patrol')
BOTH = [small.exercise(), PACKAGE]


def packed(tmp_path, *members):
    """A zip with a solved notebook and these members, read; what it holds for both exercises."""
    path = zipped(tmp_path / 'ada.zip', (small.NOTEBOOK, small.solved()), *members)
    found = submissions.read(path)
    assert not found.problem
    return found.programs(BOTH, BOTH)


@pytest.mark.parametrize('top', ['', 'ada/notebooks/'])
def test_a_package_in_a_zip(tmp_path, top):
    made = packed(tmp_path, (f'{top}my_ws/src/patrol/setup.py', 'x'), (f'{top}my_ws/src/patrol/a/b.ipynb', '{}'))
    source = made.programs['90.2']['cells'][-1]['source']
    assert source == "# Exercise 90.2: a talker\nPACKAGE = {\n    'a/b.ipynb': '{}',\n    'setup.py': 'x',\n}\n"
    assert '90.1' in made.programs


def test_a_zip_of_an_older_version_has_no_package(tmp_path):
    made = packed(tmp_path)
    verdict, said = made.without['90.2']
    assert verdict == 'not_attempted' and said.startswith('No package was handed in. `./course submit` packs my_ws/src')
    assert '90.1' in made.programs


def test_a_cell_does_not_stand_for_a_package(tmp_path):
    """The answer is the folder, also if a cell has the heading of the exercise."""
    text = small.solved().decode().replace('Exercise 90.1', 'Exercise 90.2')
    found = submissions.read(zipped(tmp_path / 'ada.zip', (small.NOTEBOOK, text)))
    assert found.programs([PACKAGE], BOTH).without['90.2'][0] == 'not_attempted'


def test_a_package_without_its_notebook(tmp_path):
    found = submissions.read(
        zipped(tmp_path / 'ada.zip', ('x.ipynb', small.notebook('x')), ('my_ws/src/patrol/a', 'b'))
    )
    made = found.programs(BOTH, BOTH)
    assert '90.2' in made.programs and '90.1' in made.without


@pytest.mark.parametrize(
    ('members', 'problem'),
    [
        ([('my_ws/src/patrol/../../../evil', 'x')], 'Use letters, digits'),
        ([('my_ws/src/patrol//etc/passwd', 'x')], 'Use letters, digits'),
        ([('my_ws/src/patrol/a:b', 'x')], 'Use letters, digits'),
        ([('my_ws\\src\\patrol\\..\\..\\..\\evil', 'x')], 'Use letters, digits'),
        ([('my_ws/src/patrol/a', 'x'), ('my_ws/src/patrol/a', 'y')], 'two files called my_ws/src/patrol/a'),
        ([('my_ws/src/patrol/a', 'x'), ('b/my_ws/src/patrol/a', 'y')], 'two files called my_ws/src/patrol/a'),
        ([('my_ws/src/patrol/a', 'x'), ('my_ws/src/patrol/a/b', 'y')], 'the name of the folder of a/b'),
        ([('my_ws/src/patrol/a', b' ' * 30 * 2**20)], 'a in your package has more than 64 kB'),
        ([(f'my_ws/src/patrol/{number}', b' ' * 2**16) for number in range(90)], 'more than 256 kB together'),
        ([(f'my_ws/src/patrol/{number}', '') for number in range(150)], 'files, more than 100'),
        ([('my_ws/src/patrol/a', b'\xff')], 'no text in UTF-8'),
    ],
)
@pytest.mark.filterwarnings('ignore:Duplicate name')
def test_a_hostile_package_harms_its_own_exercise_only(tmp_path, members, problem):
    made = packed(tmp_path, *members)
    verdict, said = made.without['90.2']
    assert verdict == 'invalid_submission' and problem in said
    assert '90.1' in made.programs
    assert [path.name for path in tmp_path.rglob('*')] == ['ada.zip']


def test_a_link_or_a_device_in_a_package(tmp_path):
    link, device = (zipfile.ZipInfo(f'my_ws/src/patrol/{name}') for name in ('link', 'device'))
    link.external_attr, device.external_attr = (stat.S_IFLNK | 0o777) << 16, (stat.S_IFCHR | 0o666) << 16
    found = submissions.read(zipped(tmp_path / 'ada.zip', (small.NOTEBOOK, small.solved()), (link, '/etc/passwd')))
    assert 'symbolic link' in found.problem
    assert "'device': 'x'" in packed(tmp_path, (device, 'x')).programs['90.2']['cells'][-1]['source']


def test_the_digest_sees_a_package(tmp_path):
    texts = 'one', 'other', ''
    digests = set()
    for text in texts:
        members = [('my_ws/src/patrol/a', text)] if text else []
        path = zipped(tmp_path / 'ada.zip', (small.NOTEBOOK, small.solved()), *members)
        digests.add(submissions.read(path).digest())
    assert len(digests) == len(texts)
