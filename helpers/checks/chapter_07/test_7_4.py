"""Visible tests of exercise 7.4, a program that stands still."""

import pytest

from helpers.checks.chapter_07 import stacks
from helpers.runner import about, expect

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
    for state in ('spinning', 'idle', 'waits in main'):
        with about('healthy'):
            stacks.diagnose(learner, state, rule='healthy', plain=True)
    for _ in range(3):
        for cause in stacks.CAUSES:
            with about('own-call'):
                stacks.diagnose(learner, cause, rule='own-call')
    with about('all'):
        stacks.diagnose(learner, 'idle', *stacks.CAUSES, 'spinning', rule='all')


@pytest.mark.rules('answer')
def test_answer(learner):
    """If the server answers, the client prints the answer and ends with status 0.

    The client's node must be spun to get it.
    """
    word, name = f'word {learner.random.randint(100, 999)}', f'/service_{learner.random.randint(10, 99)}'
    printed, status = stacks.Client(learner).ask(name, 5, word)
    expect(
        (printed, status) == (f'answer: {word}', '0'),
        f'The server of {name} answered `{word}`; the client printed `{printed}` and ended with status {status}.',
    )


@pytest.mark.rules('no-server')
def test_no_server(learner):
    """Without a server, the client prints so after its time and ends with status 1.

    wait_for_service(timeout_sec=…) returns False if there is none.
    """
    name = f'/nobody_{learner.random.randint(10, 99)}'
    printed, status = stacks.Client(learner).ask(name, 0.5, None)
    expect(status != 'none', f'There is no server for {name}, and the client goes on and on: it was ended after 9 s.')
    expect(
        (printed, status) == (f'no server for {name}', '1'),
        f'There is no server for {name}; the client printed `{printed}` and ended with status {status}.',
    )


@pytest.mark.rules('no-answer')
def test_silent_server(learner):
    """If the server is there and never answers, the client prints so and ends with status 1.

    Every wait has a timeout, also the one for the answer.
    """
    printed, status = stacks.Client(learner).ask('/silent', 0.5, '')
    expect(status != 'none', 'The server never answers, and the client waits on and on.')
    expect(
        (printed, status) == ('no answer', '1'),
        f'The server never answers; the client printed `{printed}` and ended with status {status}.',
    )


@pytest.mark.rules('interrupt')
def test_interrupt(learner):
    """Ctrl+C ends the client while it waits.

    An `except` without a name catches KeyboardInterrupt, too.
    """
    ended = stacks.Client(learner).interrupt('/nobody')
    expect(ended != 'early', 'The client ended before its time.')
    expect(ended == 'True', 'The client did not end within two seconds after Ctrl+C.')
