"""The tests' side of workspaces, without a program of a learner's."""

from types import SimpleNamespace

import pytest

from helpers.runner import load, workspaces
from helpers.runner.verdicts import LearnerTimeout
from helpers.runner.workspaces import BUILD_AGAIN, BUILD_TIMEOUT, PATIENCE, ExerciseWorkspace


def test_a_build_that_does_not_end_is_waited_for_once(monkeypatch):
    calls = []

    def run(self, argv, timeout, alone):
        calls.append(argv)
        raise LearnerTimeout('it did not end', 'output')

    monkeypatch.setattr(ExerciseWorkspace, '_run', run)
    learner = SimpleNamespace(program={'title': 'x'}, server=SimpleNamespace(workspaces={}, forget=lambda name: None))
    for _ in range(3):
        with pytest.raises(LearnerTimeout, match='it did not end') as found:
            ExerciseWorkspace(learner, 'ws').build('--packages-select', 'patrol', check=False)
        assert found.value.details == 'output' and not found.value.rule
        found.value.rule = 'builds'  # what a test adds is not seen by the next one
    assert len(calls) == 1
    ExerciseWorkspace(learner, 'ws').forget()
    assert not [key for key in learner.server.workspaces if 'ws' in key]


class Server:
    """A fork server whose builds never end; `uses` is the processor time that they take, in seconds of each second."""

    def __init__(self, uses):
        self.workspaces, self.uses, self.waited = {}, uses, 0.0

    def task(self, *_, **__):
        return SimpleNamespace(wait=self.wait, end=lambda: None, output='')

    def wait(self, seconds):
        self.waited += seconds

    def used(self, place):
        return self.waited * self.uses

    def learner(self):
        return SimpleNamespace(program={'title': 'x'}, server=self, end_calls=lambda: None)


@pytest.fixture
def busy(monkeypatch):
    """Each processor has twice the work that it can do."""
    monkeypatch.setattr(load.os, 'getloadavg', lambda: (2.0 * load.os.cpu_count(), 0, 0))


def test_builds_that_wait_for_something_are_given_up_together(busy):
    """On a busy machine, too: who does not compute is not late because of others."""
    server = Server(uses=0.0)
    for number in range(5):
        with pytest.raises(LearnerTimeout, match='colcon build .* did not end within 90 s'):
            ExerciseWorkspace(server.learner(), f'ws_{number}').build()
    assert server.waited == BUILD_TIMEOUT + BUILD_AGAIN


@pytest.mark.parametrize(('uses', 'waited'), [(0.2, PATIENCE * BUILD_TIMEOUT), (0.5, 2 * BUILD_TIMEOUT)])
def test_a_build_that_computes_has_more_time_while_others_do(busy, uses, waited):
    """Until its own processor time is as much as it may take."""
    server = Server(uses)
    with pytest.raises(LearnerTimeout):
        ExerciseWorkspace(server.learner(), 'ws').build()
    assert server.waited == waited


def test_a_build_has_no_more_time_if_nobody_else_computes(monkeypatch):
    monkeypatch.setattr(workspaces, 'busy', lambda: False)
    server = Server(uses=0.5)
    with pytest.raises(LearnerTimeout):
        ExerciseWorkspace(server.learner(), 'ws').build()
    assert server.waited == BUILD_TIMEOUT


SETUP = """\
Traceback (most recent call last):
  File "<string>", line 1, in <module>
  File "/usr/lib/setuptools/_distutils/core.py", line 268, in run_setup
    exec(code, g)
  File "<string>", line 9
    hello = greeter.hello:main,
    ^^^^^^^^^^^^^^^^^^^^^
SyntaxError: invalid syntax. Maybe you meant '==' or ':=' instead of '='?
--- stderr: greeter
Traceback (most recent call last):
  File "/usr/lib/colcon_core/executor/__init__.py", line 91, in __call__
subprocess.CalledProcessError: Command '[...]' returned non-zero exit status 1.
"""


def test_a_mistake_in_setup_py_is_told_with_its_line():
    assert workspaces.reason(SETUP).startswith('setup.py, line 9: SyntaxError: invalid syntax.')
    other = "error: can't copy 'package.xlm': doesn't exist or not a regular file"
    assert workspaces.reason(f'Starting >>> greeter\n{other}\n') == other
    assert workspaces.reason('') == 'it printed nothing'


@pytest.mark.parametrize(
    ('frame', 'status', 'where'),
    [
        ('/home/ws/install/odometry/lib/python3.11/site-packages/odometry/report.py', 1, 'in report.py, line 7, '),
        ('/usr/lib/python3.11/json/decoder.py', 1, ''),
        ('/src' * 8000, 1, ''),  # no program makes the tests' side search for long
        ('/home/ws/install/odometry/lib/python3.11/site-packages/odometry/report.py', 0, ''),
    ],
)
def test_where_a_program_ended(frame, status, where):
    output = (
        f'Traceback (most recent call last):\n  File "{frame}", line 7, in main\nIndexError: list index out of range\n'
    )
    assert workspaces.Done('ros2 run odometry report', status, output).where == where


@pytest.mark.parametrize(
    ('output', 'line'),
    [
        ('', ''),
        ('one\n  two  \n\n', 'two'),
        ('ValueError: no\n[ros2run]: Process exited with failure 1\n', 'ValueError: no'),
        (
            'Traceback (most …\nrclpy.exceptions.InvalidTopicNameException: Invalid topic name: it has a dot:\n'
            "  'bea.con'\n      ^\n",
            'rclpy.exceptions.InvalidTopicNameException: Invalid topic name: it has a dot:',
        ),
        ('ValueError: no\nfound it all the same\n', 'found it all the same'),
    ],
)
def test_the_last_line_that_tells_something(output, line):
    assert workspaces.Done('python3 drive.py', 1, output).last_line == line
