"""Visible tests of exercise 4.3, one question, two sources."""

import pytest
from std_srvs.srv import Trigger

from helpers.runner import expect

pytestmark = pytest.mark.exercise('4.3')


def test_example(learner):
    """Both parts are asked, and the status holds both answers.

    An async callback may await an answer, if the client has a callback group of its own.
    """
    battery = learner.serve('/battery/check', Trigger, {'success': True, 'message': '81 %'})
    lidar = learner.serve('/lidar/check', Trigger, {'success': False, 'message': 'blocked'})
    status = learner.client('/status', Trigger)
    learner.start('StatusPanel')
    call = status.send()
    learner.settle()
    expect(battery.requests, 'status was called, and battery/check was not asked.')
    expect(call.done or lidar.requests,
           'battery/check has answered; then nothing happened any more: the answer is never taken. It waits in a '
           'callback group in which your callback still runs.')
    expect(lidar.requests, 'status was answered, and lidar/check was not asked.')
    expect(call.done, 'Both parts have answered, and status has not: the answers are never taken. They wait in a '
                      'callback group in which your callback still runs.')
    expect(not call.response.success, 'The lidar has no success, but the status has.')
    expect(call.response.message == 'battery: 81 %; lidar: blocked',
           f"The message is {call.response.message!r}, expected 'battery: 81 %; lidar: blocked'.")


def test_all_well(learner):
    """If both parts have success, the status has it, too.

    success is a field of the response.
    """
    for part in ('battery', 'lidar'):
        learner.serve(f'/{part}/check', Trigger, {'success': True, 'message': 'fine'})
    learner.start('StatusPanel')
    answer = learner.client('/status', Trigger).call(timeout=1.0)
    expect(answer.success, 'Both parts have success, the status has not.')
