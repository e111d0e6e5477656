# expect: pytest found no test
# rejected by: test_right_functions
# Exercise 8.4: tests that find bugs
TEST_LIMIT = '''
from math import inf, nan

import pytest
from speed.limit import limit


def check_free():
    assert limit(0.3, 0.5, inf) == pytest.approx(0.3)


@pytest.mark.parametrize('speed, max_speed, distance, expected', [
    (0.9, 0.5, inf, 0.5), (-0.9, 0.5, inf, -0.5), (0.0, 0.5, inf, 0.0),    # never faster, both ways
    (0.5, 0.5, 1.0, 0.5), (0.5, 0.5, 1.5, 0.5),                            # free from 1 m on
    (0.5, 0.5, 0.2, 0.0), (0.5, 0.5, 0.1, 0.0), (0.5, 0.5, 0.0, 0.0),      # nothing from 0.2 m down
    (0.5, 0.5, 0.6, 0.25), (0.5, 0.5, 0.3, 0.0625), (0.5, 0.5, 0.8, 0.375),  # in proportion
    (0.1, 0.5, 0.6, 0.1),                                                  # a limit, no factor
    (-0.4, 0.5, 0.1, -0.4), (-0.4, 0.5, 0.6, -0.4),                        # backwards it does not matter
    (0.5, 0.5, nan, 0.0), (-0.4, 0.5, nan, -0.4),                          # the sensor has failed
    (0.5, 0.0, inf, 0.0), (1.5, 2.0, 0.6, 1.0)])                           # other limits
def check_limit(speed, max_speed, distance, expected):
    assert limit(speed, max_speed, distance) == pytest.approx(expected)


@pytest.mark.parametrize('max_speed', [-0.1, -inf, nan])
def check_bad_limit(max_speed):
    with pytest.raises(ValueError):
        limit(0.1, max_speed, 1.0)
'''
