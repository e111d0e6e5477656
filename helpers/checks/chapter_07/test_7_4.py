"""Visible tests of exercise 7.4, a program that stands still."""

import pytest

from helpers.checks.chapter_07 import stacks
from helpers.runner import about

pytestmark = pytest.mark.exercise('7.4')


@pytest.mark.rules('server', 'call', 'spin', 'busy', 'healthy', 'own-call', 'all')
def test_stacks(learner):
    """Each thread that stands is found, with its cause, and no other.

    A thread's own call is its newest one in one of the program's files.
    """
    for cause in stacks.CAUSES:
        for _ in range(3):
            with about(cause):
                stacks.diagnose(learner, cause, plain=True)
    for state, cause in stacks.OTHERS:
        for _ in range(stacks.OFTEN):
            with about(cause):
                stacks.diagnose(learner, state, plain=True)
    for state in ('spinning', 'idle', *['waits in main', 'at work'] * 4, 'serving'):
        with about('healthy'):
            stacks.diagnose(learner, state, rule='healthy', plain=True)
    for _ in range(3):
        for cause in stacks.CAUSES:
            with about('own-call'):
                stacks.diagnose(learner, cause, rule='own-call')
    stacks.judge_task(learner)
    stacks.judge_others(learner)
    with about('all'):
        stacks.diagnose(learner, 'idle', *stacks.CAUSES, 'spinning', rule='all')
        stacks.diagnose(learner, 'idle', 'busy', 'same', 'spinning', learner.random.choice(stacks.CAUSES), rule='all')


@pytest.mark.rules('answer')
def test_answer(learner):
    """If the server answers, the client prints the answer and ends with status 0.

    The client's node must be spun to get it.
    """
    stacks.judge_answer(learner, 'visible')


@pytest.mark.rules('no-server')
def test_no_server(learner):
    """Without a server, the client prints so after its time and ends with status 1.

    wait_for_service(timeout_sec=…) returns False if there is none.
    """
    stacks.judge_no_server(learner, 'visible')


@pytest.mark.rules('no-answer')
def test_silent_server(learner):
    """If the server is there and never answers, the client prints so and ends with status 1.

    Every wait has a timeout, also the one for the answer.
    """
    stacks.judge_no_answer(learner, 'visible')


@pytest.mark.rules('interrupt')
def test_interrupt(learner):
    """Ctrl+C ends the client while it waits.

    An `except` without a name catches KeyboardInterrupt, too.
    """
    stacks.judge_interrupt(learner)
