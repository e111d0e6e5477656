"""Hidden tests of exercise 7.2, a program that is not found. Every package is drawn."""

import pytest

from helpers.checks.chapter_07.faulty_packages import CAUSES, FORMS, FaultyPackage, judge_rare_entries
from helpers.runner import about

pytestmark = pytest.mark.exercise('7.2')


@pytest.mark.given
@pytest.mark.rules('file', 'module', 'function', 'kept')
def test_healthy_package(learner):
    """A package without a fault gives an empty list, and is not changed.

    Two modules may have functions of other names than main.
    """
    for _ in range(3):
        package = FaultyPackage(learner.random)
        package.diagnose(learner)
        with about('kept'):
            package.check(learner.call('repair_package', package.files))


@pytest.mark.rules('file', 'module', 'function')
@pytest.mark.weight(2)
@pytest.mark.parametrize('cause', CAUSES)
def test_one_program(learner, cause):
    """A program that would not start is found, with its cause and its entry point.

    The table has three causes; each has more than one form.
    """
    for form in range(FORMS):
        with about(cause):
            FaultyPackage(learner.random, cause, form=form).diagnose(learner)


@pytest.mark.rules('all', 'file', 'module', 'function')
def test_several_programs(learner):
    """Each program is judged by itself.

    Do not return after the first one.
    """
    for _ in range(5):
        FaultyPackage(learner.random, *learner.random.choices(CAUSES, k=3)).diagnose(learner, 'all')
    FaultyPackage(learner.random, *learner.random.choices(CAUSES, k=5)).diagnose(learner, 'all')
    judge_rare_entries(learner)


@pytest.mark.rules('repaired', 'kept')
@pytest.mark.weight(2)
def test_repaired_entry_points(learner):
    """After the repair each program leads to its own function, also where two had the same wrong one.

    Replace an entry as a whole, by the name of its program.
    """
    for causes in (['file'], ['function'], ['module', 'module', 'module', 'module'], ['file', 'function', 'module']):
        for _ in range(5):
            package = FaultyPackage(learner.random, *causes, form=0 if len(causes) == 4 else None)
            package.diagnose(learner, 'all')
            with about('repaired'):
                package.check(learner.call('repair_package', package.files))
    for form in (1, 3):  # no right side is left that names the package
        package = FaultyPackage(learner.random, *['module'] * 5, form=form)
        package.diagnose(learner, 'all')
        with about('repaired'):
            package.check(learner.call('repair_package', package.files))


@pytest.mark.rules('repaired')
@pytest.mark.weight(2)
def test_it_runs(learner):
    """The repaired package is built with colcon, and all its programs run.

    This is what the user sees.
    """
    package = FaultyPackage(learner.random, *CAUSES)
    package.diagnose(learner, 'all')
    package.build(learner, learner.call('repair_package', package.files))
