"""Visible tests of exercise 7.2, a program that is not found."""

import pytest

from helpers.checks.chapter_07.faulty_packages import CAUSES, FORMS, FaultyPackage, judge_rare_entries
from helpers.runner import about

pytestmark = pytest.mark.exercise('7.2')


@pytest.mark.rules('file', 'module', 'function', 'all')
def test_causes(learner):
    """Each wrong entry point is found with its cause, and nothing is found in a package that is right.

    `module.replace('.', '/') + '.py'` is the file of a module.
    """
    for cause in CAUSES:
        for form in range(FORMS):
            with about(cause):
                FaultyPackage(learner.random, cause, form=form).diagnose(learner)
    FaultyPackage(learner.random).diagnose(learner)
    judge_rare_entries(learner)
    with about('all'):
        FaultyPackage(learner.random, *CAUSES).diagnose(learner, 'all')
        FaultyPackage(learner.random, 'module', 'module', form=0).diagnose(learner, 'all')
        FaultyPackage(learner.random, *CAUSES, 'file', 'module').diagnose(learner, 'all')  # every program is wrong


@pytest.mark.rules('repaired', 'kept')
def test_repair(learner):
    """A wrong entry point is replaced by the right one; everything else stays as it is.

    The program has the name of its module; the function is the one at the left margin without `_`.
    """
    every = (('module',) * 5, learner.random.choice([1, 3]))  # no right side is left that names the package
    for causes, form in (
        ((), None),
        (('file',), None),
        (('function',), None),
        (('module',) * 3, 0),
        (CAUSES, None),
        every,
    ):
        package = FaultyPackage(learner.random, *causes, form=form)
        package.diagnose(learner, 'all')
        with about('repaired'):
            package.check(learner.call('repair_package', package.files))
