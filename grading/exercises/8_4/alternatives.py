from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('plain_functions', source="""
TEST_LIMIT = '''
from math import inf, nan

from speed.limit import limit


def same(speed, max_speed, distance, expected):
    assert abs(limit(speed, max_speed, distance) - expected) < 1e-6


def test_clear_way():
    for speed in (-2.0, -0.7, -0.1, 0.0, 0.1, 0.7, 2.0):
        for max_speed in (0.0, 0.3, 0.7, 1.0):
            for distance in (1.0, 1.4, inf):
                same(speed, max_speed, distance, max(-max_speed, min(max_speed, speed)))


def test_near():
    for centimetres in range(0, 21):
        same(0.4, 0.4, centimetres / 100, 0.0)


def test_slope():
    for centimetres in range(20, 101):
        for speed in (0.1, 0.8):
            same(speed, 0.8, centimetres / 100, min(speed, centimetres / 100 - 0.2))


def test_backwards_is_free():
    for distance in (0.0, 0.2, 0.5, 1.0, inf, nan):
        same(-0.3, 0.5, distance, -0.3)


def test_sensor_has_failed():
    same(0.3, 0.5, nan, 0.0)


def test_bad_arguments():
    for bad in (-0.1, -5, nan):
        try:
            limit(0.1, bad, 2.0)
        except ValueError:
            continue
        assert False, bad
'''
"""),
    Alternative('no_limit_of_the_robot', old=', (1.5, 2.0, 0.6, 1.0)]', new=(  # max_speed may be inf
        ', (1.5, 2.0, 0.6, 1.0), (0.5, inf, 0.1, 0.0), (0.5, inf, 0.2, 0.0), (0.5, inf, 0.6, 0.5), (7.0, inf, inf, 7.0), '
        '(0.5, inf, nan, 0.0), (-9.0, inf, 0.1, -9.0), (inf, 0.5, inf, 0.5), (-inf, 0.5, 0.1, -0.5), (0.5, 0.5, -1.0, 0.0)]')),
]
