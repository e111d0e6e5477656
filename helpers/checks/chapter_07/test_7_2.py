"""Visible tests of exercise 7.2, a program that is not found."""

import pytest

from helpers.checks.chapter_07.findings import compare
from helpers.checks.chapter_07.packages import WHY, Package

pytestmark = pytest.mark.exercise('7.2')


def test_a_file(learner):
    """An entry point that names a file is found.

    Its right side has a `/`, or its module ends in `.py`.
    """
    package = Package(learner.random, 'file')
    compare(learner.call('diagnose_package', package.files), package.expected, WHY)


def test_repair(learner):
    """A wrong module is found and repaired; the other programs stay as they are.

    The program has the name of its module; the function is the one at the left margin without `_`.
    """
    package = Package(learner.random, 'module')
    compare(learner.call('diagnose_package', package.files), package.expected, WHY)
    package.check(learner.call('repair_package', package.files))
