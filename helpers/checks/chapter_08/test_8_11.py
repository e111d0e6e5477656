"""Visible tests of exercise 8.11, tests for the robot: with the learner's own robot, as it is and spoilt."""

import pytest

from helpers.checks.chapter_08.wrong_robots import spoilt

pytestmark = [pytest.mark.exercise('8.11'), pytest.mark.may_take(240)]  # fifteen robots, three at a time, 40 s each


@pytest.mark.rules('right-robots')
def test_own_robot(learner):
    """Your tests pass with your own robot, of exercises 8.5 and 8.7 to 8.9.

    If not: is the robot wrong, or the test? Ask the specification.
    """
    spoilt(learner).accepts(learner)


@pytest.mark.rules('status')
def test_status(learner):
    """Your tests notice robots with a wrong status.

    bench.until(lambda: bench.status) fails if nothing comes.
    """
    spoilt(learner).rejects(learner, 'status')


@pytest.mark.rules('values')
def test_values(learner):
    """Your tests notice robots that take a place or a parameter which they should refuse."""
    spoilt(learner).rejects(learner, 'values')


@pytest.mark.rules('goals')
def test_goals(learner):
    """Your tests notice robots that take a goal which they should reject, or succeed too early."""
    spoilt(learner).rejects(learner, 'goals')


@pytest.mark.rules('ends')
def test_ends(learner):
    """Your tests notice robots that end a drive in the wrong way, or not at all."""
    spoilt(learner).rejects(learner, 'ends')
