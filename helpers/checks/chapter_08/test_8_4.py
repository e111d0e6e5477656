"""Visible tests of exercise 8.4, tests that find bugs."""

import pytest

from helpers.checks.chapter_08.limits import VISIBLE

pytestmark = pytest.mark.exercise('8.4')


@pytest.mark.given
@pytest.mark.rules('right-functions', 'no-ros')
def test_right_functions(learner):
    """Your tests pass with right functions, also with one that computes in another order.

    Run them by hand and read what fails.
    """
    VISIBLE.accepts(learner)


@pytest.mark.rules('max-speed')
def test_max_speed(learner):
    """Your tests notice functions that do not keep max_speed."""
    VISIBLE.rejects(learner, 'max-speed')


@pytest.mark.rules('borders')
def test_borders(learner):
    """Your tests notice functions with wrong borders of the distance."""
    VISIBLE.rejects(learner, 'borders')


@pytest.mark.rules('slope')
def test_slope(learner):
    """Your tests notice functions that are wrong between the borders."""
    VISIBLE.rejects(learner, 'slope')


@pytest.mark.rules('backwards')
def test_backwards(learner):
    """Your tests notice functions that hold back a robot that drives backwards."""
    VISIBLE.rejects(learner, 'backwards')


@pytest.mark.rules('sensor')
def test_sensor(learner):
    """Your tests notice functions that treat nan or inf as distance in the wrong way."""
    VISIBLE.rejects(learner, 'sensor')


@pytest.mark.rules('bad-max-speed')
def test_bad_max_speed(learner):
    """Your tests notice functions that take a bad max_speed, refuse it with another error, or refuse a good one."""
    VISIBLE.rejects(learner, 'bad-max-speed')
