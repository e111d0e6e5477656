"""Which name is meant: the same in other letters, a similar one, or none."""

import pytest

from helpers.runner import similar

THERE = ['sendTransform', 'max_range', 'min_range', 'Twist', '_max_rangee']


@pytest.mark.parametrize(
    ('name', 'meant'),
    [
        ('send_transform', 'sendTransform'),
        ('maxrange', 'max_range'),
        ('max_rang', 'max_range'),
        ('twist', ''),  # a variable, and not the class
        ('Twst', 'Twist'),
        ('speed', ''),
        ('', ''),
    ],
)
def test_the_nearest_name(name, meant):
    assert similar.nearest(name, THERE) == meant


def test_what_would_take_long_is_not_looked_at():
    long = 'a' * (similar.MOST_LETTERS + 1)
    assert similar.nearest(long, [long]) == similar.nearest('a', [long, '']) == ''
    many = [f'a{number:05}' for number in range(similar.MOST_NAMES)]
    assert similar.nearest('b_far', [*many, 'b_fur']) == ''
    assert similar.nearest('b_far', [*many[1:], 'b_fur']) == 'b_fur'
