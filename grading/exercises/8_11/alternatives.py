from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('functions_that_help', source="""
TEST_ROBOT = '''
from action_msgs.msg import GoalStatus


def off(bench):
    assert bench.set_station('lab', -1, 2).success
    goal = bench.go('lab')
    assert goal.accepted
    bench.until(lambda: len(bench.commands) > 3)
    bench.until(lambda: 'driving to lab' in bench.status)
    return goal


def ready(bench):
    bench.until(lambda: bench.status[-1] == 'idle')
    assert bench.commands[-1].linear.x == bench.commands[-1].angular.z == 0.0
    bench.place = 0, 0, 0
    bench.run(0.5)
    off(bench)


def test_arrives(bench):
    goal = off(bench)
    assert not bench.go('lab').accepted
    bench.place = -1, 1, 1.57
    bench.run(1.5)
    assert bench.commands[-1].linear.x > 0.2
    bench.place = -1, 1.97, 0
    assert bench.result(goal).result.distance < 0.1
    ready(bench)


def test_cancel(bench):
    goal = off(bench)
    bench.cancel(goal)
    assert bench.result(goal).status == GoalStatus.STATUS_CANCELED
    ready(bench)


def test_lost(bench):
    goal = off(bench)
    bench.place = None
    assert bench.result(goal).status == GoalStatus.STATUS_ABORTED
    ready(bench)


def test_refuses(bench):
    assert not bench.set_station('x', float('inf'), 0).success
    assert not bench.set_parameter('max_linear', 1.5)
    bench.set_parameter('max_linear', 0.3)
    assert not bench.go('x').accepted
'''
"""),
]
