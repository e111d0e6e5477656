from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('drives_there', edits=(('''
            @pytest.mark.parametrize('angle, angular', [
                (0.0, 0.0), (0.1, 0.2), (-0.1, -0.2), (0.4, 0.8), (-0.4, -0.8), (0.9, 1.5), (-0.9, -1.5), (3.0, 1.5), (-3.0, -1.5)])
            @pytest.mark.parametrize('yaw', [0.0, 1.5, 3.1, -3.1, 7.0])
            def test_turns(yaw, angle, angular):
                goal = 1.0 + 2.0 * math.cos(yaw + angle), -2.0 + 2.0 * math.sin(yaw + angle)
                distance, linear, turn = steer(1.0, -2.0, yaw, *goal, 0.5, 1.5)
                assert (distance, turn) == pytest.approx((2.0, angular), abs=1e-6)
                assert linear == pytest.approx(0.5 if abs(angle) < 0.5 else 0.0)
            ''', '''
            def drive(x, y, yaw, goal, max_linear=0.4, max_angular=1.4, seconds=25):
                for _ in range(10 * seconds):
                    distance, linear, angular = steer(x, y, yaw, *goal, max_linear, max_angular)
                    assert distance == pytest.approx(math.dist((x, y), goal))
                    assert -1e-9 <= linear <= max_linear + 1e-9 and abs(angular) <= max_angular + 1e-9
                    x, y, yaw = x + 0.1 * linear * math.cos(yaw), y + 0.1 * linear * math.sin(yaw), yaw + 0.1 * angular
                return distance
            '''),
            ('''
            @pytest.mark.parametrize('distance, linear', [(5.0, 0.7), (0.8, 0.7), (0.5, 0.5), (0.1, 0.1), (0.0, 0.0)])
            def test_slows_down(distance, linear):
                assert steer(0.0, 1.0, 0.0, distance, 1.0, 0.7, 1.0) == pytest.approx((distance, linear, 0.0))
            ''', '''
            @pytest.mark.parametrize('yaw', [-9, 0.3, 2])
            @pytest.mark.parametrize('goal', [(1, 4), (-3, 0)])
            def test_arrives(yaw, goal):
                assert drive(1.0, 1.0, yaw, goal) < 0.05
            '''),
            ('''
            def test_at_the_goal():
                assert steer(1.0, 2.0, 0.3, 1.0, 2.0, 0.5, 1.0) == pytest.approx((0.0, 0.0, 0.0))
            ''', '''
            @pytest.mark.parametrize('side', [1, -1])
            def test_rule(side):
                for yaw in (0.0, 2.0, -7.5):
                    for angle, angular, linear in ((0.2, 0.4, 0.3), (0.45, 0.9, 0.3), (0.6, 1.2, 0.0), (2.0, 1.4, 0.0)):
                        goal = 1 + 0.3 * math.cos(yaw + side * angle), 2 + 0.3 * math.sin(yaw + side * angle)
                        assert steer(1, 2, yaw, *goal, 0.6, 1.4) == pytest.approx((0.3, linear, side * angular))
                assert steer(1, 2, side, 1, 2, 0.6, 1.4) == pytest.approx((0, 0, 0))
            '''))),
    Alternative('in_quotes', edits=(
        ('%%answer TEST_STEERING delivery_ws/src/delivery_robot/test/test_steering.py', "TEST_STEERING = '''"),
        ('assert steer(1.0, 2.0, 0.3, 1.0, 2.0, 0.5, 1.0) == pytest.approx((0.0, 0.0, 0.0))',
         "assert steer(1.0, 2.0, 0.3, 1.0, 2.0, 0.5, 1.0) == pytest.approx((0.0, 0.0, 0.0))'''"))),
]
