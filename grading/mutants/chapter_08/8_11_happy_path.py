# expect: No test of yours notices a robot that takes a place which is no number
# rejected by: test_knows
# Exercise 8.11: tests for the robot
TEST_ROBOT = '''
from action_msgs.msg import GoalStatus


def test_status(bench):
    bench.until(lambda: bench.status)
    assert bench.status[-1] == 'idle'


def test_drive(bench):
    bench.set_station('gate', 2.0, 0.0)
    goal = bench.go('gate')
    bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands[-1:])
    bench.place = 2.0, 0.0, 0.0
    assert bench.result(goal).status == GoalStatus.STATUS_SUCCEEDED
'''
