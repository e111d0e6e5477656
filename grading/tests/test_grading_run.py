"""Grading into a folder: marks, reports, resuming, and what a gradebook must withstand."""

import csv
import io
import json
import os
import re
import subprocess
import sys
import zipfile
from datetime import datetime, timezone
from pathlib import Path
from xml.etree import ElementTree

import psutil
import pytest

from environment.setup import whole_file
from grading import gradebook, grading_run, reports, submissions
from grading.adjustments import Adjustment
from grading.late import Late, Policy
from grading.record import Attempt, Record
from grading.tests.test_reports import validate
from helpers import paths
from helpers.runner import results
from helpers.runner.results import ExerciseResult, TestResult
from helpers.tests import small

HURT = '<script>alert(1)</script>'
WORKS = {
    'ada': small.solved(),
    'bob': small.solved(small.TALKER.replace('+= 1', '+= 2')),
    'eve': small.solved(f'def Talker(): raise ValueError("{HURT}")\n'),
    'fay': small.solved(small.STUB),
    'gus': b'{',
    'hal': small.notebook('x = 1'),
}


class Heard(grading_run.RunListener):
    """What a run tells."""

    def __init__(self):
        self.fresh, self.tests, self.changes = [], [], {}

    def tested(self, learner, test):
        self.tests.append((learner, test))

    def finished(self, record, fresh, changes):
        if fresh:
            self.fresh.append(record.learner)
        if changes:
            self.changes[record.learner] = changes


def contents(folder):
    """The bytes of all files but the log, by path."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob('*')
        if path.is_file() and path.name not in ('run.log', '.lock')
    }


@pytest.fixture
def course(tmp_path):
    """A course with one exercise, one visible and one hidden test."""
    small.write_tests(tmp_path, small.VISIBLE)
    small.write_tests(tmp_path, small.HIDDEN, kind='exercises')
    return grading_run.Course((small.exercise(),), tmp_path / 'checks', tmp_path / 'exercises', 'none')


@pytest.fixture
def works(tmp_path):
    """Six submissions."""
    folder = tmp_path / 'works'
    folder.mkdir()
    for learner, data in WORKS.items():
        (folder / f'{learner}.ipynb').write_bytes(data)
    return submissions.find(folder.iterdir())


def test_grade(course, works, tmp_path):
    output = tmp_path / 'out'
    heard = Heard()
    records = grading_run.grade(works, course, output, 2, heard)
    rows = list(csv.DictReader(io.StringIO((output / 'gradebook.csv').read_text())))
    assert rows == [
        {'learner': 'ada', '90.1': '10', 'total': '10', 'status': 'graded'},
        {'learner': 'bob', '90.1': '2.5', 'total': '2.5', 'status': 'graded'},
        {'learner': 'eve', '90.1': '0', 'total': '0', 'status': 'graded'},
        {'learner': 'fay', '90.1': '0', 'total': '0', 'status': 'graded'},
        {'learner': 'gus', '90.1': '0', 'total': '0', 'status': 'invalid'},
        {'learner': 'hal', '90.1': '0', 'total': '0', 'status': 'graded'},
    ]
    assert sorted(heard.fresh) == list(WORKS) and not heard.changes
    assert sorted({learner for learner, _ in heard.tests}) == ['ada', 'bob', 'eve']
    assert all(record.sandbox == 'none' for record in records)
    names = sorted(path.relative_to(output).as_posix() for path in output.rglob('*') if path.is_file())
    assert names == sorted(
        [
            '.lock',
            'gradebook.csv',
            'run.json',
            'run.log',
            'summary.html',
            'summary.json',
            *(
                f'{folder}/{learner}{suffix}'
                for learner in WORKS
                for folder, suffix in (
                    ('results', '.json'),
                    ('feedback', '.html'),
                    ('gradescope', '.json'),
                    ('junit', '.xml'),
                )
            ),
        ]
    )
    for learner in WORKS:
        validate('result', (output / 'results' / f'{learner}.json').read_text())
        validate('gradescope', (output / 'gradescope' / f'{learner}.json').read_text())
    summary = validate('summary', (output / 'summary.json').read_text())
    assert summary['learners'] == len(WORKS) and summary['total']['known'] == len(WORKS)
    _feedback(output)
    _gradescope(output)
    _junit(output)
    _again(course, works, output)


def _feedback(output):
    pages = {learner: (output / 'feedback' / f'{learner}.html').read_text() for learner in WORKS}
    assert '10 of 10 points' in pages['ada']
    assert 'The texts are [&#39;0&#39;, &#39;2&#39;' in pages['bob'] and 'Look at the counter.' in pages['bob']
    assert 'not valid JSON' in pages['gus']
    assert '&lt;script&gt;' in pages['eve']
    for page in pages.values():
        assert '<script' not in page and 'javascript:' not in page and not re.search(r'<[^>]* on\w+=', page)
        assert 'http:' not in page and 'https:' not in page
        assert 'heard.data ==' not in page and '/grading/' not in page and 'Traceback' not in page


def _gradescope(output):
    for learner, score in (('ada', [2.5, 7.5]), ('bob', [2.5, 0]), ('fay', [0])):
        data = json.loads((output / 'gradescope' / f'{learner}.json').read_text())
        assert data['score'] == sum(score) and [test['score'] for test in data['tests']] == score
        assert sum(test['max_score'] for test in data['tests']) == 10
        assert data['extra_data']['sandbox'] == 'none'


def _junit(output):
    suite = ElementTree.parse(output / 'junit' / 'bob.xml').getroot()[0]
    assert (suite.get('tests'), suite.get('failures'), suite.get('errors')) == ('2', '1', '0')
    assert ElementTree.parse(output / 'junit' / 'fay.xml').getroot()[0].get('skipped') == '1'


def _again(course, works, output):
    """Run again: nothing is graded anew, and nothing changes but the log."""
    before = contents(output)
    heard = Heard()
    grading_run.grade(works, course, output, 2, heard)
    assert not heard.fresh and contents(output) == before


SCRIPT = """
import sys
from pathlib import Path
from grading import grading_run, submissions
from helpers.tests import small

class Told(grading_run.RunListener):
    def tested(self, learner, test):
        print('tested', flush=True)

    def finished(self, record, fresh, changes):
        print('fresh' if fresh else 'kept', flush=True)

folder = Path(sys.argv[1])
course = grading_run.Course((small.exercise(),), folder / 'checks', folder / 'exercises', 'none')
works = [work for work in submissions.find([folder / 'works']) if work.learner in ('ada', 'bob', 'fay')]
grading_run.grade(works, course, folder / 'out', 2, Told(), grading_run.Settings(seed='s'))
"""


@pytest.mark.one_of(3)
@pytest.mark.timeout(300)
def test_killed_while_tests_run(course, works, tmp_path):
    """Killed in the midst of tests, and after the first result: tests end with their grader, and nothing is lost."""

    def start():
        return subprocess.Popen(
            [sys.executable, '-c', SCRIPT, str(tmp_path)],
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, 'PYTHONPATH': str(paths.ROOT)},
        )

    found = tmp_path / 'out' / 'results'
    for moment in ('tested', 'fresh'):
        with start() as process:
            assert any(line.strip() == moment for line in process.stdout)
            children = psutil.Process(process.pid).children(recursive=True)
            process.kill()
        assert not psutil.wait_procs(children, timeout=20)[1], 'the tests outlive their grader'
    kept = {path.name: path.stat().st_mtime_ns for path in found.glob('*.json')}
    assert kept
    with start() as process:
        said = process.stdout.read().split()
    assert process.returncode == 0 and said.count('kept') == len(kept) and said.count('fresh') == 3 - len(kept)
    assert kept.items() <= {path.name: path.stat().st_mtime_ns for path in found.glob('*.json')}.items()
    mine = [work for work in works if work.learner in ('ada', 'bob', 'fay')]
    expected = grading_run.grade(mine, course, tmp_path / 'undisturbed', 2, settings=grading_run.Settings(seed='s'))
    assert [Record.load(found / f'{record.learner}.json') for record in expected] == expected
    books = [(tmp_path / folder / 'gradebook.csv').read_bytes() for folder in ('out', 'undisturbed')]
    assert books[0] == books[1]


def test_a_fault_of_the_graders_is_no_zero(course, tmp_path):
    (course.hidden / '90_1' / 'hidden.py').write_text('nonsense(')
    (tmp_path / 'ada.ipynb').write_bytes(WORKS['ada'])
    work = submissions.find([tmp_path / 'ada.ipynb'])
    (record,) = grading_run.grade(work, course, tmp_path / 'out')
    assert (record.status, record.score) == ('grader_error', None)
    assert (tmp_path / 'out' / 'gradebook.csv').read_text() == 'learner,90.1,total,status\nada,,,grader_error\n'
    page = (tmp_path / 'out' / 'feedback' / 'ada.html').read_text()
    assert 'fault on our side' in page and 'SyntaxError' not in page and 'nonsense' not in page
    assert 'SyntaxError' in (tmp_path / 'out' / 'run.log').read_text()
    assert 'score' not in json.loads((tmp_path / 'out' / 'gradescope' / 'ada.json').read_text())
    # Repaired, it is graded in the next run.
    small.write_tests(tmp_path, small.HIDDEN, kind='exercises')
    (record,) = grading_run.grade(work, course, tmp_path / 'out')
    assert (record.status, record.score) == ('graded', 10)


def record(**changes):
    test = TestResult(
        'exercises/90_1/hidden::test_it', '90.1', True, 1, 'failed', f'{HURT}\n\n{HURT}', HURT, HURT, HURT
    )
    exercise = ExerciseResult('90.1', HURT, 10, 'failed', 0.0, HURT, [test])
    return Record(
        **{'learner': 'ada', 'source': 'x.zip', 'key': 'k', 'sandbox': 'none', 'exercises': [exercise], **changes}
    )


@pytest.mark.parametrize('learner', ['=HYPERLINK("x")', '+1', '-1', '@x', '\t=1'])
def test_no_formula_in_the_gradebook(learner):
    rows = list(csv.reader(io.StringIO(gradebook.dumps([record(learner=learner)], [small.exercise()]), newline='')))
    assert rows[1][0] == f"'{learner}"


def test_one_row_per_learner():
    assert len(gradebook.dumps([record(learner='a\rb\nc')], [small.exercise()]).splitlines()) == 2


def test_a_comma_and_a_quote_in_the_gradebook():
    rows = list(csv.reader(io.StringIO(gradebook.dumps([record(learner='a,"b"')], [small.exercise()]))))
    assert rows[1] == ['a,"b"', '0', '0', 'graded']


@pytest.mark.parametrize(('folder', 'suffix', 'make'), reports.KINDS, ids=[kind[0] for kind in reports.KINDS])
def test_every_report_escapes(folder, suffix, make):
    text = make(record(learner=HURT))
    if folder != 'gradescope':  # JSON of plain text: Gradescope escapes it
        assert '<script' not in text
    assert 'alert(1)' in text


def test_record_round_trip(tmp_path):
    whole_file.write(tmp_path / 'ada.json', record().dumps())
    assert Record.load(tmp_path / 'ada.json') == record()
    full = record(
        seed='s',
        keys={'90.1': 'k'},
        ungraded=['90.2'],
        notes=['n'],
        late=Late('2026-11-19T10:00:00Z', '2026-11-20T11:00:00Z', 2, 20.0),
        attempts=[Attempt('a.zip', 'd' * 64, '2026-11-18T10:00:00Z', 1.0)],
        adjustments=[Adjustment('ada', '90.1', None, 1.0, 'r')],
    )
    whole_file.write(tmp_path / 'ada.json', full.dumps())
    assert Record.load(tmp_path / 'ada.json') == full
    assert sorted(path.name for path in tmp_path.iterdir()) == ['ada.json']
    assert Record.load(tmp_path / 'none.json') is None


def _zip(folder: Path, name: str, learner: str, data: bytes, **label) -> Path:
    folder.mkdir(exist_ok=True)
    with zipfile.ZipFile(folder / name, 'w') as archive:
        archive.writestr(small.NOTEBOOK, data)
        archive.writestr('submission.json', json.dumps({'learner': learner, **label}))
    return folder / name


@pytest.mark.one_of(3)
@pytest.mark.parametrize('anonymous', [False, True])
@pytest.mark.parametrize('name', ['eve.zip', 'submission-eve.zip', 'x (1).zip'])
def test_an_id_in_a_zip_replaces_nobodys_record(course, tmp_path, name, anonymous):
    """Not even in a later run, in which the other one's work is not there. Who had the id keeps it."""
    output, settings = tmp_path / 'out', grading_run.Settings(anonymous=anonymous)
    mine = [_zip(tmp_path / 'a', 'submission-ada.zip', 'ada', WORKS['ada'])]
    grading_run.grade(submissions.find(mine), course, output, settings=settings)
    hers = [_zip(tmp_path / 'b', name, 'ada', WORKS['eve'], saved='2030-01-01T00:00:00Z')]
    records = grading_run.grade(submissions.find(hers), course, output, settings=settings)
    assert sorted(record.score for record in records) == [0, 10]
    assert ('there is a note' if anonymous else 'on record under another name') in (output / 'run.log').read_text()
    later = [_zip(tmp_path / 'c', 'ada.zip', 'ada', WORKS['bob'], saved='2030-01-01T00:00:00Z')]
    records = grading_run.grade(submissions.find(later), course, output, settings=settings)
    assert sorted(record.score for record in records) == [0, 2.5]


def test_names_that_give_the_same_id_in_two_runs(course, tmp_path):
    for name, work in (('José', 'ada'), ('Jose', 'eve'), ('José', 'bob')):
        for old in tmp_path.glob('*.ipynb'):
            old.unlink()
        (tmp_path / f'{name}.ipynb').write_bytes(WORKS[work])
        records = grading_run.grade(submissions.find([tmp_path / f'{name}.ipynb']), course, tmp_path / 'out')
    assert {record.own: record.score for record in records} == {'José': 2.5, 'Jose': 0}
    (tmp_path / 'Jose.ipynb').write_bytes(WORKS['ada'])
    records = grading_run.grade(submissions.find(sorted(tmp_path.glob('*.ipynb'))), course, tmp_path / 'out')
    assert {record.own: record.score for record in records} == {'José': 2.5, 'Jose': 10}


@pytest.mark.one_of(3)
@pytest.mark.parametrize(
    'harm',
    [
        lambda data: {**data, 'handed_in': '2026-13-45T00:00:00Z'},
        lambda data: {**data, 'handed_in': 5},
        lambda data: {**data, 'learner': 'bob'},
        lambda data: {**data, 'exercises': [{}]},
        lambda data: [data],
        lambda data: {**data, 'exercises': [{**data['exercises'][0], 'score': 'ten'}]},
        lambda data: {**data, 'log': [[]]},
        lambda data: {**data, 'keys': {'90.1': []}},
        lambda data: {**data, 'notes': 7},
        lambda data: '[' * 99_999,
    ],
)
def test_a_record_that_cannot_be_read_harms_nobody(course, tmp_path, harm):
    """Its submission is graded again, or left out, and all others are as they were."""
    policy = Policy(datetime(2030, 1, 1, tzinfo=timezone.utc))
    for learner in ('ada', 'bob'):
        _work(tmp_path, f'{learner}.ipynb').write_bytes(WORKS[learner])
    settings = grading_run.Settings(late=policy)
    grading_run.grade(submissions.find(tmp_path.glob('*.ipynb')), course, tmp_path / 'out', settings=settings)
    path = tmp_path / 'out' / 'results' / 'ada.json'
    harmed = harm(json.loads(path.read_text()))
    path.write_text(harmed if isinstance(harmed, str) else json.dumps(harmed))
    records = grading_run.grade(submissions.find([tmp_path / 'bob.ipynb']), course, tmp_path / 'out', settings=settings)
    assert [(record.learner, record.score) for record in records] == [('bob', 2.5)]
    records = grading_run.grade(submissions.find(tmp_path.glob('*.ipynb')), course, tmp_path / 'out', settings=settings)
    assert [(record.learner, record.score) for record in records] == [('ada', 10), ('bob', 2.5)]


def test_totals():
    two = [results.ExerciseResult('1.1', 'a', 10, 'passed', 10.0), results.ExerciseResult('1.2', 'b', 5, 'failed', 2.5)]
    assert (record(exercises=two).score, record(exercises=two).points) == (12.5, 15)
    two[1].score = None
    assert record(exercises=two).score is None


def test_learners_names_are_paths_only_inside(course, tmp_path):
    for work in submissions.find([_work(tmp_path, '..ipynb'), _work(tmp_path, 'a b.ipynb')]):
        assert (tmp_path / 'out' / 'results' / f'{work.learner}.json').parent == tmp_path / 'out' / 'results'


def _work(folder: Path, name: str) -> Path:
    (folder / name).write_bytes(WORKS['hal'])
    return folder / name
