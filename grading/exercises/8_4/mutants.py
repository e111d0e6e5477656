from grading.variants import Mutant

MUTANTS = [
    Mutant('exact_numbers', old='pytest.approx(expected)', new='expected',
           expect='Compare computed numbers with pytest.approx', breaks='right-functions'),
    Mutant('happy_path', source="""
TEST_LIMIT = '''
from math import inf, nan

import pytest
from speed.limit import limit


def test_free():
    assert limit(0.3, 0.5, inf) == pytest.approx(0.3)


'''
""", expect='none of the 3 that hold back', breaks='backwards',
           also=('max-speed', 'borders', 'slope', 'sensor', 'bad-max-speed')),
    Mutant('needs_ros', old='import pytest', new='''
        import pytest
        import rclpy
        ''', expect='Your tests import rclpy', breaks='no-ros'),
    Mutant('needs_a_message', old='import pytest', new='''
        import pytest
        from geometry_msgs.msg import Twist
        ''', expect='Your tests import geometry_msgs', breaks='no-ros'),
    Mutant('no_negative_max_speed', old='[-0.1, -inf, nan]', new='[nan]', breaks='bad-max-speed',
           expect='that accepts a negative max_speed'),
    Mutant('no_assert', source="""
TEST_LIMIT = '''
from math import inf, nan

import pytest
from speed.limit import limit


@pytest.mark.parametrize('speed', [0.9, -0.9, 0.1])
@pytest.mark.parametrize('distance', [inf, nan, 0.1, 0.2, 0.6, 1.0])
def test_limit(speed, distance):
    limit(speed, 0.5, distance) == pytest.approx(0.5)
'''
""", expect='they assert nothing', breaks='right-functions',
           also=('max-speed', 'borders', 'slope', 'backwards', 'sensor', 'bad-max-speed')),
    Mutant('no_place_in_between', edits=(('''
            (0.5, 0.5, 0.6, 0.25), (0.5, 0.5, 0.3, 0.0625), (0.5, 0.5, 0.8, 0.375),  # in proportion
            (0.1, 0.5, 0.6, 0.1),                                                  # a limit, no factor
            ''', ''),
            ('), (1.5, 2.0, 0.6, 1.0)]', ')]')), expect='that knows only full speed and standstill', breaks='slope',
           also=('borders', 'max-speed')),
    Mutant('no_special_values',
           old='(0.5, 0.5, nan, 0.0), (-0.4, 0.5, nan, -0.4),                          # the sensor has failed',
           new='', expect='that drives on when the sensor has failed', breaks='sensor', also='backwards'),
    Mutant('only_forwards', old='''
        (-0.4, 0.5, 0.1, -0.4), (-0.4, 0.5, 0.6, -0.4),                        # backwards it does not matter
        (0.5, 0.5, nan, 0.0), (-0.4, 0.5, nan, -0.4),                          # the sensor has failed
        ''', new='(0.5, 0.5, nan, 0.0),                          # the sensor has failed',
           expect='that slows down backwards, too', breaks='backwards', also='max-speed'),
    Mutant('text_of_the_error', old='(ValueError):', new="(ValueError, match='^max_speed must not be negative$'):",
           expect='for nothing that is not in the docstring', breaks='right-functions'),
    Mutant('only_one_limit', edits=(
        ('(0.9, 0.5, inf, 0.5), (-0.9, 0.5, inf, -0.5), (0.0, 0.5, inf, 0.0),    # never faster, both ways', '(0.0, 0.5, inf, 0.0),'),
        (', (1.5, 2.0, 0.6, 1.0)]', ']')), expect='that do not keep max_speed', breaks='max-speed'),
    Mutant('no_borders', old="""
        (0.5, 0.5, 1.0, 0.5), (0.5, 0.5, 1.5, 0.5),                            # free from 1 m on
        (0.5, 0.5, 0.2, 0.0), (0.5, 0.5, 0.1, 0.0), (0.5, 0.5, 0.0, 0.0),      # nothing from 0.2 m down
        (0.5, 0.5, 0.6, 0.25), (0.5, 0.5, 0.3, 0.0625), (0.5, 0.5, 0.8, 0.375),  # in proportion
        """, new='(0.5, 0.5, 0.6, 0.25),', expect='that have wrong borders of the distance', breaks='borders',
           also='slope'),
    Mutant('no_errors', old="""
        @pytest.mark.parametrize('max_speed', [-0.1, -inf, nan])
        def test_bad_limit(max_speed):
            with pytest.raises(ValueError):
                limit(0.1, max_speed, 1.0)
        """, new='', expect='that take a bad max_speed', breaks='bad-max-speed'),
    Mutant('asks_for_a_float', old='assert limit(speed, max_speed, distance) == pytest.approx(expected)', new='''
        assert limit(speed, max_speed, distance) == pytest.approx(expected)
        assert isinstance(limit(speed, max_speed, distance), float)
        ''', expect='one whose zeros are integers', breaks='right-functions'),
    Mutant('backwards_at_the_limit_only', old="""
        (-0.4, 0.5, 0.1, -0.4), (-0.4, 0.5, 0.6, -0.4),                        # backwards it does not matter
        (0.5, 0.5, nan, 0.0), (-0.4, 0.5, nan, -0.4),                          # the sensor has failed
        """, new="""
        (-0.9, 0.5, 0.1, -0.5), (-0.9, 0.5, 0.6, -0.5),                        # backwards it does not matter
        (0.5, 0.5, nan, 0.0), (-0.9, 0.5, nan, -0.5),                          # the sensor has failed
        """, expect='that always drives backwards as fast as it may', breaks='max-speed'),
    Mutant('any_error', old='pytest.raises(ValueError)', new='pytest.raises(Exception)', breaks='bad-max-speed',
           expect='that raises TypeError for a bad max_speed'),
    Mutant('no_direction', old='assert limit(speed, max_speed, distance) == pytest.approx(expected)',
           new='assert abs(limit(speed, max_speed, distance)) == pytest.approx(abs(expected))', breaks='max-speed',
           expect='that drives forwards when it is told to drive backwards'),
    Mutant('small_limits_only', old='(0.5, 0.0, inf, 0.0), (1.5, 2.0, 0.6, 1.0)]', new='(0.5, 0.0, inf, 0.0), (0.5, 0.4, inf, 0.4)]',
           breaks='max-speed', expect='for which max_speed is at most 0.6'),
    Mutant('no_forward_drive_when_it_failed', edits=(('(0.5, 0.5, nan, 0.0), (-0.4', '(-0.4'), ('def test_free():', """
        def test_failed_sensor():
            assert not limit(0.5, 0.5, nan) > 0


        def test_free():
        """)), breaks='sensor', expect='that returns nan when the sensor has failed'),
    Mutant('one_exact_number', old="@pytest.mark.parametrize('max_speed', [-0.1, -inf, nan])", new="""
        def test_in_between():
            assert limit(1.0, 1.0, 0.7) == (0.7 - 0.2) / 0.8


        @pytest.mark.parametrize('max_speed', [-0.1, -inf, nan])
        """, expect='Compare computed numbers with pytest.approx', breaks='right-functions'),
    Mutant('a_speed_that_is_nan', old="@pytest.mark.parametrize('max_speed', [-0.1, -inf, nan])", new="""
        def test_no_speed():
            assert not limit(nan, 0.5, 0.5) >= 0


        @pytest.mark.parametrize('max_speed', [-0.1, -inf, nan])
        """, expect='for nothing that is not in the docstring', breaks='right-functions'),
    Mutant('an_error_that_nobody_expects', old="@pytest.mark.parametrize('max_speed', [-0.1, -inf, nan])", new="""
        def test_negative():
            assert limit(0.1, -1.0, 1.0) == pytest.approx(0.0)


        @pytest.mark.parametrize('max_speed', [-0.1, -inf, nan])
        """, expect='for nothing that is not in the docstring', breaks='right-functions'),
]
