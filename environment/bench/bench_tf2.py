"""How fast the transform buffer is.

A chain of frames, each sent at 100 Hz for 10 s, is filled in and asked from its root to its tip: for the latest time,
for recent times (the last 10 to 200 ms), and for times anywhere in the history. Messages go in and come out as in a
program. What counts is the time of the processor, so that other programs disturb little. Run it by
`./course bench tf2`.
"""

import math
import random
import time

from rclpy.time import Time
from tf2_py import BufferCore

from environment.tests.tf2_messages import transform

DEPTHS = (5, 20, 100)
RATE, DURATION = 100, 10  # Hz, seconds
START = 1_700_000_000  # seconds: stamps as large as today's
BUDGET = 0.5  # seconds for each figure
ROUNDS = 3  # the best of so many counts: the others were disturbed
# What the course promises, per second.
GOALS = {(5, 'insert'): 200_000, (5, 'look up, recent'): 30_000}


def _messages(depth):
    messages = []
    for step in range(RATE * DURATION + 1):
        angle = 0.3 * math.sin(step / 50.0)
        for link in range(depth):
            messages.append(
                transform(
                    f'link{link}',
                    f'link{link + 1}',
                    START + step / RATE,
                    (0.1 * step, 0.0, 0.2),
                    (0.0, 0.0, math.sin(angle / 2.0), math.cos(angle / 2.0)),
                )
            )
    return messages


def _insertions_per_second(messages):
    best = 0.0
    for _ in range(ROUNDS):
        core = BufferCore()
        insert = core.set_transform
        begin = time.process_time()
        for message in messages:
            insert(message, 'bench')
        best = max(best, len(messages) / (time.process_time() - begin))
    return core, best


def _calls_per_second(call, arguments):
    best = 0.0
    for _ in range(ROUNDS):
        calls, begin = 0, time.process_time()
        while (spent := time.process_time() - begin) < BUDGET / ROUNDS:
            for argument in arguments:
                call(argument)
            calls += len(arguments)
        best = max(best, calls / spent)
    return best


def _times(oldest, newest):
    """Return times that lie from `oldest` to `newest` seconds before the end of the history."""
    end = (START + DURATION) * 10**9
    chance = random.Random(1)
    return [Time(nanoseconds=end - round(chance.uniform(oldest, newest) * 1e9)) for _ in range(50)]


def _figures(depth):
    """Return how many of each operation there are per second, in a chain of this depth."""
    core, insertions = _insertions_per_second(_messages(depth))
    tip = f'link{depth}'
    latest, recent, anytime = [Time()] * 50, _times(0.01, 0.2), _times(0.0, DURATION)

    def look_up(at):
        core.lookup_transform_core('link0', tip, at)

    def can(at):
        core.can_transform_core('link0', tip, at)

    def full(at):
        core.lookup_transform_full_core('link0', at, tip, recent[0], 'link0')

    return {
        'insert': insertions,
        'look up, latest': _calls_per_second(look_up, latest),
        'look up, recent': _calls_per_second(look_up, recent),
        'look up, random': _calls_per_second(look_up, anytime),
        'can, recent': _calls_per_second(can, recent),
        'full, recent': _calls_per_second(full, recent),
    }


def measure():
    """Yield how many of each operation there are per second, beside what the course promises."""
    for depth in DEPTHS:
        for operation, figure in _figures(depth).items():
            goal = GOALS.get((depth, operation))
            yield f'depth {depth}: {operation}', figure, '1/s', *(('promised', goal) if goal else ())
