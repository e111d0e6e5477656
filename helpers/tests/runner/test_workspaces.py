"""The tests' side of workspaces, without a program of a learner's."""

from types import SimpleNamespace

import pytest

from helpers.runner.verdicts import LearnerError, LearnerTimeout
from helpers.runner.workspaces import Done, ExerciseWorkspace


def test_a_build_that_does_not_end_is_waited_for_once(monkeypatch):
    calls = []

    def run(self, *argv, timeout):
        calls.append(argv)
        raise LearnerTimeout('it did not end', 'output')

    monkeypatch.setattr(ExerciseWorkspace, 'run', run)
    learner = SimpleNamespace(server=SimpleNamespace(workspaces={}, forget=lambda name: None))
    for _ in range(3):
        with pytest.raises(LearnerTimeout, match='it did not end') as found:
            ExerciseWorkspace(learner, 'ws').build('--packages-select', 'patrol', check=False)
        assert found.value.details == 'output' and not found.value.rule
        found.value.rule = 'builds'  # what a test adds is not seen by the next one
    assert len(calls) == 1
    ExerciseWorkspace(learner, 'ws').forget()
    assert not learner.server.workspaces


SITE = 'patrol/lib/python3.11/site-packages'


@pytest.mark.parametrize(
    ('installed', 'shadow'),
    [
        ([f'{SITE}/patrol/route.py', f'{SITE}/test/__init__.py', f'{SITE}/patrol-0.1.0-py3.11.egg-info/PKG-INFO'], ''),
        ([f'{SITE}/patrol/json.py', f'{SITE}/patrol/rclpy/__init__.py'], ''),
        ([f'{SITE}/patrol/route.py', f'{SITE}/sitecustomize.py'], 'sitecustomize'),
        ([f'{SITE}/importlib/metadata.py'], 'importlib'),
        ([f'{SITE}/json.cpython-311-x86_64-linux-gnu.so'], 'json'),
        (['patrol/local/lib/python3.12/dist-packages/rclpy/__init__.py'], 'rclpy'),
    ],
)
def test_a_package_that_takes_the_place_of_a_module_of_python_is_refused(monkeypatch, installed, shadow):
    """What Python says in its workspace would be the package's word."""
    monkeypatch.setattr(ExerciseWorkspace, 'run', lambda self, *argv, timeout: Done('colcon build', 0, ''))
    monkeypatch.setattr(ExerciseWorkspace, 'installed', lambda self: installed)
    learner = SimpleNamespace(server=SimpleNamespace(workspaces={}, forget=lambda name: None))
    for _ in range(2):
        if shadow:
            with pytest.raises(LearnerError, match=f'installs a Python module `{shadow}`'):
                ExerciseWorkspace(learner, 'ws').build(check=False)
        else:
            assert ExerciseWorkspace(learner, 'ws').build().status == 0
    ExerciseWorkspace(learner, 'ws').forget()
    assert not learner.server.workspaces
