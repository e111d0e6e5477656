"""The run: resumed, in any order, with what has changed; and what a grader's fault, a lock and a cluster do."""

import csv
import os
import re
import subprocess
import sys
import threading
from dataclasses import replace

import pytest
from typer.testing import CliRunner

from grading import anonymous, folder, grading_run, late, parallel, unit
from grading.adjustments import Adjustment, AdjustmentError
from grading.choice import ChoiceError
from grading.record import Record
from grading.submission import Submission
from grading.tests import runs
from grading.tests.test_grading_run import Heard
from helpers import paths
from helpers.cli import Refusal
from helpers.cli.app import make_app
from helpers.tests import small

SETTINGS = runs.SETTINGS


@pytest.fixture
def course(tmp_path):
    """Two exercises with a test file each, and one that both share."""
    for number in (1, 2):
        small.write_tests(tmp_path, small.HIDDEN, number, 'exercises')
    (tmp_path / 'checks' / 'chapter_90').mkdir(parents=True)
    (tmp_path / 'checks' / 'chapter_90' / 'shared.py').write_text('')
    return replace(runs.COURSE, visible=tmp_path / 'checks', hidden=tmp_path / 'exercises')


@pytest.fixture(autouse=True)
def done(monkeypatch):
    """No test runs: units take no time. Which were done, as (learner, exercise)."""
    done = []

    def perform(work, say=lambda test: None):
        done.extend((work.files[small.NOTEBOOK].decode(), identity) for identity in work.exercises)
        return runs.perform(work, say)

    monkeypatch.setattr(unit, 'perform', perform)
    return done


def run(course, output, *learners, works=None, jobs=2, **settings):
    """Grade; returns what was told, and the records by learner."""
    heard = Heard()
    records = grading_run.grade(
        works or runs.works(*learners), course, output, jobs, heard, replace(SETTINGS, **settings)
    )
    return heard, {record.learner: record for record in records}


@pytest.mark.one_of(3)
@pytest.mark.timeout(300)
def test_killed_at_any_moment(tmp_path):
    """Before and after each write: the next run grades what has no result, and all files are as undisturbed."""
    found = subprocess.run(
        [sys.executable, '-m', 'grading.tests.runs', str(tmp_path)],
        capture_output=True,
        text=True,
        env={**os.environ, 'PYTHONPATH': str(paths.ROOT)},
    )
    assert found.returncode == 0, found.stderr
    assert int(found.stdout) >= 4 * len(runs.LEARNERS) + 2  # a result and three reports each, gradebook and settings


def test_neither_order_nor_jobs_matter(course, tmp_path, monkeypatch):
    """Four at a time that end in reverse order, and one at a time, give the same bytes."""
    works = runs.works()
    run(course, tmp_path / 'one', works=works, jobs=1)
    ended = {learner: threading.Event() for learner in runs.LEARNERS}
    after = dict(zip(runs.LEARNERS, runs.LEARNERS[1:], strict=False))

    def perform(work, say):
        learner = work.files[small.NOTEBOOK].decode()
        assert learner not in after or ended[after[learner]].wait(30)
        ended[learner].set()
        return runs.perform(work, say)

    monkeypatch.setattr(unit, 'perform', perform)
    run(course, tmp_path / 'four', works=works[::-1], jobs=4)
    assert runs.contents(tmp_path / 'one') == runs.contents(tmp_path / 'four')


def test_only_what_has_changed(course, tmp_path, done):
    run(course, tmp_path / 'out', 'ada', 'bob')
    assert len(done) == 4
    shared = course.visible / 'chapter_90' / 'shared.py'
    for change, expected in (
        (lambda: None, []),
        (lambda: (course.hidden / '90_2' / 'hidden.py').write_text('# new'), [('ada', '90.2'), ('bob', '90.2')]),
        (lambda: shared.write_text('# new'), [('ada', '90.1'), ('ada', '90.2'), ('bob', '90.1'), ('bob', '90.2')]),
        (
            lambda: (tmp_path / 'out' / 'results' / 'bob.json').write_text('{"schema": 2'),
            [('bob', '90.1'), ('bob', '90.2')],
        ),
    ):
        done.clear()
        change()
        run(course, tmp_path / 'out', 'ada', 'bob')
        assert sorted(done) == expected
    done.clear()
    _, records = run(course, tmp_path / 'out', 'ada', 'bob', seed='other')
    assert len(done) == 4 and records['ada'].seed == 'other'


def test_the_seed_belongs_to_the_folder(course, tmp_path):
    """Drawn once, recorded, and other inputs for each learner."""
    _, records = run(course, tmp_path / 'a', 'ada', 'bob', seed='')
    _, again = run(course, tmp_path / 'a', 'ada', 'bob', seed='', regrade=True)
    assert again == records and records['ada'].seed == records['bob'].seed
    drawn = [record.exercises[0].message for record in records.values()]
    assert drawn[0] != drawn[1]
    assert records['ada'].seed in (tmp_path / 'a' / 'run.log').read_text()
    _, other = run(course, tmp_path / 'b', 'ada', seed='')
    assert other['ada'].seed != records['ada'].seed
    _, same = run(course, tmp_path / 'c', 'ada', seed=records['ada'].seed)
    assert same['ada'] == records['ada']


def test_a_later_submission(course, tmp_path, done):
    """It is graded, the marks that change are told, and the earlier one stays on record."""
    run(course, tmp_path / 'out', 'bob', 'eve')
    done.clear()
    works = runs.works('bob', 'eve')
    works[0].files, works[0].source = {small.NOTEBOOK: b'ada 2'}, works[0].source.with_name('bob (2).ipynb')
    works[0].handed_in = '2026-11-02T10:00:00Z'
    heard, records = run(course, tmp_path / 'out', works=works)
    assert {name for name, _ in done} == {'ada 2'} and heard.fresh == ['bob']
    assert heard.changes == {'bob': ['90.1: 5 → 10', '90.2: 2.5 → 5']}
    assert 'bob: marks changed (another submission): 90.1: 5 → 10' in (tmp_path / 'out' / 'run.log').read_text()
    (before,) = records['bob'].attempts
    assert (before.source, before.score, before.handed_in) == ('bob.ipynb', 7.5, '2026-11-01T10:00:00Z')
    assert records['bob'].source == 'bob (2).ipynb' and records['bob'].score == 15
    assert run(course, tmp_path / 'out', works=works)[1] == records


def test_learners_of_earlier_runs_stay(course, tmp_path):
    run(course, tmp_path / 'out', 'ada')
    _, records = run(course, tmp_path / 'out', 'bob')
    rows = list(csv.DictReader((tmp_path / 'out' / 'gradebook.csv').open()))
    assert list(records) == ['ada', 'bob'] == [row['learner'] for row in rows]


def test_only(course, tmp_path, done):
    output = tmp_path / 'out'
    _, records = run(course, output, only=('ada', 'bob/90.2'))
    assert sorted(done) == [('ada', '90.1'), ('ada', '90.2'), ('bob', '90.2')]
    assert (records['bob'].status, records['bob'].score) == ('incomplete', None)
    assert list(records) == ['ada', 'bob'] and 'bob,,2.5,,incomplete\n' in (output / 'gradebook.csv').read_text()
    done.clear()
    _, records = run(course, output, only=('*/90.1',))
    assert sorted(done) == [('bob', '90.1'), ('eve', '90.1'), ('fay', '90.1')]
    assert records['bob'].status == 'graded'
    done.clear()
    run(course, output, only=('eve',), regrade=True)
    assert sorted(done) == [('eve', '90.1'), ('eve', '90.2')]
    done.clear()
    assert run(course, output)[1] == run(course, tmp_path / 'at once')[1]
    assert ('fay', '90.2') in done[:1]
    for text in ('nobody', 'ada/90.3', '*/1'):
        with pytest.raises(ChoiceError, match=re.escape(text)):
            run(course, output, only=(text,))


def test_only_leaves_a_new_submission_of_another_for_later(course, tmp_path):
    _, before = run(course, tmp_path / 'out', 'ada', 'bob')
    works = runs.works('ada', 'bob')
    works[1].files = {small.NOTEBOOK: b'ada 2'}
    _, after = run(course, tmp_path / 'out', works=works, only=('ada',))
    assert after == before


def test_one_run_at_a_time(course, tmp_path, monkeypatch):
    refused = []

    def perform(work, say):
        with pytest.raises(folder.FolderError) as error:
            run(course, tmp_path / 'out')
        refused.append(str(error.value))
        return runs.perform(work, say)

    monkeypatch.setattr(unit, 'perform', perform)
    run(course, tmp_path / 'out', 'ada')
    assert f'another grade is writing to {tmp_path / "out"} (process {os.getpid()})' in refused[0]
    run(course, tmp_path / 'out', 'ada')


def test_a_folder_that_cannot_be_used(course, tmp_path):
    (tmp_path / 'file').write_text('x')
    with pytest.raises(folder.FolderError, match='cannot be written'):
        run(course, tmp_path / 'file')
    run(course, tmp_path / 'out', 'ada')
    (tmp_path / 'out' / 'run.json').write_text('{')
    with pytest.raises(folder.FolderError, match='damaged'):
        run(course, tmp_path / 'out', 'ada')


def test_a_log_that_cannot_be_written_ends_the_run(tmp_path):
    """A disk is full: the results could not be kept either."""
    (tmp_path / 'run.log').symlink_to('/dev/full')
    with pytest.raises(OSError, match='No space left'), folder.Folder(tmp_path).open() as log:
        log.info('one submission to grade')


@pytest.mark.parametrize('faults', [1, 2])
def test_what_fails_is_tried_once_more(course, tmp_path, monkeypatch, faults):
    calls = []

    def perform(work, say):
        if work.files[small.NOTEBOOK] == b'bob':
            calls.append(work)
            if len(calls) <= faults:
                raise MemoryError('no room')
        return runs.perform(work, say)

    monkeypatch.setattr(unit, 'perform', perform)
    _, records = run(course, tmp_path / 'out')
    assert len(calls) == 2 and records['ada'].score == 15
    if faults == 1:
        assert (records['bob'].status, records['bob'].score) == ('graded', 7.5)
        return
    assert (records['bob'].status, records['bob'].score) == ('grader_error', None)
    assert 'bob,,,,grader_error\n' in (tmp_path / 'out' / 'gradebook.csv').read_text()
    assert 'MemoryError: no room' in (tmp_path / 'out' / 'run.log').read_text()
    heard, records = run(course, tmp_path / 'out')
    assert heard.fresh == ['bob'] and records['bob'].score == 7.5
    assert 'after a fault of the grader' in (tmp_path / 'out' / 'run.log').read_text()


def test_another_course_stops_the_run(course, tmp_path, monkeypatch):
    """A machine with other tests is no learner's fault: nothing is graded there."""
    monkeypatch.undo()
    work = unit.Unit({}, '', {}, course.packed(), 'another', ('90.1',), 's')
    with pytest.raises(unit.Mismatch, match='is not the one that this run began with'):
        unit.perform(work)
    assert unit.perform(replace(work, digest=course.digest)).exercises[0].verdict == 'not_attempted'
    here = grading_run.Course.here().packed()
    assert not here.hidden.is_absolute() and here.unpacked() == grading_run.Course.here()


def test_lateness_and_adjustments(course, tmp_path, done):
    """They change marks, not results: nothing is graded again."""
    run(course, tmp_path / 'out', 'ada', 'bob')
    done.clear()
    policy = late.Policy(late.datetime.fromisoformat('2026-10-31T09:00:00+00:00'), per_day=10, cap=50)
    by_hand = (Adjustment('bob', '90.1', 9.0, None, 'right on paper'), Adjustment('bob', '90.2', None, -50.0, 'copied'))
    heard, records = run(course, tmp_path / 'out', 'ada', 'bob', late=policy, adjustments=by_hand)
    assert not done
    assert heard.changes == {'ada': ['90.1: 10 → 8', '90.2: 5 → 4'], 'bob': ['90.1: 5 → 9', '90.2: 2.5 → 0']}
    assert (records['ada'].late.days, records['ada'].late.percent, records['ada'].score) == (2, 20, 12)
    assert (records['bob'].marks, records['bob'].earned) == ({'90.1': 9, '90.2': 0}, 7.5)
    assert 'bob,9,0,9,' in (tmp_path / 'out' / 'gradebook.csv').read_text()
    assert Record.load(tmp_path / 'out' / 'results' / 'bob.json') == records['bob']
    # Those who are not given this time, too.
    assert run(course, tmp_path / 'out', 'ada', late=policy, adjustments=by_hand)[1] == records
    _, records = run(course, tmp_path / 'out', 'ada', 'bob')
    assert records['bob'].score == 7.5 and not done
    with pytest.raises(AdjustmentError, match='nobody'):
        run(course, tmp_path / 'out', adjustments=(Adjustment('nobody', '90.1', 1.0, None, 'x'),))
    with pytest.raises(late.PolicyError, match='nobody'):
        run(course, tmp_path / 'out', late=replace(policy, extensions={'nobody': policy.due}))


def test_a_mark_by_hand_closes_what_a_fault_left_open(course, tmp_path, monkeypatch):
    monkeypatch.setattr(unit, 'perform', lambda work, say: unit.fault(work, 'broken'))
    by_hand = tuple(Adjustment('ada', identity, 3.0, None, 'by eye') for identity in ('90.1', '90.2'))
    _, records = run(course, tmp_path / 'out', 'ada', adjustments=by_hand)
    assert (records['ada'].status, records['ada'].score) == ('graded', 6)
    assert run(course, tmp_path / 'out', 'ada')[1]['ada'].score is None


def test_names_of_notebooks_tell_no_learner(course):
    """A notebook that is handed in alone is called as its learner, and messages say how a file is called."""
    files = {small.NOTEBOOK: b'1', 'jane doe.ipynb': b'2', '90_jane.ipynb': b'3', 'my_ws/src/patrol/jane.py': b'4'}
    unusable = {
        'jane.ipynb': 'There are two notebooks called jane.ipynb: hand in one.',
        small.NOTEBOOK: f'{small.NOTEBOOK} is larger than 10 MB',
        'jane.ipynb.ipynb': 'jane.ipynb.ipynb is larger than 10 MB, as jane.ipynb is',
    }
    work = unit.Unit(files, '', unusable, course, course.digest, (), 's')
    found = anonymous.without_names(work)
    assert list(found.files.values()) == list(files.values())
    assert 'jane' not in f'{found.unusable}' and small.NOTEBOOK in found.files
    assert found.unusable[small.NOTEBOOK] == unusable[small.NOTEBOOK]
    assert [name[:3] for name in found.files] == ['90_', 'not', '90_', 'my_']
    assert len(found.files) == 4 and len(found.unusable) == 3
    assert 'my_ws/src/patrol/jane.py' in found.files  # its path is part of the answer


def test_anonymous(course, tmp_path):
    """No id and no file's name in the results; the map is beside them, for the instructor only."""
    output = tmp_path / 'out'
    by_hand = (Adjustment('bob', '90.1', 9.0, None, 'paper'),)
    works = [
        Submission(
            name,
            tmp_path / f'submission-{name}.zip',
            {small.NOTEBOOK: number.encode(), f'{name}.ipynb': b'{'},
            unusable={f'{name} 2.ipynb': f'{name} 2.ipynb is larger than 10 MB'},
            handed_in='2026-11-01T10:00:00Z',
            notes=[f'adalovelace and "bob": {name}'],
        )
        for number, name in enumerate_names()
    ]
    _, records = run(course, output, works=works, anonymous=True, adjustments=by_hand)
    for path in [*output.rglob('*'), *(output / 'feedback').iterdir()]:
        assert 'adalovelace' not in path.name
        assert not path.is_file() or b'adalovelace' not in path.read_bytes() and b'"bob"' not in path.read_bytes()
    with (tmp_path / 'out-private' / 'learners.csv').open() as file:
        names = {row['learner']: row['pseudonym'] for row in csv.DictReader(file)}
    assert sorted(names) == ['adalovelace', 'bob'] and set(names.values()) == set(records)
    assert records[names['bob']].marks['90.1'] == 9
    assert (tmp_path / 'out-private').stat().st_mode & 0o77 == 0
    assert all(path.stat().st_mode & 0o77 == 0 for path in (tmp_path / 'out-private').iterdir())
    heard, again = run(course, output, works=works, anonymous=True, adjustments=by_hand, only=('bob',))
    assert again == records and not heard.fresh
    with pytest.raises(folder.FolderError, match='made with --anonymous'):
        run(course, output, works=works)
    (tmp_path / 'out-private' / 'salt').unlink()
    assert not {
        record.learner for record in run(course, tmp_path / 'new', works=works, anonymous=True)[1].values()
    } & set(records), 'another salt, other pseudonyms'


def enumerate_names():
    return ('1', 'adalovelace'), ('2', 'bob')


# The command


def invoke(*arguments):
    return CliRunner().invoke(make_app(), ['grade', *map(str, arguments)])


@pytest.fixture
def command(course, tmp_path, monkeypatch):
    """`./course grade` for the small course; returns a function."""
    monkeypatch.setattr(grading_run.Course, 'here', lambda: course)
    (tmp_path / 'works').mkdir()
    for learner in ('ada', 'bob'):
        (tmp_path / 'works' / f'{learner}.ipynb').write_bytes(learner.encode())
    return lambda *arguments: invoke(tmp_path / 'works', '-o', tmp_path / 'out', '--sandbox', 'none', *arguments)


def _anything(work):
    return unit.Outcome([replace(one, verdict='passed', score=one.points) for one in unit.fault(work, '').exercises])


def test_exit_status(command, tmp_path, monkeypatch):
    monkeypatch.setattr(unit, 'perform', lambda work, say: _anything(work))
    found = command()
    assert found.exit_code == 0 and 'ada: 15 of 15, graded' in found.output, found.output
    (tmp_path / 'fix.csv').write_text('learner,exercise,points,delta,reason\nbob,90.1,4,,x\n')
    found = command('--adjustments', tmp_path / 'fix.csv')
    assert found.exit_code == 0 and '90.1: 10 → 4' in found.output and 'ada:' not in found.output
    monkeypatch.setattr(unit, 'perform', lambda work, say: unit.fault(work, 'broken'))
    found = command('--regrade', '--only', 'bob')
    assert found.exit_code == 1 and 'left marks open for bob (90.1, 90.2)' in found.output


def test_an_assignment_of_one_chapter(command, course, tmp_path, monkeypatch):
    other = replace(course.exercises[0], id='91.1', chapter=91)
    monkeypatch.setattr(grading_run.Course, 'here', lambda: replace(course, exercises=(*course.exercises, other)))
    monkeypatch.setattr(unit, 'perform', lambda work, say: _anything(work))
    assert 'ada: 15 of 15, graded' in command('--chapter', 90).output
    assert '0 of 2 submissions' in command().output  # the folder keeps the choice
    with open(tmp_path / 'out' / 'gradebook.csv', newline='') as file:
        assert next(csv.reader(file)) == ['learner', '90.1', '90.2', 'total', 'status']
    assert 'holds results of chapter 90' in str(command('--chapter', 91).exception)


@pytest.mark.parametrize(
    ('arguments', 'text'),
    [
        (('--only', 'nobody'), 'no submission of'),
        (('--chapter', '7'), 'no exercise in chapter 7; there are chapters 90'),
        (('--late', 'none.yaml'), 'none.yaml cannot be read'),
        (('--adjustments', 'none.csv'), 'none.csv cannot be read'),
        (('--cluster', 'tcp://127.0.0.1:9'), 'no Dask scheduler answers'),
    ],
)
def test_wrong_use(command, monkeypatch, arguments, text):
    monkeypatch.setattr(parallel, 'CONNECT', 0.5)
    found = command(*arguments)
    assert isinstance(found.exception, Refusal) and text in str(found.exception), found.output
