# expect: A test of yours fails with a robot that does what its specification says
# rejected by: test_ends
# Exercise 8.11: tests for the robot
TEST_ROBOT = '''
from math import nan

import pytest
from action_msgs.msg import GoalStatus


def test_status(bench):
    bench.until(lambda: bench.status)
    assert bench.status[-1] == 'Idle'


def test_refused(bench):
    assert not bench.set_station('dock', nan, 0.0).success
    assert not bench.set_parameter('max_linear', 7.0)
    assert not bench.go('moon').accepted


@pytest.mark.parametrize('end, place', [
    ('SUCCEEDED', (2.0, 0.0, 0.0)), ('CANCELED', (0.0, 0.0, 0.0)), ('ABORTED', None)])
def test_drive(bench, end, place):
    bench.set_station('gate', 2.0, 0.0)
    goal = bench.go('gate')
    assert not bench.go('gate').accepted
    bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands[-1:])
    assert bench.commands[-1].linear.x > 0
    bench.run(1.0)
    bench.place = place
    if end == 'CANCELED':
        bench.cancel(goal)
    assert bench.result(goal).status == getattr(GoalStatus, f'STATUS_{end}')
    bench.until(lambda: bench.commands[-1].linear.x == 0)
    bench.place = 0.0, 0.0, 0.0
    bench.run(0.2)
    assert bench.go('gate').accepted
'''
