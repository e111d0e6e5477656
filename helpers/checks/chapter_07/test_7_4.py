"""Visible tests of exercise 7.4, a program that stands still."""

import pytest

from helpers.checks.chapter_07 import stacks
from helpers.checks.chapter_07.findings import compare
from helpers.runner import expect

pytestmark = pytest.mark.exercise('7.4')


def test_a_call_in_a_callback(learner):
    """A thread that stands in `call` of rclpy, in a callback, is found; the main thread, which spins, is healthy.

    Its own call is its newest one in one of the files.
    """
    text, files, expected = stacks.draw(learner.random, 'call', 'spinning')
    compare(learner.call('diagnose_stacks', text, files), expected, stacks.WHY)


def test_no_server(learner):
    """Without a server, the client prints so after its time and ends with status 1.

    wait_for_service(timeout_sec=…) returns False if there is none.
    """
    printed, status = stacks.Client(learner).ask('/nobody', 0.5, None)
    expect(status != 'none', 'The client goes on and on: it was ended after 9 s.')
    expect((printed, status) == ('no server for /nobody', '1'),
           f'The client printed `{printed}` and ended with status {status}.')
