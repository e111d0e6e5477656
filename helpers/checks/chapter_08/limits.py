"""Functions for exercise 8.4: how fast a robot may drive. Right and wrong ones, made from one text."""

from helpers.checks.chapter_08.noticed import Kind, Planted
from helpers.checks.chapter_08.planted import LIMIT, NOTHING

HEAD = """\
from math import inf, isinf, isnan


def limit(speed, max_speed, distance):
"""
PARTS = {
    'check': """\
    if not max_speed >= 0:
        raise ValueError('max_speed must not be negative')
""",
    'back': """\
    if speed <= 0:
        return max(speed, -max_speed)
""",
    'nan': """\
    if isnan(distance):
        return 0.0
""",
    'share': """\
    share = max(0.0, min(1.0, (distance - 0.2) / 0.8))
""",
    'result': """\
    return min(speed, max_speed * share) if share else 0.0
""",
}


def variant(**parts: str) -> str:
    """The right function, with these parts in place of its own; an empty text leaves a part out."""
    return HEAD + ''.join({**PARTS, **parts}.values())


BAD = "    raise ValueError('max_speed must not be negative')\n"
NOTHINGS = {'that returns nothing': variant(result=NOTHING)}
RIGHT = {
    'the given one': variant(),
    'one that computes in another order': variant(share='    share = max(0.0, min(1.0, distance / 0.8 - 0.2 / 0.8))\n'),
    'one that multiplies before it divides': variant(share='    share = max(0.0, min(1.0, (5 * distance - 1) / 4))\n'),
    'one that computes from 1.0 m down': variant(share='    share = max(0.0, min(1.0, 1 - (1.0 - distance) / 0.8))\n'),
    'one whose numbers between 0.2 m and 1.0 m differ in the last digit': variant(
        share=f'{PARTS["share"]}    share *= 1 - 1e-15 if share < 1.0 else 1\n'
    ),
    'one whose error has another text': variant(check='    if not max_speed >= 0:\n        raise ValueError\n'),
    'one that makes something else of a speed that is nan': variant(
        back='    if not speed > 0:\n        return max(-max_speed, speed) if speed <= 0 else 0.0\n'
    ),
    'one whose zeros are integers': variant(
        nan='    if isnan(distance) or distance <= 0.2:\n        return 0\n',
        back='    if speed <= 0:\n        return max(speed, -max_speed) or 0\n',
    ),
}
KINDS = (
    Kind(
        'max-speed',
        'that do not keep max_speed',
        {
            'that returns the speed as it is': variant(
                check='', back='', nan='', share='', result='    return speed\n'
            ),
            'that is too fast backwards': variant(back='    if speed <= 0:\n        return speed\n'),
            'that always drives backwards as fast as it may': variant(
                back='    if speed < 0:\n        return -max_speed\n'
            ),
            'that drives forwards when it is told to drive backwards': variant(
                back='    if speed <= 0:\n        return min(-speed, max_speed)\n'
            ),
            'that is too fast where nothing is in the way': variant(
                result='    return speed if share == 1.0 else min(speed, max_speed * share)\n'
            ),
            'that always drives as fast as it may': variant(result='    return max_speed * share\n'),
            'for which max_speed is always 0.5': variant(
                check='    if not max_speed >= 0:\n        raise ValueError\n    max_speed = 0.5\n'
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
            'that only slows down, and never stands': variant(
                share='    share = max(0.1, min(1.0, (distance - 0.2) / 0.8))\n'
            ),
            'that stops only at 0.0 m': variant(share='    share = max(0.0, min(1.0, distance))\n'),
            'that is free only from 1.5 m on': variant(
                share='    share = max(0.0, min(1.0, (distance - 0.2) / 1.3))\n'
            ),
            'that stops already at 0.35 m': variant(
                share='    share = max(0.0, min(1.0, (distance - 0.2) / 0.8)) if distance > 0.35 else 0.0\n'
            ),
            'that drives backwards when an obstacle is too near': variant(
                share='    share = min(1.0, (distance - 0.2) / 0.8)\n'
            ),
        },
    ),
    Kind(
        'slope',
        'that are wrong between 0.2 m and 1.0 m',
        {
            'that knows only full speed and standstill': variant(share='    share = 1.0 if distance > 0.2 else 0.0\n'),
            'that slows down a speed that is slow enough': variant(result='    return min(speed, max_speed) * share\n'),
            'whose slope is a curve': variant(share='    share = max(0.0, min(1.0, (distance - 0.2) / 0.8)) ** 2\n'),
        },
    ),
    Kind(
        'backwards',
        'that hold back a robot that drives backwards',
        {
            'that never drives backwards': variant(back='    if speed <= 0:\n        return 0.0\n'),
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
            'that drives on when the sensor has failed': variant(
                nan='    if isnan(distance):\n        distance = inf\n'
            ),
            'that returns nan when the sensor has failed': variant(
                nan='    if isnan(distance):\n        return distance\n'
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
            'that accepts a negative max_speed': variant(check=f'    if isnan(max_speed):\n    {BAD}'),
            'that accepts nan as max_speed': variant(check=f'    if max_speed < 0:\n    {BAD}'),
            'that refuses 0 as max_speed': variant(check=f'    if not max_speed > 0:\n    {BAD}'),
            'that raises TypeError for a bad max_speed': variant(check=PARTS['check'].replace('Value', 'Type')),
        },
    ),
)
VISIBLE = Planted(LIMIT, 'right-functions', RIGHT, NOTHINGS, KINDS, told=True)
