# expect: No test of yours notices
# rejected by: test_limits
# Exercise 8.4: tests that find bugs
TEST_LIMIT = '''
from math import inf, nan

import pytest
from speed.limit import limit


@pytest.mark.parametrize('speed', [0.9, -0.9, 0.1])
@pytest.mark.parametrize('distance', [inf, nan, 0.1, 0.2, 0.6, 1.0])
def test_limit(speed, distance):
    limit(speed, 0.5, distance) == pytest.approx(0.5)
'''
