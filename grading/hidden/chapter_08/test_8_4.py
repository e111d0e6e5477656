"""Hidden tests of exercise 8.4, tests that find bugs: other right functions, and wrong ones in four groups."""

import pytest

from helpers.checks.chapter_08.limits import PARTS, variant
from helpers.checks.chapter_08.planted import NOTHING, accepts, rejects

pytestmark = pytest.mark.exercise('8.4')
RIGHT = {'the given one': variant()}
NOTHINGS = {'that returns nothing': variant(result=NOTHING)}


@pytest.mark.weight(3)
def test_right_functions(learner):
    """Your tests pass with every function that does what the docstring says, however it computes.

    Test what the docstring promises, and compare computed numbers with pytest.approx.
    """
    factor = learner.random.choice(['1.25 * distance - 0.25', '(5 * distance - 1) / 4', 'distance / 0.8 - 0.2 / 0.8'])
    accepts(learner, {
        'one that computes in another order': variant(share=f'    share = max(0.0, min(1.0, {factor}))\n'),
        'one with cases instead of a formula': variant(share='''\
    if distance >= 1.0:
        share = 1.0
    elif distance <= 0.2:
        return 0.0
    else:
        share = 1 - (1.0 - distance) / 0.8
'''),
        'one that says more in its error': variant(check='''\
    if max_speed < 0 or isnan(max_speed):
        raise ValueError(f'max_speed is {max_speed}')
''')}, wrong=NOTHINGS)


@pytest.mark.weight(2)
def test_limits(learner):
    """Your tests notice when max_speed is not kept, in either direction, or when it is not the limit.

    Faster than allowed, slower than allowed, forwards, backwards, and standing.
    """
    rejects(learner, {
        'that is too fast backwards': variant(back='    if speed <= 0:\n        return speed\n'),
        'that is too fast forwards where nothing is in the way': variant(
            result='    return speed if share == 1.0 else min(speed, max_speed * share)\n'),
        'that always drives as fast as it may': variant(result='    return max_speed * share\n'),
        'that drives forwards when told to drive backwards': variant(
            back='    if speed <= 0:\n        return min(-speed, max_speed)\n'),
        'for which max_speed is fixed': variant(
            check='    if not max_speed >= 0:\n        raise ValueError\n    max_speed = 0.5\n')}, right=RIGHT)


@pytest.mark.weight(3)
def test_obstacles(learner):
    """Your tests notice wrong distances, a jump instead of a slope, and a factor instead of a limit.

    Test at 0.2 m, at 1.0 m, and at some places in between; also with a speed below what is allowed there.
    """
    draw = learner.random
    far, near = draw.choice([1.5, 2.0]), draw.choice([0.3, 0.35])
    rejects(learner, {
        'that knows only full speed and standstill': variant(share='    share = 1.0 if distance > 0.2 else 0.0\n'),
        'that stops only at 0.0 m, in place of 0.2 m': variant(
            share='    share = max(0.0, min(1.0, distance))\n'),
        f'that is free only from {far:g} m on': variant(
            share=f'    share = max(0.0, min(1.0, (distance - 0.2) / ({far} - 0.2)))\n'),
        f'that stops already at {near:g} m': variant(
            share=f'    share = max(0.0, min(1.0, (distance - 0.2) / 0.8)) if distance > {near} else 0.0\n'),
        'that drives backwards when an obstacle is too near': variant(
            share='    share = min(1.0, (distance - 0.2) / 0.8)\n'),
        'that slows down a speed that is slow enough': variant(result='    return min(speed, max_speed) * share\n'),
        'whose slope is a curve': variant(share='    share = max(0.0, min(1.0, (distance - 0.2) / 0.8)) ** 2\n')},
            right=RIGHT)


@pytest.mark.weight(2)
def test_backwards(learner):
    """Your tests notice when an obstacle in front, or a failed sensor, holds back a robot that drives backwards.

    Drive backwards with each kind of distance.
    """
    rejects(learner, {
        'that slows down backwards, too': variant(
            back='    if speed <= 0 and distance >= 1.0:\n        return max(speed, -max_speed)\n',
            result='    return max(-max_speed * share, min(speed, max_speed * share))\n'),
        'that does not drive backwards when the sensor has failed': variant(
            back=PARTS['nan'], nan=PARTS['back'])}, right=RIGHT)


@pytest.mark.weight(2)
def test_special_values(learner):
    """Your tests notice when nan, inf or a bad max_speed is not treated as the docstring says.

    These are values as any others: give them to the function.
    """
    rejects(learner, {
        'that drives on when the sensor has failed': variant(nan='    if isnan(distance):\n        distance = inf\n'),
        'that stands when no obstacle is in sight': variant(
            nan='    if isnan(distance) or isinf(distance):\n        return 0.0\n'),
        'that accepts a negative max_speed': variant(check='    max_speed = abs(max_speed)\n'),
        'that accepts nan as max_speed': variant(
            check="    if max_speed < 0:\n        raise ValueError('max_speed must not be negative')\n"),
        'that refuses 0 as max_speed': variant(
            check="    if not max_speed > 0:\n        raise ValueError('max_speed must not be negative')\n")},
            right=RIGHT)
