"""Attacks on whose work it is: names, ids and files that take another learner's place, in this run or in a later one.

No program runs here: who is graded, and under which id, is all that counts. The honest learner is ada.
"""

import json
import os
import zipfile

import pytest

from grading import grading_run, late, submissions, unit
from grading.submission import Unusable, apart, own_name
from grading.tests import runs
from helpers.tests import small

FULL = sum(exercise.points for exercise in runs.COURSE.exercises)


@pytest.fixture(autouse=True)
def no_program(monkeypatch):
    """ada's notebook is worth all points, any other one half of them."""
    monkeypatch.setattr(unit, 'perform', runs.perform)


def packed(path, text: str, learner: str = ''):
    """A zip with a notebook of this text, and with the id of a learner."""
    with zipfile.ZipFile(path, 'w') as archive:
        archive.writestr(small.NOTEBOOK, text)
        if learner:
            archive.writestr('submission.json', json.dumps({'learner': learner, 'saved': '2026-11-20T10:00:00Z'}))
    return path


def graded(folder, **settings) -> dict[str, grading_run.Record]:
    """What is in `folder / 'in'`, graded into `folder / 'out'`: the records by learner."""
    found = submissions.find([folder / 'in'])
    records = grading_run.grade(found, runs.COURSE, folder / 'out', settings=grading_run.Settings(seed='s', **settings))
    return {record.learner: record for record in records}


@pytest.fixture
def handed_in(tmp_path):
    (tmp_path / 'in').mkdir()
    return tmp_path / 'in'


def as_zip(folder):
    packed(folder / 'ada.zip', 'ada', 'ada')


def as_zip_without_id(folder):
    packed(folder / 'submission-ada.zip', 'ada')


def as_folder(folder):
    (folder / 'ada').mkdir()
    (folder / 'ada' / small.NOTEBOOK).write_text('ada')


@pytest.mark.one_of(3)
@pytest.mark.parametrize('stays', [True, False], ids=['stays', 'goes'])
@pytest.mark.parametrize('arrives', [as_zip, as_zip_without_id, as_folder])
@pytest.mark.parametrize('name', ['eve', 'zoe', 'Ada', 'submission-final (1)'])
def test_an_id_that_was_taken_before_its_owner_came(tmp_path, handed_in, name, arrives, stays):
    """A zip has said ada's id in an earlier run: her own work gets it, and the other one is told by its file's name."""
    first = packed(handed_in / f'{name}.zip', 'something', 'ada')
    assert graded(tmp_path)['ada'].score == FULL / 2
    if not stays:
        first.unlink()
    arrives(handed_in)
    for _ in range(3):
        records = graded(tmp_path)
        (other,) = records.keys() - {'ada'}
        assert (records['ada'].own, records['ada'].score) == ('ada', FULL)
        assert records[other].score == FULL / 2
    before = runs.contents(tmp_path / 'out')
    graded(tmp_path)
    assert runs.contents(tmp_path / 'out') == before


def test_an_id_that_is_on_record_is_not_taken(tmp_path, handed_in):
    as_zip(handed_in)
    graded(tmp_path)
    (handed_in / 'ada.zip').unlink()
    packed(handed_in / 'eve.zip', 'nothing', 'ada')
    records = graded(tmp_path)
    assert (records['ada'].score, records['eve'].score) == (FULL, FULL / 2)


@pytest.mark.parametrize('victim', ['José', 'Jose'])
@pytest.mark.parametrize('attacker', ['mallory', 'Zoe', 'submission-x (1)'])
def test_an_id_that_the_grader_gives_is_taken_by_no_zip(tmp_path, handed_in, victim, attacker):
    """The ids that tell names apart are known to everybody: a zip that says one gets its file's name."""
    for name in ('José', 'Jose'):
        packed(handed_in / f'{name}.zip', 'ada')
    packed(handed_in / f'{attacker}.zip', 'nothing', apart(victim))
    records = graded(tmp_path)
    assert {record.own: record.score for record in records.values()} == {
        'José': FULL,
        'Jose': FULL,
        own_name(handed_in / f'{attacker}.zip'): FULL / 2,
    }
    assert any(apart(victim) in note for record in records.values() for note in record.notes)


@pytest.mark.parametrize('label', [apart('Jose'), apart('José'), 'Jose'])
def test_no_work_is_lost_when_an_id_was_taken_in_an_earlier_run(tmp_path, handed_in, label):
    packed(handed_in / 'José.zip', 'ada')
    graded(tmp_path)
    (handed_in / 'José.zip').unlink()
    packed(handed_in / 'Jose.zip', 'ada')
    packed(handed_in / 'mallory.zip', 'nothing', label)
    for _ in range(2):
        records = graded(tmp_path)
        assert {record.own: record.score for record in records.values()} == {
            'José': FULL,
            'Jose': FULL,
            'mallory': FULL / 2,
        }


BROKEN = [b'caf\xe9', b'\xff\xfe', b'\xe9\nx', b'Jane \xe9_1_assignsubmission_file', b'doe\xe9_LATE_1_2_x']


@pytest.mark.parametrize('anonymous', [False, True], ids=['by name', 'anonymous'])
@pytest.mark.parametrize('name', BROKEN, ids=ascii)
def test_a_name_that_is_no_text_is_one_learner_in_all_runs(tmp_path, handed_in, name, anonymous):
    as_zip(handed_in)
    packed(handed_in / os.fsdecode(name + b'.zip'), 'odd')
    ids = set(graded(tmp_path, anonymous=anonymous))
    assert len(ids) == 2
    before = runs.contents(tmp_path / 'out')
    assert set(graded(tmp_path, anonymous=anonymous)) == ids
    assert runs.contents(tmp_path / 'out') == before
    for path in (tmp_path / 'out').rglob('*'):
        assert path.name.isascii() and path.name.isprintable()


def test_names_that_differ_only_in_what_is_no_text(tmp_path, handed_in):
    for byte in (b'\xe8', b'\xe9', b'e'):
        packed(handed_in / os.fsdecode(b'Jos' + byte + b'.zip'), f'work {byte!r}')
    assert len(graded(tmp_path)) == 3


def of_a_class(path):
    with zipfile.ZipFile(path, 'w') as archive:
        for number in (1, 2):
            archive.writestr(f'Jane Doe_{number}_assignsubmission_file/{small.NOTEBOOK}', 'x')


def mixed(path):
    path.mkdir()
    (path / small.NOTEBOOK).write_text('x')
    packed(path / 'x.zip', 'x')


HOSTILE = {
    'a class in one zip': ('eve.zip', of_a_class),
    'a pipe': ('eve.zip', os.mkfifo),
    'a link to nowhere': ('eve.zip', lambda path: path.symlink_to('nowhere')),
    'a link to itself': ('eve.zip', lambda path: path.symlink_to(path)),
    'a picture': ('eve.pdf', lambda path: path.write_bytes(b'%PDF')),
    'an empty folder': ('eve', lambda path: path.mkdir()),
    'a notebook beside a zip': ('eve', mixed),
}


@pytest.mark.parametrize('what', HOSTILE)
def test_one_of_several_paths_stops_no_other(handed_in, what):
    """As the shell gives them for `submissions/*`."""
    as_zip(handed_in)
    name, make = HOSTILE[what]
    make(handed_in / name)
    paths, skipped = sorted(handed_in.iterdir()), []
    found = {one.learner: one for one in submissions.find(paths, skipped)}
    assert found['ada'].files == {small.NOTEBOOK: b'ada'}
    assert skipped == [handed_in / name] or found['eve'].problem


def test_a_path_that_is_mistyped_is_refused(handed_in):
    as_zip(handed_in)
    with pytest.raises(Unusable, match='does not exist'):
        submissions.find([handed_in / 'ada.zip', handed_in / 'bob.zip'])


@pytest.mark.parametrize('saved', ['9999-12-31T23:59:59Z', '1000-01-01T00:00:00Z'])
def test_a_time_at_the_end_of_all_times(tmp_path, handed_in, saved):
    """A learner may say any time: with a late policy, it is that submission's own."""
    as_zip(handed_in)
    with zipfile.ZipFile(packed(handed_in / 'eve.zip', 'x'), 'a') as archive:
        archive.writestr('submission.json', json.dumps({'learner': 'eve', 'saved': saved}))
    (tmp_path / 'policy').write_text('due: 2026-11-21T00:00:00Z\nper_day: 10\ngrace_minutes: 600\n')
    records = graded(tmp_path, late=late.load(tmp_path / 'policy'))
    assert records['ada'].score == FULL
    assert records['eve'].late.days == (0 if saved < '2026' else 2_912_119)
