"""Hidden tests of exercise 7.1, a machine. Every machine is drawn."""

import pytest

from helpers.checks.chapter_07 import machines
from helpers.checks.chapter_07.findings import compare

pytestmark = pytest.mark.exercise('7.1')
APT, SHELL = machines.CAUSES[:3], machines.CAUSES[3:]


def check(learner, *causes):
    files, want, expected = machines.draw(learner.random, *causes)
    compare(learner.call('diagnose_machine', files, want), expected, machines.WHY)
    return files, want


def test_healthy_machine(learner):
    """A machine without a fault gives an empty list.

    Comments do nothing, and of several lines that set one variable, the last one holds.
    """
    for _ in range(5):
        check(learner)


def test_apt(learner):
    """Every fault of apt's file is found, and its evidence is the line.

    The rows of the table that begin with A7.1.
    """
    for cause in APT:
        check(learner, cause)
    check(learner, 'release', 'key')


@pytest.mark.weight(2)
def test_each_fault_of_a_shell(learner):
    """Every fault of the .bashrc is found where it is alone.

    The rows of the table from A7.2 to A7.7, for other distributions, folders and domains.
    """
    for cause in SHELL:
        for _ in range(4):
            check(learner, cause)


def test_several_faults(learner):
    """Several faults at once are several findings.

    Do not return after the first one.
    """
    for _ in range(5):
        check(learner, *learner.random.sample(SHELL, 3), learner.random.choice(APT))
    check(learner, 'not sourced', 'other')


@pytest.mark.weight(2)
def test_repaired_shell(learner):
    """A shell with the repaired .bashrc finds everything, and keeps what was right.

    A line can be dropped, changed or added. The folders of a PATH stay.
    """
    for causes in (SHELL, learner.random.sample(SHELL, 2)):
        files, want, _ = machines.draw(learner.random, *causes)
        machines.try_out(learner, files, learner.call('repair_machine', files, want), want)


def test_repaired_source(learner):
    """The repaired ros2.list is for the right release and names a key; one that was right stays.

    DEB is a line that is right; it wants the codename.
    """
    for causes in (['missing'], ['release', 'key'], []):
        files, want, _ = machines.draw(learner.random, *causes)
        machines.try_out(learner, files, learner.call('repair_machine', files, want), want)
