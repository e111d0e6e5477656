"""The tests' side of workspaces, without a program of a learner's."""

from types import SimpleNamespace

import pytest

from helpers.runner.verdicts import LearnerTimeout
from helpers.runner.workspaces import ExerciseWorkspace


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
