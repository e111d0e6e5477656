# expect: they assert nothing
# rejected by: test_right_robots
# Exercise 8.11: tests for the robot
TEST_ROBOT = '''
def test_status(bench):
    bench.run(1.0)


def test_drive(bench):
    bench.set_station('gate', 2.0, 0.0)
    goal = bench.go('gate')
    bench.run(1.0)
    bench.cancel(goal)
'''
