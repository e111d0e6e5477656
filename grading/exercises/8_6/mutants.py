from grading.variants import Mutant

MUTANTS = [
    Mutant('always_in_the_origin',
           edits=(('1.0 + 2.0 * math.cos(yaw + angle), -2.0 +', '2.0 * math.cos(yaw + angle),'),
            ('steer(1.0, -2.0', 'steer(0.0, 0.0'),
            ('1.0, 0.0, distance, 1', '0.0, 0.0, distance, 0'),
            ('1.0, 2.0, 0.3, 1.0, 2', '0.0, 0.0, 0.3, 0.0, 0')), expect='that forgets where the robot is',
           breaks='places'),
    Mutant('exact_numbers',
           edits=(('assert (distance, turn) == pytest.approx((2.0, angular), abs=1e-6)',
                   'assert turn == pytest.approx(angular) and distance == math.hypot(goal[0] - 1.0, goal[1] + 2.0)'),),
           expect='A test of yours fails with a function', breaks='right-functions'),
    Mutant('exactly_at_the_border', old='def test_at_the_goal():', new="""
        @pytest.mark.parametrize('yaw', [0.0, 0.3, 1.0, 2.2])
        def test_border(yaw):
            there = 2 * math.cos(yaw + 0.5), 2 * math.sin(yaw + 0.5)
            assert steer(0.0, 0.0, yaw, *there, 0.5, 1.0)[1] == pytest.approx(0.5)


        def test_at_the_goal():
        """, expect='one that turns the world', breaks='right-functions'),
    Mutant('asks_for_a_plain_tuple', old='def test_at_the_goal():', new="""
        def test_tuple():
            assert type(steer(0.0, 0.0, 0.0, 3.0, 0.0, 0.5, 1.0)) is tuple


        def test_at_the_goal():
        """, expect='one that returns a named tuple', breaks='right-functions'),
    Mutant('happy_path', source="""
TEST_STEERING = '''
import math

import pytest
from delivery_robot.steering import steer


def test_straight_ahead():
    assert steer(0.0, 0.0, 0.0, 3.0, 0.0, 0.5, 1.0) == pytest.approx((3.0, 0.5, 0.0))
'''
""", expect='wrong functions: none of the', breaks='max-angular',
           also=('turns', 'short-way', 'speed', 'on-the-spot', 'places')),
    Mutant('never_near', old='), (0.5, 0.5), (0.1, 0.1), (0.0, 0.0)]', new=')]', expect='that does not slow down',
           breaks='speed'),
    Mutant('never_there', old='0, 0.3, 1.0', new='0, 0.0, 1.0', expect='that turns at the goal', breaks='places'),
    Mutant('never_to_the_right',
           old='(0.0, 0.0), (0.1, 0.2), (-0.1, -0.2), (0.4, 0.8), (-0.4, -0.8), (0.9, 1.5), (-0.9, -1.5), (3.0, 1.5), (-3.0, -1.5)])',
           new='(0.0, 0.0), (0.1, 0.2), (0.4, 0.8), (0.9, 1.5), (3.0, 1.5)])', expect='that has no limit to the right',
           breaks='max-angular', also=('short-way', 'on-the-spot', 'turns')),
    Mutant('loose_tolerance', old='pytest.approx((distance, linear, 0.0))', new='pytest.approx((distance, linear, 0.0), abs=0.8)',
           expect='that does not slow down', breaks='speed'),
    Mutant('needs_ros', old='import pytest', new="""
        import pytest
        import rclpy
        """, expect='Your tests import rclpy', breaks='no-ros'),
    Mutant('never_aside', old='(0.4, 0.8), (-0.4, -0.8), (0.9, 1.5), (-0.9, -1.5), (3.0, 1.5), (-3.0, -1.5)',
           new='(0.4, 0.8), (-0.4, -0.8)', expect='that drives while it looks away', breaks='on-the-spot',
           also=('max-angular', 'short-way')),
    Mutant('looks_along_x', edits=(("@pytest.mark.parametrize('yaw', [0.0, 1.5, 3.1, -3.1, 7.0])",
                                    "@pytest.mark.parametrize('yaw', [0.0])"),),
           expect='that turns the long way round', breaks='short-way', also='turns'),
    Mutant('only_the_sign_of_the_turn', edits=(
        ('assert (distance, turn) == pytest.approx((2.0, angular), abs=1e-6)',
         'assert distance == pytest.approx(2.0) and (abs(turn - angular) < 0.01 or abs(angle) < 0.5 and turn * angle >= 0)'),),
           expect='that always turns as fast as it may', breaks='turns', also='max-angular'),
    Mutant('only_full_turns', old='assert (distance, turn) == pytest.approx((2.0, angular), abs=1e-6)', new="""
        assert distance == pytest.approx(2.0)
        if abs(angular) in (0.0, 1.5):
            assert turn == pytest.approx(angular, abs=1e-6)
        else:
            assert 1.1 * abs(angle) < abs(turn) < 1.5
        """, expect='that turns with 3 times the angle', breaks='turns'),
    Mutant('zeros_to_the_letter', old='assert steer(1.0, 2.0, 0.3, 1.0, 2.0, 0.5, 1.0) == pytest.approx((0.0, 0.0, 0.0))',
           new="assert str(tuple(steer(1.0, 2.0, 0.3, 1.0, 2.0, 0.5, 1.0))) == '(0.0, 0.0, 0.0)'",
           expect='an int for each whole number', breaks='right-functions'),
    Mutant('asks_for_floats', old='def test_at_the_goal():', new="""
        @pytest.mark.parametrize('distance', [0.7, 2.0])
        def test_floats(distance):
            assert all(isinstance(one, float) for one in steer(0.0, 1.0, 0.0, distance, 1.0, 0.5, 1.0))


        def test_at_the_goal():
        """, expect='an int for each whole number', breaks='right-functions'),
    Mutant('only_small_and_great_angles',
           old='(0.0, 0.0), (0.1, 0.2), (-0.1, -0.2), (0.4, 0.8), (-0.4, -0.8), (0.9, 1.5), (-0.9, -1.5), (3.0, 1.5), (-3.0, -1.5)])',
           new='(0.0, 0.0), (0.1, 0.2), (-0.1, -0.2), (1.7, 1.5), (-1.7, -1.5), (3.0, 1.5), (-3.0, -1.5)])',
           expect='that turns on the spot from 0.15 rad on', breaks='on-the-spot'),
    Mutant('no_yaw_beyond_pi', old='[0.0, 1.5, 3.1, -3.1, 7.0]', new='[0.0, 1.5, 3.1, -3.1]',
           expect='after a whole turn, when its yaw is more than π', breaks='short-way'),
    Mutant('no_small_angles', old='(0.0, 0.0), (0.1, 0.2), (-0.1, -0.2), (0.4', new='(0.0, 0.0), (0.4',
           expect='when the goal is less than 0.25 rad aside', breaks='turns'),
    Mutant('slows_down_somehow',
           old='assert steer(0.0, 1.0, 0.0, distance, 1.0, 0.7, 1.0) == pytest.approx((distance, linear, 0.0))', new="""
        found = steer(0.0, 1.0, 0.0, distance, 1.0, 0.7, 1.0)
        assert found[0] == pytest.approx(distance) and found[1] <= linear + 1e-6 and found[2] == pytest.approx(0.0)
        """, expect='that slows down too early', breaks='speed'),
    Mutant('the_sign_of_a_zero', old='def test_at_the_goal():', new="""
        def test_no_turn():
            assert math.copysign(1.0, steer(0.0, 0.0, 0.0, 3.0, 0.0, 0.5, 1.0)[2]) == 1.0


        def test_at_the_goal():
        """, expect='A test of yours fails with a function', breaks='right-functions'),
    Mutant('only_the_side_of_large_turns', breaks='turns',
           old='assert (distance, turn) == pytest.approx((2.0, angular), abs=1e-6)', new="""
        assert distance == pytest.approx(2.0)
        if abs(angle) < 1.0:
            assert turn == pytest.approx(angular, abs=1e-6)
        else:
            assert 0.0 < turn / angular < 1.001
        """, expect='that turns slowly when the goal is behind it'),
]
