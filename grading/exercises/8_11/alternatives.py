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
    Alternative('classes_of_the_cards', old='def test_refused(bench):', new="""
        @pytest.fixture
        def keeper():
            rclpy.init()
            yield StationKeeper()
            rclpy.shutdown()


        def test_keeper(keeper):
            assert keeper.place('nowhere') is None
            assert keeper.get_parameter('tolerance').value == pytest.approx(0.1)
            assert keeper.state == 'idle'


        def test_courier(bench):
            assert issubclass(DeliveryRobot, Courier) and issubclass(Courier, StationKeeper)
            assert isinstance(bench.robot, Courier)
            bench.run(0.2)
            assert Courier.where(bench.robot) == pytest.approx((0.0, 0.0, 0.0))


        def test_refused(bench):
        """, edits=(('import pytest', """
        import pytest
        import rclpy
        """), ('from action_msgs.msg import GoalStatus', """
        from action_msgs.msg import GoalStatus
        from delivery_robot.robot import Courier, DeliveryRobot, StationKeeper
        """))),
    Alternative('within_the_time_of_a_cancel', old='def test_refused(bench):', new="""
        def test_called_back_at_once(bench):
            bench.set_station('gate', 2.0, 0.0)
            goal = bench.go('gate')
            bench.cancel(goal)
            assert bench.result(goal, 0.3).status == GoalStatus.STATUS_CANCELED


        def test_refused(bench):
        """),
    Alternative('each_class_by_itself', edits=(("""
        assert not bench.set_station('dock', nan, 0.0).success
        assert not bench.set_parameter('max_linear', 7.0)
        """, ''), ('def test_refused(bench):', """
        @pytest.fixture
        def made():
            rclpy.init()
            yield lambda kind: kind(parameter_overrides=[Parameter('status_period', value=0.1)])
            rclpy.shutdown()


        def spin_until(node, condition):
            for _ in range(100):
                if condition():
                    break
                rclpy.spin_once(node, timeout_sec=0.1)
            assert condition()


        def test_keeper(made):
            keeper, said = made(StationKeeper), []
            keeper.create_subscription(String, 'status', lambda message: said.append(message.data), 10)
            spin_until(keeper, lambda: 'idle' in said)
            keeper.state = 'driving to nowhere'
            spin_until(keeper, lambda: keeper.state in said)
            assert not keeper.set_parameters([Parameter('max_linear', value=7.0)])[0].successful
            request = SetStation.Request(name='dock', x=nan)
            assert not keeper.on_set_station(request, SetStation.Response()).success


        def test_courier(made):
            courier, told = made(Courier), []
            courier.create_subscription(Twist, 'cmd_vel', told.append, 10)
            assert courier.where() is None
            courier.drive(0.2, 0.0)
            spin_until(courier, lambda: told)


        def test_refused(bench):
        """), ('import pytest', """
        import pytest
        import rclpy
        """), ('from action_msgs.msg import GoalStatus', """
        from action_msgs.msg import GoalStatus
        from delivery_interfaces.srv import SetStation
        from delivery_robot.robot import Courier, StationKeeper
        from geometry_msgs.msg import Twist
        from rclpy.parameter import Parameter
        from std_msgs.msg import String
        """), ("bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands)",
               'bench.until(lambda: bench.commands)'))),
]
