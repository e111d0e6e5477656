# expect: No test of yours notices a function that is too fast backwards
# rejected by: test_limits
# Exercise 8.4: tests that find bugs
TEST_LIMIT = '''
from math import inf, nan

import pytest
from speed.limit import limit


def test_free():
    assert limit(0.3, 0.5, inf) == pytest.approx(0.3)


'''
