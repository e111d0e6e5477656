"""The same submission, 25 times over while both cores are busy: the same marks, verdicts and messages each time."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from grading import grading_run
from grading.submission import Submission
from helpers.tests import small

REPEATS = 25
# Half right: the rate is as asked, the texts are not.
WRONG_TEXTS = small.TALKER.replace('self.count = 0', 'self.count = 1')


@pytest.fixture
def busy_cores():
    """A process for each core that does nothing but compute, until the test ends."""
    argv = [sys.executable, '-S', '-c', 'while True: pass']
    burners = [subprocess.Popen(argv) for _ in os.sched_getaffinity(0)]
    yield
    for burner in burners:
        burner.kill()
        burner.wait()


@pytest.mark.one_of(3)
@pytest.mark.timeout(400)
def test_repeated_gradings_are_identical(tmp_path, busy_cores):
    hidden = small.write_tests(tmp_path, small.HIDDEN, kind='exercises')
    course = grading_run.Course((small.exercise(),), small.write_tests(tmp_path, small.VISIBLE), hidden)
    content = {small.NOTEBOOK: small.solved(WRONG_TEXTS)}
    works = [Submission(f'learner{number:02}', Path('work.ipynb'), content) for number in range(REPEATS)]
    records = grading_run.grade(works, course, tmp_path / 'out', jobs=2)
    found = {
        (
            record.status,
            record.score,
            tuple((test.test, test.verdict, test.message) for one in record.exercises for test in one.tests),
        )
        for record in records
    }
    assert len(records) == REPEATS
    ((status, score, tests),) = found
    assert (status, score) == ('graded', 2.5), found
    assert [verdict for _, verdict, _ in tests] == ['passed', 'failed']
