"""Visible tests of exercise 4.4, find the bugs."""

import pytest
from std_srvs.srv import SetBool, Trigger

from helpers.runner import expect

pytestmark = pytest.mark.exercise('4.4')


def test_welcome_and_full(learner):
    """Two people come in, the third is told that the room is full.

    Who never gets an answer: the guard, or the client of the lock?
    """
    lock = learner.serve('/lock', SetBool, {'success': True})
    learner.start('DoorGuard')
    enter = learner.client('/enter', Trigger)
    for number, wanted in enumerate([(True, 'welcome'), (True, 'welcome'), (False, 'full')], 1):
        call = enter.send()
        learner.run(0.2)
        expect(lock.requests, 'enter was called, and the lock was not asked.')
        expect(call.done, 'The lock has opened, and enter was never answered: the answer of the lock waits in a '
                          'callback group in which your callback still runs.')
        got = (call.response.success, call.response.message)
        expect(got == wanted, f'Person {number} gets {got}, expected {wanted}.')


def test_leave(learner):
    """Who leaves makes room for another one.

    leave is not broken; its callback group matters.
    """
    learner.serve('/lock', SetBool, {'success': True})
    learner.start('DoorGuard', 1)
    enter, leave = learner.client('/enter', Trigger), learner.client('/leave', Trigger)
    told = []
    for client in (enter, enter, leave, enter):
        told.append(client.call(timeout=0.5).success)
    expect(told == [True, False, True, True],
           f'With the capacity 1, enter, enter, leave, enter gave {told}, expected [True, False, True, True].')
