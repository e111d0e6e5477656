"""The autograder for Gradescope, against the documented contract: its zip, its two scripts, what they write."""

import json
import os
import subprocess
import zipfile
from pathlib import Path

import pytest

from grading import learners_edition, similarity, submission
from grading.gradescope import bundle, harness
from grading.reports import gradescope
from grading.tests.test_reports import validate
from grading.tests.test_similarity import answers
from helpers import paths
from helpers.exercises import manifest
from helpers.tests import small

EXERCISES = list(manifest.load().values())
CHAPTER = '03_nodes_and_topics.ipynb'
METADATA = {
    'id': 1,
    'created_at': '2026-11-20T14:22:32.365935-07:00',
    'previous_submissions': [],
    'assignment': {'due_date': '2026-11-30T23:00:00.000000-07:00', 'late_due_date': None, 'total_points': '100.0'},
    'users': [{'email': 'ada@example.org', 'id': 12, 'name': 'Ada'}, {'email': 'b', 'id': 7, 'name': 'B'}],
}


@pytest.fixture(scope='module')
def root(tmp_path_factory):
    """Gradescope's folders: the zip unpacked with its permissions, and the environment of this checkout."""
    root = tmp_path_factory.mktemp('autograder')
    (root / 'results').mkdir()  # Gradescope has made it
    archive = root.parent / 'autograder.zip'
    bundle.bundle(archive, 'none')
    with zipfile.ZipFile(archive) as zipped:
        for member in zipped.infolist():
            path = Path(zipped.extract(member, root / 'source'))
            path.chmod(member.external_attr >> 16 & 0o777)
    (root / 'source' / 'course' / '.venv').symlink_to(paths.ROOT / '.venv')
    (root / 'run_autograder').write_bytes((root / 'source' / 'run_autograder').read_bytes())
    (root / 'run_autograder').chmod(0o755)
    (root / 'submission_metadata.json').write_text(json.dumps(METADATA))
    return root


def run(root: Path, files: dict[str, bytes]) -> subprocess.CompletedProcess:
    """Run the real script, as Gradescope does, on these files."""
    for old in (path for path in sorted((root / 'submission').rglob('*'), reverse=True)):
        old.rmdir() if old.is_dir() else old.unlink()
    for name, content in files.items():
        path = root / 'submission' / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    environment = {name: value for name, value in os.environ.items() if name != 'PYTHONPATH'}
    return subprocess.run(
        [root / 'run_autograder'],
        cwd=root,
        env={**environment, 'AUTOGRADER_ROOT': str(root)},
        capture_output=True,
        text=True,
        timeout=110,
    )


def answered(exercise: str) -> bytes:
    """The notebook as learners get it, with one exercise solved."""
    notebook = json.loads((paths.NOTEBOOKS / CHAPTER).read_text())
    (cell,) = (cell for cell in notebook['cells'] if cell.get('id') == f'ex-{exercise.replace(".", "-")}')
    cell['source'] = answers()[exercise]['solution']
    return json.dumps(notebook).encode()


@pytest.mark.one_of(4)
def test_a_submission(root):
    done = run(root, {CHAPTER: answered('3.1'), 'submission.json': b'{"format": 1, "learner": "ada"}'})
    assert done.returncode == 0, done.stdout + done.stderr
    data = validate('gradescope', (root / 'results' / 'results.json').read_text())
    points = {exercise.id: exercise.points for exercise in EXERCISES}
    assert data['score'] == points['3.1'] and data['extra_data']['sandbox'] == 'none'
    first = [entry for entry in data['tests'] if entry['number'] == '3.1']
    assert [entry['visibility'] for entry in first] == ['visible', 'after_published']
    assert {entry['status'] for entry in first} == {'passed'} and sum(e['score'] for e in first) == points['3.1']
    assert sum(entry['max_score'] for entry in data['tests']) == sum(points.values())
    # What is used is told loudly to the instructor, who reads the output, and in the results.
    assert 'WARNING' in done.stdout and '--sandbox none' in done.stdout and 'Sandbox: none.' in data['output']
    assert 'Ada' not in json.dumps(data) + done.stdout and 'example.org' not in json.dumps(data) + done.stdout


@pytest.mark.one_of(4)
def test_what_cannot_be_used_is_told_to_the_learner(root):
    done = run(root, {'notebooks/03_nodes_and_topics.ipynb': b'{', '.git/x.ipynb': b'{}'})
    assert done.returncode == 0, done.stdout + done.stderr
    data = validate('gradescope', (root / 'results' / 'results.json').read_text())
    assert data['score'] == 0 and data['extra_data']['status'] == 'invalid'
    assert any('not valid JSON' in entry['output'] for entry in data['tests'])


@pytest.mark.one_of(4)
def test_a_fault_is_no_zero(root):
    """A grader that does not work leaves no result: Gradescope then reports a fault of the autograder."""
    (root / 'results' / 'results.json').write_text('{"score": 100, "tests": []}')
    config = root / 'source' / harness.CONFIG
    known = config.read_text()
    config.write_text(known.replace('"chapters": []', '"chapters": [99]'))
    assert 'no exercise in chapter 99' in run(root, {CHAPTER: answered('3.1')}).stderr  # the choice reaches the grader
    config.write_text(known.replace('"none"', '"no such sandbox"'))
    done = run(root, {CHAPTER: answered('3.1')})
    config.write_text(known)
    assert done.returncode == 1 and not (root / 'results' / 'results.json').exists()
    assert 'without a result' in done.stdout and 'no such sandbox' in done.stdout + done.stderr


def test_set_up(root, tmp_path):
    """The packages that the course needs, then its environment; what fails ends it."""
    calls = tmp_path / 'calls'
    tools = tmp_path / 'bin'
    tools.mkdir()
    course = tmp_path / 'autograder' / 'source' / 'course'
    course.mkdir(parents=True)
    for path, words in ((tools / 'apt-get', 'apt-get'), (course / 'course', 'course')):
        path.write_text(f'#!/bin/sh\necho {words} "$@" >> {calls}\n[ "$FAIL" != {words} ]\n')
        path.chmod(0o755)
    environment = {'PATH': f'{tools}:{os.environ["PATH"]}', 'AUTOGRADER_ROOT': str(tmp_path / 'autograder')}
    assert subprocess.run([root / 'source' / 'setup.sh'], env=environment).returncode == 0
    lines = calls.read_text().splitlines()
    assert lines[0].startswith('apt-get update') and lines[-1] == 'course setup'
    assert {'g++', 'python3', 'python3-dev', 'python3-venv', 'bubblewrap'} <= set(lines[1].split())
    for tool in ('apt-get', 'course'):
        assert subprocess.run([root / 'source' / 'setup.sh'], env={**environment, 'FAIL': tool}).returncode != 0


def test_scripts_know_gradescopes_folder(root):
    for script in bundle.SCRIPTS:
        text = (root / 'source' / script).read_text()
        assert text.startswith('#!/usr/bin/env bash\n') and 'root=${AUTOGRADER_ROOT:-/autograder}' in text
        assert os.access(root / 'source' / script, os.X_OK)


def test_the_zip_has_the_tests_but_no_answer(root):
    names = {
        path.relative_to(root / 'source').as_posix()
        for path in (root / 'source').rglob('*')
        if path.is_file() and '.venv' not in path.parts
    }
    assert {'setup.sh', 'run_autograder', 'autograder.json', 'course/course'} <= names
    assert 'course/grading/exercises/3_1/hidden.py' in names and f'course/notebooks/{CHAPTER}' in names
    assert not [
        name
        for name in names
        if name.startswith('course/solutions/')
        or name.endswith(('/mutants.py', '/alternatives.py'))
        or '/tests/' in name
        and not name.startswith('course/environment/ros2_ws/')
    ]
    bodies = ['\n'.join(answer.splitlines()[1:]) for found in answers().values() for answer in found.values()]
    texts = [(root / 'source' / name).read_text(errors='replace') for name in names]
    texts += [
        cell
        for text, name in zip(texts, names, strict=True)
        if name.endswith('.ipynb')
        for cell in similarity.cells_of({name: text.encode()}, EXERCISES).values()
    ]
    assert bodies and not [body for body in bodies for text in texts if body in text]


def test_the_same_course_gives_the_same_zip(root, tmp_path):
    zips = [tmp_path / name for name in ('1.zip', '2.zip')]
    for path in zips:
        bundle.bundle(path, 'none', root=root / 'source' / 'course')
    assert zips[0].read_bytes() == zips[1].read_bytes()
    with zipfile.ZipFile(zips[0]) as archive:
        assert 'course/grading/exercises/3_1/hidden.py' in archive.namelist()


def test_refusals(tmp_path):
    with pytest.raises(bundle.BundleError, match='no sandbox'):
        bundle.bundle(tmp_path / 'a.zip', 'chroot')
    with pytest.raises(bundle.BundleError, match='hidden tests can be'):
        bundle.bundle(tmp_path / 'a.zip', 'none', 'soon')
    with pytest.raises(bundle.BundleError, match='no exercise in chapter 99'):
        bundle.bundle(tmp_path / 'a.zip', 'none', chapters=[99])
    (tmp_path / 'file').write_text('')
    with pytest.raises(bundle.BundleError, match='cannot be written'):
        bundle.bundle(tmp_path / 'file' / 'a.zip', 'none')


@pytest.mark.one_of(3)
def test_a_file_that_vanishes_meanwhile_is_left_out(tmp_path, monkeypatch):
    """Another program's scratch file, which git lists and which is gone when it is read."""
    real = learners_edition.files
    monkeypatch.setattr(learners_edition, 'files', lambda *given: [*real(*given), 'notebooks/gone.tmp'])
    names = bundle.bundle(tmp_path / 'a.zip', 'none')
    assert 'course/README.md' in names and 'course/notebooks/gone.tmp' not in names
    assert 'README.md' in learners_edition.release(tmp_path / 'edition')


@pytest.mark.parametrize(
    ('files', 'packed'),
    [
        ({'a.ipynb': b'1', 'notebooks/b.ipynb': b'2'}, ['a.ipynb']),
        ({'notebooks/b.ipynb': b'2', 'other/c.ipynb': b'3'}, ['notebooks/b.ipynb']),
        ({'deep/er/c.ipynb': b'3', '.git/d.ipynb': b'4', 'x/.ipynb_checkpoints/e.ipynb': b'5'}, ['deep/er/c.ipynb']),
        ({'readme.txt': b''}, []),
        (
            {
                'a.ipynb': b'1',
                'submission.json': b'{}',
                'my_ws/src/patrol/setup.py': b'x',
                'my_ws/src/patrol/patrol/route.py': b'y',
                'my_ws/src/patrol/.hidden': b'z',
                'my_ws/build/patrol/z.py': b'z',
            },
            ['a.ipynb', 'my_ws/src/patrol/patrol/route.py', 'my_ws/src/patrol/setup.py'],
        ),
    ],
)
def test_what_is_packed(tmp_path, files, packed):
    folder = tmp_path / 'submission'
    for name, content in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    (folder / 'link.ipynb').symlink_to('/etc/passwd')
    (folder / 'linked').symlink_to('/etc')
    harness.pack(folder, tmp_path / 'x.zip')
    with zipfile.ZipFile(tmp_path / 'x.zip') as archive:
        assert archive.namelist() == packed
    # A zip that was left packed is taken as it is, unless there are notebooks beside it.
    with zipfile.ZipFile(folder / 'work.zip', 'w') as archive:
        archive.writestr(CHAPTER, small.solved())
    harness.pack(folder, tmp_path / 'x.zip')
    with zipfile.ZipFile(tmp_path / 'x.zip') as archive:
        assert archive.namelist() == (packed or [CHAPTER])


@pytest.mark.parametrize('seconds', [0, -1e9, 7.3e9], ids=['1970', '1938', '2201'])
def test_names_and_dates_that_no_zip_can_hold(tmp_path, seconds):
    """They are the learner's, and would leave the mark open."""
    folder = tmp_path / 'submission'
    (folder / 'my_ws' / 'src' / 'patrol').mkdir(parents=True)
    for name in (CHAPTER, '\udcff.ipynb', 'my_ws/src/patrol/\udcff.py'):
        (folder / name).write_bytes(small.solved())
        os.utime(folder / name, (seconds, seconds))
    harness.pack(folder, tmp_path / 'x.zip')
    found = submission.read(tmp_path / 'x.zip')
    assert not found.problem and found.files[CHAPTER] == small.solved() and len(found.files) == 3


@pytest.mark.parametrize(
    ('metadata', 'learner'),
    [(json.dumps(METADATA), 'gradescope-12-7'), ('{"users": [{"id": "../x"}]}', 'gradescope'), ('[', 'gradescope')],
)
def test_ids(tmp_path, metadata, learner):
    (tmp_path / 'm.json').write_text(metadata)
    assert harness._learner(tmp_path / 'm.json') == learner
    assert harness._learner(tmp_path / 'none.json') == 'gradescope'


def test_defaults_are_known():
    assert gradescope.HIDDEN in gradescope.VISIBILITIES
