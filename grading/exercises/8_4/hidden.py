"""Hidden tests of exercise 8.4, tests that find bugs: other right functions, and other wrong ones of each kind."""

import pytest

from helpers.checks.chapter_08.limits import BAD, NOTHINGS, PARTS, variant
from helpers.checks.chapter_08.noticed import Kind, Planted
from helpers.checks.chapter_08.planted import LIMIT

pytestmark = pytest.mark.exercise('8.4')
RIGHT = {
    'the given one': variant(),
    'one that computes in another order': variant(share='    share = max(0.0, min(1.0, 1.25 * distance - 0.25))\n'),
    'one with cases instead of a formula': variant(
        share="""\
    if distance >= 1.0:
        share = 1.0
    elif distance <= 0.2:
        return 0.0
    else:
        share = (distance - 1.0) / 0.8 + 1
"""
    ),
    'one that returns numbers of numpy': variant(
        result='    from numpy import float64\n    return float64(min(speed, max_speed * share) if share else 0.0)\n',
        nan='    if isnan(distance):\n        return 0\n',
    ),
    'one that computes the speed, and no share, and takes a speed that is nan for any speed': variant(
        share='    share = distance > 0.2\n',
        result="""\
    allowed = max_speed if distance >= 1.0 else max_speed * (distance - 0.2) / (1.0 - 0.2)
    return min(allowed, speed) if share else 0.0
""",
    ),
    'one that says more in its error': variant(
        check="""\
    if max_speed < 0 or isnan(max_speed):
        raise ValueError(f'max_speed is {max_speed}')
"""
    ),
}
KINDS = (
    Kind(
        'max-speed',
        'that do not keep max_speed',
        {
            'that returns the speed as it is when the way is free': variant(
                result='    return speed if distance > 1.0 else min(speed, max_speed * share)\n'
            ),
            'that drives forwards when told to drive backwards': variant(
                back='    if speed <= 0:\n        return min(-speed, max_speed)\n'
            ),
            'that is never slower than max_speed backwards': variant(
                back='    if speed < 0:\n        return -max_speed\n'
            ),
            'for which max_speed is at most 0.6': variant(
                result='    return min(speed, min(0.6, max_speed) * share)\n'
            ),
        },
    ),
    Kind(
        'borders',
        'that have wrong borders of the distance',
        {
            'that is free only from 2 m on': variant(share='    share = max(0.0, min(1.0, (distance - 0.2) / 1.8))\n'),
            'that is free from 0.8 m on': variant(share='    share = max(0.0, min(1.0, (distance - 0.2) / 0.6))\n'),
            'that stops already at 0.3 m': variant(
                share='    share = max(0.0, min(1.0, (distance - 0.2) / 0.8)) if distance > 0.3 else 0.0\n'
            ),
            'that only slows down, and never stands': variant(
                share='    share = max(0.05, min(1.0, (distance - 0.2) / 0.8))\n'
            ),
        },
    ),
    Kind(
        'slope',
        'that are wrong between 0.2 m and 1.0 m',
        {
            'that drives with half of the speed in between': variant(
                share='    share = 1.0 if distance >= 1.0 else 0.5 if distance > 0.2 else 0.0\n'
            ),
            'that slows down a speed that is slow enough': variant(result='    return min(speed, max_speed) * share\n'),
            'whose slope is a root': variant(share='    share = max(0.0, min(1.0, (distance - 0.2) / 0.8)) ** 0.5\n'),
        },
    ),
    Kind(
        'backwards',
        'that hold back a robot that drives backwards',
        {
            'that stands when an obstacle is near, also backwards': variant(
                back='    if speed <= 0:\n        return 0.0 if distance <= 0.2 else max(speed, -max_speed)\n'
            ),
            'that slows down backwards, too': variant(
                back='    if speed <= 0 and not distance < 1.0:\n        return max(speed, -max_speed)\n',
                result='    return max(-max_speed * share, min(speed, max_speed * share))\n',
            ),
            'that does not drive backwards when the sensor has failed': variant(back=PARTS['nan'], nan=PARTS['back']),
        },
    ),
    Kind(
        'sensor',
        'that treat nan or inf as distance in the wrong way',
        {
            'that returns nan when the sensor has failed': variant(
                nan='    if isnan(distance):\n        return distance\n'
            ),
            'that drives slowly when the sensor has failed': variant(
                nan='    if isnan(distance):\n        distance = 0.4\n'
            ),
            'that stands when no obstacle is in sight': variant(
                nan='    if isnan(distance) or isinf(distance):\n        return 0.0\n'
            ),
        },
    ),
    Kind(
        'bad-max-speed',
        'that take a bad max_speed, refuse it with another error, or refuse a good one',
        {
            'that stands if max_speed is negative': variant(
                check=f'    if max_speed < 0:\n        return 0.0\n    if isnan(max_speed):\n    {BAD}'
            ),
            'that accepts nan as max_speed': variant(check=f'    if max_speed < 0:\n    {BAD}'),
            'that refuses 0 as max_speed': variant(check=f'    if not max_speed > 0:\n    {BAD}'),
            'that asserts that max_speed is good': variant(check='    assert max_speed >= 0\n'),
        },
    ),
)
HIDDEN = Planted(LIMIT, 'right-functions', RIGHT, NOTHINGS, KINDS)


@pytest.mark.given
@pytest.mark.rules('right-functions', 'no-ros')
@pytest.mark.weight(3)
def test_right_functions(learner):
    """Your tests pass with every function that does what the docstring says, however it computes."""
    HIDDEN.accepts(learner)


@pytest.mark.rules('max-speed', 'right-functions')
@pytest.mark.weight(2)
def test_limits(learner):
    """Your tests notice when max_speed is not kept, in either direction, or when it is not the limit."""
    HIDDEN.rejects(learner, 'max-speed')


@pytest.mark.rules('borders')
@pytest.mark.weight(2)
def test_obstacles(learner):
    """Your tests notice wrong borders of the distance."""
    HIDDEN.rejects(learner, 'borders')


@pytest.mark.rules('slope')
@pytest.mark.weight(2)
def test_slope(learner):
    """Your tests notice a jump instead of a slope, and a factor instead of a limit."""
    HIDDEN.rejects(learner, 'slope')


@pytest.mark.rules('backwards')
@pytest.mark.weight(2)
def test_backwards(learner):
    """Your tests notice when an obstacle in front, or a failed sensor, holds back a robot that drives backwards."""
    HIDDEN.rejects(learner, 'backwards')


@pytest.mark.rules('sensor')
def test_special_values(learner):
    """Your tests notice when nan or inf is not treated as the docstring says."""
    HIDDEN.rejects(learner, 'sensor')


@pytest.mark.rules('bad-max-speed')
def test_bad_max_speed(learner):
    """Your tests notice when a bad max_speed is taken, or a good one refused."""
    HIDDEN.rejects(learner, 'bad-max-speed')
