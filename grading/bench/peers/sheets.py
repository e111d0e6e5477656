"""The sheet in the formats of the other graders, with a test for each answer."""

from pathlib import Path

import nbformat

from grading.bench.peers.peers_environment import KERNEL
from grading.bench.timed_sheet import ANSWERS

_HEAR_THE_TALKER = """\
import time
from rclpy.executors import SingleThreadedExecutor
rclpy.init()
heard, talker, grader = [], Talker(), rclpy.create_node('grader')
grader.create_subscription(String, 'chatter', heard.append, 10)
executor = SingleThreadedExecutor()
executor.add_node(talker)
executor.add_node(grader)
end = time.monotonic() + 10
while len(heard) < 3 and time.monotonic() < end:
    executor.spin_once(timeout_sec=0.1)
talker.destroy_node()
grader.destroy_node()
rclpy.shutdown()
assert [message.data for message in heard] == ['hello'] * 3
"""
CHECKS = ('assert mean([1, 2, 3]) == 2\n', 'assert clamp(5, 0, 3) == 3\n', _HEAR_THE_TALKER)
_USED = ('mean', 'clamp', 'Talker, rclpy, String')


def for_nbgrader(path: Path) -> None:
    """Write a notebook whose cells carry nbgrader's metadata: an answer, then its test, three times."""
    cells = []
    for number, (answer, check) in enumerate(zip(ANSWERS, CHECKS, strict=True)):
        cells += [_cell(answer, f'answer-{number}', solution=True), _cell(check, f'test-{number}', points=1)]
    _write(path, cells)


def for_otter(path: Path) -> None:
    """Write a notebook of answers."""
    _write(path, [nbformat.v4.new_code_cell(answer) for answer in ANSWERS])


def otter_tests(folder: Path) -> None:
    """Write otter's test files, one per answer."""
    for number, (check, used) in enumerate(zip(CHECKS, _USED, strict=True), start=1):
        body = ''.join(f'    {line}\n' for line in check.splitlines())
        (folder / f'q{number}.py').write_text(
            f'from otter.test_files import test_case\n\nOK_FORMAT = False\nname = "q{number}"\npoints = 1\n\n\n'
            f'@test_case(points=1)\ndef check({used}):\n{body}'
        )


def _cell(text: str, grade_id: str, *, solution: bool = False, points: int | None = None):
    graded = {} if points is None else {'points': points}
    cell = nbformat.v4.new_code_cell(text)
    cell.metadata.nbgrader = {
        'grade': not solution,
        'grade_id': grade_id,
        'locked': not solution,
        'schema_version': 3,
        'solution': solution,
        'task': False,
        **graded,
    }
    return cell


def _write(path: Path, cells: list) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    notebook = nbformat.v4.new_notebook(cells=cells)
    notebook.metadata.kernelspec = {'name': KERNEL, 'display_name': KERNEL, 'language': 'python'}
    nbformat.write(notebook, path)
