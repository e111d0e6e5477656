"""The learner's progress: what checks leave behind, and the page that JupyterLab opens on."""

import errno
import fcntl
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from helpers import paths
from helpers.exercises import manifest, progress_file, start_page
from helpers.runner.results import ExerciseResult, RuleResult, TestResult
from helpers.runner.session import SessionReport

FIRST, *_ = EXERCISES = list(manifest.load().values())


def result(exercise, score, verdict='passed'):
    return ExerciseResult(exercise.id, exercise.title, exercise.points, verdict, score)


def report(*results):
    return SessionReport(list(results), seeds={result.id: 'abc' for result in results})


@pytest.fixture
def folder(tmp_path):
    """Two chapters: one as it is, one that cannot be read."""
    name = FIRST.notebook
    (tmp_path / name).write_bytes((paths.NOTEBOOKS / name).read_bytes())
    (tmp_path / '99_broken.ipynb').write_text('{')
    return tmp_path


def test_marks_are_kept_and_replaced(tmp_path):
    progress_file.note(report(result(FIRST, 5, 'failed')), tmp_path)
    progress_file.note(report(result(EXERCISES[1], EXERCISES[1].points)), tmp_path)
    progress_file.note(report(result(FIRST, FIRST.points)), tmp_path)
    assert progress_file.load(tmp_path) == {
        exercise.id: progress_file.Mark(exercise.points, exercise.points, True) for exercise in EXERCISES[:2]
    }


def test_a_failed_check_keeps_its_values_until_it_passes(tmp_path):
    failed = result(FIRST, 5, 'failed')
    failed.tests = [TestResult('a', FIRST.id, False, 1, 'failed')]
    failed.rules = [RuleResult('one', 'One.', 'kept'), RuleResult('two', 'Two.', 'broken')]
    progress_file.note(report(failed), tmp_path)
    assert progress_file.seeds([FIRST.id, 'unknown'], tmp_path) == {FIRST.id: 'abc'}
    assert (progress_file.load(tmp_path)[FIRST.id].kept, progress_file.load(tmp_path)[FIRST.id].rules) == (1, 2)
    progress_file.note(report(result(FIRST, FIRST.points)), tmp_path)
    assert progress_file.seeds([FIRST.id], tmp_path) == {}


def test_a_disk_without_locks_keeps_marks(tmp_path, monkeypatch):
    def flock(*arguments):
        raise OSError(errno.ENOLCK, 'No locks available')

    monkeypatch.setattr(fcntl, 'flock', flock)
    progress_file.note(report(result(FIRST, FIRST.points)), tmp_path)
    assert progress_file.load(tmp_path)[FIRST.id].passed


def test_a_check_that_could_not_run_changes_nothing(tmp_path):
    progress_file.note(report(result(FIRST, FIRST.points)), tmp_path)
    progress_file.note(report(result(FIRST, None, 'grader_error')), tmp_path)
    assert progress_file.load(tmp_path)[FIRST.id].passed


@pytest.mark.parametrize('text', ['', '[]', '{"3.1": 5}', '{"3.1": {"points": "x"}}'])
def test_a_damaged_file_is_no_hindrance(tmp_path, text):
    (tmp_path / progress_file.FILE).write_text(text)
    assert progress_file.load(tmp_path) == {}
    progress_file.note(report(result(FIRST, 1)), tmp_path)
    assert list(progress_file.load(tmp_path)) == [FIRST.id]


def test_checks_at_the_same_time_lose_nothing(tmp_path):
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda exercise: progress_file.note(report(result(exercise, 1)), tmp_path), EXERCISES))
    assert set(progress_file.load(tmp_path)) == {exercise.id for exercise in EXERCISES}
    assert not list(tmp_path.glob('*.json?*[!k]'))  # no half-written file is left


def test_the_page_tells_the_chapters_from_their_notebooks(folder):
    text = start_page.text(folder)
    assert f'[1. Environment]({FIRST.notebook}) | three hours |' in text
    assert '> ROS is not switched on by installing it.' in text
    assert '- choose a distribution' in text
    assert '**Damaged, cannot be opened:** `99_broken.ipynb`' in text
    missing = {exercise.notebook for exercise in EXERCISES} - {FIRST.notebook}
    assert all(f'`{name}`' in text for name in missing)
    assert f'`{FIRST.notebook}`' not in text


def test_a_page_that_cannot_be_written_leaves_the_old_one(folder, monkeypatch):
    old = start_page.write(folder).read_text()
    monkeypatch.setattr(Path, 'replace', lambda *_: (_ for _ in ()).throw(OSError(28, 'No space left')))
    with pytest.raises(OSError, match='No space left'):
        start_page.write(folder)
    assert (folder / start_page.FILE).read_text() == old
    assert {path.suffix for path in folder.iterdir()} == {'.ipynb', '.md'}
    assert len(list(folder.glob('.*'))) == 0


def test_the_page_follows_the_checks(folder):
    mine = [exercise for exercise in EXERCISES if exercise.notebook == FIRST.notebook]
    start_page.keep(report(result(FIRST, FIRST.points)), folder)
    text = (folder / start_page.FILE).read_text()
    rules = sum(len(exercise.rules) for exercise in mine)
    total = f'{sum(exercise.points for exercise in mine):.0f}'
    assert f'1 of {len(mine)} | 0 of {rules} | {FIRST.points:g} of {total} |' in text
    assert f'still open: {", ".join(exercise.id for exercise in mine[1:])}' in text
    assert '**Go on with [1. Environment]' in text
    start_page.keep(report(*(result(exercise, exercise.points) for exercise in mine)), folder)
    assert '**You have solved every exercise.**' in (folder / start_page.FILE).read_text()


def test_a_folder_that_cannot_be_written_to_stops_no_check(tmp_path):
    (tmp_path / 'file').write_text('no folder')
    start_page.keep(report(result(FIRST, 1)), tmp_path / 'file')
    assert (tmp_path / 'file').read_text() == 'no folder'
