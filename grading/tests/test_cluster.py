"""A real Dask cluster: a scheduler and workers in processes of their own, and units that kill their workers."""

import os
import subprocess
import sys
import threading

import pytest

from grading import grading_run, parallel
from grading.submission import Submission
from helpers import paths
from helpers.tests import small

# The tests' process kills the Dask worker that started it: once for bob, always for eve.
DEADLY = '''
def test_deadly(learner):
    """It returns its name."""
    name = learner.call('Talker')
    flag = '{flag}'
    if name == 'eve' or name == 'bob' and not os.path.exists(flag):
        open(flag, 'w').close()
        worker = next(one for one in psutil.Process().parents() if 'dask_worker' in ' '.join(one.cmdline()))
        worker.kill()
        time.sleep(60)  # ended with the worker
    expect(name == 'ada' or os.path.exists(flag), f'{{learner.random.random()}}')
'''


@pytest.fixture
def cluster(tmp_path):
    """Starts programs of Dask's; all of them end with the test."""
    processes = []

    def start(*words, awaited, count=1, **environment):
        started = [
            subprocess.Popen(
                [sys.executable, '-m', 'distributed.cli.' + words[0], *words[1:]],
                text=True,
                cwd=tmp_path,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                start_new_session=True,
                env={**os.environ, 'PYTHONPATH': str(paths.ROOT), **environment},
            )
            for _ in range(count)
        ]
        processes.extend(started)
        for process in started:
            for line in process.stdout:
                if awaited in line:
                    break
            else:
                raise AssertionError(f'{words} ended with status {process.wait()}')
            threading.Thread(target=process.stdout.read, daemon=True).start()
        return line

    yield start
    for process in reversed(processes):
        process.kill()
        process.wait()


@pytest.mark.one_of(3)
@pytest.mark.timeout(300)
def test_workers_that_die(cluster, tmp_path):
    """A unit whose worker dies is done again; one that kills each is a grader's fault; the others are as if local."""
    line = cluster(
        'dask_scheduler',
        '--host',
        '127.0.0.1',
        '--port',
        '0',
        '--no-dashboard',
        awaited='Scheduler at:',
        DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES='1',
    )
    address = line.rpartition('Scheduler at:')[2].strip()
    with pytest.raises(parallel.ClusterError, match='has no workers'):
        parallel.Cluster(address)
    cluster(
        'dask_worker',
        address,
        '--host',
        '127.0.0.1',
        '--nthreads',
        '1',
        '--no-dashboard',
        '--no-nanny',
        '--death-timeout',
        '60',
        awaited='Registered to:',
        count=4,
    )  # three will die
    small.write_tests(tmp_path, 'import psutil\n' + DEADLY.format(flag=tmp_path / 'flag'), kind='exercises')
    (tmp_path / 'checks').mkdir()
    course = grading_run.Course((small.exercise(),), tmp_path / 'checks', tmp_path / 'exercises', 'none')
    works = [
        Submission(
            name,
            tmp_path / name,
            {small.NOTEBOOK: small.solved(f'def Talker():\n    return {name!r}\n')},
            handed_in='2026-11-01T10:00:00Z',
        )
        for name in ('ada', 'bob', 'eve')
    ]
    records = grading_run.grade(
        works, course, tmp_path / 'far', settings=grading_run.Settings(seed='s', cluster=address)
    )
    assert [(record.status, record.score) for record in records] == [
        ('graded', 10),
        ('graded', 10),
        ('grader_error', None),
    ]
    assert 'KilledWorker' in (tmp_path / 'far' / 'run.log').read_text()
    (near,) = grading_run.grade(works[:1], course, tmp_path / 'near', settings=grading_run.Settings(seed='s'))
    assert near == records[0]
