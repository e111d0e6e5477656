"""Visible tests of exercise 8.2, a governor."""

import pytest
from geometry_msgs.msg import Twist

from helpers.checks.chapter_08.parameters import Parameters
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.2')


def command(linear: float, angular: float = 0.0) -> Twist:
    message = Twist()
    message.linear.x, message.angular.z = linear, angular
    return message


def test_limit(learner):
    """A command of 1.0 m/s comes out as 0.5 m/s, ten times a second.

    A timer with the period 1 / rate publishes the newest command, limited to max_linear.
    """
    heard = learner.listen('/cmd_vel', Twist)
    talker = learner.talk('/cmd_vel_in', Twist)
    learner.start('Governor')
    talker.send(command(1.0, 0.3))
    learner.run(1.05)
    expect(heard.messages, 'Nothing came on /cmd_vel in 1 s.')
    expect(heard.stamps == pytest.approx([n / 10 for n in range(1, 11)]),
           f'The messages came at {heard.stamps} s, expected every 0.1 s.')
    expect(heard.messages[-1] == command(0.5, 0.3), f'linear.x is {heard.messages[-1].linear.x:g} and angular.z '
                                                    f'{heard.messages[-1].angular.z:g}, expected 0.5 and 0.3.')


def test_refused(learner):
    """A negative max_linear, and a mode that is not known, are refused.

    Bounds stand in the descriptor; the mode needs a callback that checks.
    """
    learner.start('Governor')
    parameters = Parameters(learner)
    for values in ({'max_linear': -0.1}, {'mode': 'fast'}):
        answer = parameters.set(**values)
        expect(not answer.successful, f'{values} was accepted.')
    expect('mode' in answer.reason, f'The mode fast was refused with the reason {answer.reason!r}, which does not '
                                    'name the parameter.')
    expect(parameters.set(mode='slow').successful, 'The mode slow was refused.')


def test_rule(learner):
    """slow_linear is never above max_linear; both can be changed at once.

    Judge the values as they would be: the present ones, with those of the request in their place.
    """
    learner.start('Governor')
    parameters = Parameters(learner)
    answer = parameters.set(max_linear=0.1)
    expect(not answer.successful, 'max_linear 0.1 was accepted, and slow_linear is 0.2.')
    expect(parameters.set(max_linear=0.1, slow_linear=0.05).successful,
           'max_linear 0.1 and slow_linear 0.05, set together, were refused. They fit each other.')
