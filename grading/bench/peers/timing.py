"""How long the other graders need, each on right answers, whose full marks are verified."""

import csv
import json
import tempfile
import time
from pathlib import Path

from grading.bench.peers import sheets
from grading.bench.peers.peers_environment import program, run
from helpers.kernel import domains

FULL = 3.0
SHEET = 'sheet'


def seconds(peer: str, submissions: int) -> float:
    """Return how long one of PEERS needs to grade so many submissions; to hand out and to make tests is not in it.

    :raises RuntimeError: it could not be installed, failed, or did not give full marks.
    """
    program('nbgrader')  # the installation is not part of the times
    with domains.claim() as domain_id, tempfile.TemporaryDirectory(prefix='course-bench-') as folder:
        return PEERS[peer](Path(folder), submissions, domain_id)


def _nbgrader(course: Path, submissions: int, domain_id: int) -> float:
    sheets.for_nbgrader(course / 'source' / SHEET / f'{SHEET}.ipynb')
    for number in range(submissions):
        sheets.for_nbgrader(course / 'submitted' / f'learner{number:03}' / SHEET / f'{SHEET}.ipynb')
    run('nbgrader', 'generate_assignment', SHEET, '--create', domain_id=domain_id, cwd=course)
    begin = time.perf_counter()
    run('nbgrader', 'autograde', SHEET, domain_id=domain_id, cwd=course)
    seconds = time.perf_counter() - begin
    run('nbgrader', 'export', domain_id=domain_id, cwd=course)
    with open(course / 'grades.csv', newline='', encoding='utf-8') as grades:
        marks = [float(row['score']) for row in csv.DictReader(grades)]
    _verify('nbgrader', marks, submissions)
    return seconds


def _otter(folder: Path, submissions: int, domain_id: int) -> float:
    (folder / 'tests').mkdir()
    sheets.otter_tests(folder / 'tests')
    run('otter', 'generate', '-t', 'tests', '-o', 'autograder.zip', domain_id=domain_id, cwd=folder)
    seconds, marks = 0.0, []
    for number in range(submissions):
        one = folder / f'learner{number:03}'
        sheets.for_otter(one / f'{SHEET}.ipynb')
        begin = time.perf_counter()
        run(
            'otter',
            'run',
            '-a',
            'autograder.zip',
            '-o',
            str(one),
            '--no-logo',
            str(one / f'{SHEET}.ipynb'),
            domain_id=domain_id,
            cwd=folder,
        )
        seconds += time.perf_counter() - begin
        tests = json.loads((one / 'results.json').read_text(encoding='utf-8'))['tests']
        marks.append(float(sum(test.get('score', 0) for test in tests)))
    _verify('otter', marks, submissions)
    return seconds


def _verify(name: str, marks: list[float], submissions: int) -> None:
    if marks != [FULL] * submissions:
        raise RuntimeError(f'{name} did not give full marks to right answers: {marks}')


PEERS = {'nbgrader autograde': _nbgrader, 'otter run': _otter}
