"""A process of tests that stands by: the next check takes it, and it leaves nothing behind."""

import psutil
import pytest

from helpers.runner import session, start_processes, tests_process
from helpers.tests import small


@pytest.fixture(autouse=True)
def nothing_left():
    before = set(psutil.Process().children(recursive=True))
    yield
    tests_process.close()
    left = set(psutil.Process().children(recursive=True)) - before
    assert not psutil.wait_procs(left, timeout=5)[1]


def judge(folder, source=small.TALKER, **options):
    options = session.Options(visible=small.write_tests(folder, small.VISIBLE), **options)
    return session.run(small.cells(source), [small.exercise()], options)


def test_a_check_takes_it(tmp_path):
    tests_process.stand_by()
    ready = tests_process._ready
    tests_process.stand_by()
    assert tests_process._ready is ready  # one is enough
    report = judge(tmp_path)
    assert report.exercises[0].passed and not report.log and 'prepared' in report.spent
    assert tests_process._ready is None and ready.process.returncode is not None


def test_the_second_check_has_a_process_of_its_own(tmp_path):
    tests_process.stand_by()
    assert 'prepared' in judge(tmp_path).spent
    assert 'prepared' not in judge(tmp_path).spent


def test_one_that_has_ended_is_replaced(tmp_path):
    tests_process.stand_by()
    tests_process._ready.process.kill()
    tests_process._ready.process.wait()
    report = judge(tmp_path)
    assert report.exercises[0].passed and not report.log and 'prepared' not in report.spent
    tests_process.stand_by()
    assert tests_process._ready.process.poll() is None


def test_one_with_other_limits_is_not_taken(tmp_path):
    tests_process.stand_by()
    ready = tests_process._ready
    assert judge(tmp_path, limits=start_processes.Limits(output=5000)).exercises[0].passed
    assert tests_process._ready is ready


def test_close_is_idempotent():
    tests_process.close()
    tests_process.stand_by()
    tests_process.close()
    tests_process.close()
    assert tests_process._ready is None
