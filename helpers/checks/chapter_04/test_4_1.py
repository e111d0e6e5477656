"""Visible tests of exercise 4.1, a patient client."""

import pytest
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool

from helpers.runner import expect

pytestmark = pytest.mark.exercise('4.1')


def gripper(learner, answer, **options):
    states, close = learner.listen('/gripper_state', String), learner.talk('/close', Bool)
    server = learner.serve('/set_gripper', SetBool, answer, **options)
    learner.start('GripperClient')
    return states, close, server


def test_answered(learner):
    """A command makes one request with the same data, and the answer is reported as ok.

    Send the request in the callback of close, and report in a done-callback of its future.
    """
    states, close, server = gripper(learner, {'success': True})
    learner.run(0.3)
    close.send(Bool(data=True))
    learner.run(0.5)
    expect(server.requests, 'A command came on /close, and no request came to the service set_gripper.')
    expect(server.requests[0].data is True, 'close said True, but the request says False: send the same data.')
    expect(states.data == ['ok'], f'The server answered with success=True; gripper_state says {states.data}, expected '
                                  "['ok'].")


def test_silent_server(learner):
    """A silent server is asked 3 times, a second apart, and then the report is failed.

    A timer with the period `timeout` tells when an answer is overdue.
    """
    states, close, server = gripper(learner, None)
    learner.run(2.0)
    close.send(Bool(data=True))
    learner.run(4.5)
    expect(server.stamps, 'A command came on /close, and no request came to the service set_gripper.')
    expect(server.stamps[0] == 2.0, f'The first request came at {server.stamps[0]} s, the command at 2 s: send it at '
                                    'once.')
    expect(server.stamps == pytest.approx([2, 3, 4]),
           f'A command at 2 s made requests at {server.stamps} s, expected at 2, 3 and 4 s.')
    expect(states.data == ['failed'], f'Three requests without an answer gave {states.data}, expected [\'failed\'].')
    expect(states.stamps == pytest.approx([5]), f'failed came at {states.stamps} s, expected at 5 s: the third request '
                                                'has its second, too.')


def test_refused(learner):
    """An answer without success is reported as refused.

    Look at future.result().success.
    """
    states, close, _ = gripper(learner, {'success': False, 'message': 'too hot'})
    close.send(Bool(data=True))
    learner.run(0.5)
    expect(states.data == ['refused'], f'The server refused; gripper_state says {states.data}, expected [\'refused\'].')
