"""Functions for exercise 8.4: how fast a robot may drive. Right and wrong ones, made from one text."""

HEAD = '''\
from math import inf, isinf, isnan


def limit(speed, max_speed, distance):
'''
PARTS = {
    'check': '''\
    if not max_speed >= 0:
        raise ValueError('max_speed must not be negative')
''',
    'back': '''\
    if speed <= 0:
        return max(speed, -max_speed)
''',
    'nan': '''\
    if isnan(distance):
        return 0.0
''',
    'share': '''\
    share = max(0.0, min(1.0, (distance - 0.2) / 0.8))
''',
    'result': '''\
    return min(speed, max_speed * share)
''',
}


def variant(**parts: str) -> str:
    """The right function, with these parts in place of its own; an empty text leaves a part out."""
    return HEAD + ''.join({**PARTS, **parts}.values())
