"""Visible tests of exercise 1.2, read an environment."""

import pytest

from helpers.checks.chapter_01 import environments

pytestmark = pytest.mark.exercise('1.2')


@pytest.mark.rules(
    'dictionary',
    'every-fault',
    'not-sourced',
    'mixed',
    'ros-distro',
    'workspace',
    'python',
    'domain',
    'off',
    'unknown',
    'missing',
)
def test_diagnose(learner):
    """Each fault of an environment is named, and nothing else.

    One `if` for each variable; split paths at the colons, and folders at the slashes.
    """
    environments.check(learner, environments.cases(learner.random))
    environments.check(learner, environments.several(learner.random))
