"""Visible tests of exercise 8.6, tests for the steering."""

import pytest

from helpers.checks.chapter_08.wrong_steerings import VISIBLE

pytestmark = pytest.mark.exercise('8.6')


@pytest.mark.given
@pytest.mark.rules('right-functions', 'no-ros')
def test_right_functions(learner):
    """Your tests pass with functions that do what exercise 8.5 says.

    Look at the specification again: what does it say, and what do you ask for?
    """
    VISIBLE.accepts(learner)


@pytest.mark.rules('turns')
def test_turns(learner):
    """Your tests notice functions that turn with a wrong angle or a wrong factor."""
    VISIBLE.rejects(learner, 'turns')


@pytest.mark.rules('short-way')
def test_short_way(learner):
    """Your tests notice functions that turn the long way round."""
    VISIBLE.rejects(learner, 'short-way')


@pytest.mark.rules('max-angular')
def test_max_angular(learner):
    """Your tests notice functions that do not keep max_angular."""
    VISIBLE.rejects(learner, 'max-angular')


@pytest.mark.rules('speed')
def test_speed(learner):
    """Your tests notice functions that drive with a wrong speed."""
    VISIBLE.rejects(learner, 'speed')


@pytest.mark.rules('on-the-spot')
def test_on_the_spot(learner):
    """Your tests notice functions that do not turn on the spot when they must, or when they must not."""
    VISIBLE.rejects(learner, 'on-the-spot')


@pytest.mark.rules('places')
def test_places(learner):
    """Your tests notice functions that have a wrong distance, or do not know their place."""
    VISIBLE.rejects(learner, 'places')
