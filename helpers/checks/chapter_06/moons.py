"""What the tests of exercise 6.2 share: the learner's moon, watched for some time."""

import math

import numpy as np

from helpers.checks.chapter_06.frame_comparisons import (
    ORDER,
    apart,
    axis,
    check_rotation,
    explain,
    origin,
    same,
    w_first,
    words,
)
from helpers.runner import about, expect
from helpers.runner.frames import pose, to_matrix
from helpers.runner.peers import SECOND

STEP = 0.05  # s
PAUSE = 0.02  # s, less than a step: so long the clock goes on in the middle of a callback
MOST_PLACES = 60  # at which a callback may stand aside; that of a usual answer has about half of them


class Watched:
    """A moon that was started at some time. `pairs`: (time of arrival in s, transform)."""

    def __init__(self, learner, seconds: float, rounds: bool = False):
        """Watch it for so many seconds; `rounds`: then at times in two rounds, and most calls of its timer are lost."""
        draw = learner.random
        radii, periods = ((0.2, 0.9), (0.45, 0.9)) if rounds else ((1.5, 9.0), (5.0, 15.0))
        self.radius, self.period = round(draw.uniform(*radii), 3), round(draw.uniform(*periods), 2)
        self.called, self.seconds = f'Moon({self.radius}, {self.period})', seconds
        if rounds:  # of these days, in seconds since 1970: what counts with too few digits is elsewhere
            learner.now = draw.randint(1_700_000_000, 1_790_000_000) * SECOND
        turns = draw.randint(1, 3) + draw.uniform(0.2, 0.4)  # it starts some turns later, when the moon is elsewhere
        learner.run(round(turns * self.period, 9))  # no round number: nanoseconds count
        heard = learner.tf_listener()
        self.begin = learner.now / SECOND
        self.node = learner.start('Moon', self.radius, self.period)
        with about('rate'):
            learner.run(seconds)
        expect(self.node.name == '/moon', f'Your node is called {self.node.name}, expected /moon.', 'name')
        expect(
            not heard.static_transforms,
            'Transforms came on /tf_static. That is for frames that never move: use a TransformBroadcaster.',
            'frames',
        )
        if rounds:
            self._lose_calls(learner)
        expect(
            heard.transforms,
            f'No transform came on /tf within {seconds:g} s. A timer sends it, and its period is in seconds.',
            'frames',
        )
        for transform in heard.transforms:
            names = transform.header.frame_id, transform.child_frame_id
            expect(
                names != ('moon', 'planet'),
                'Your transform says where `planet` is in `moon`. Parent and child are '
                'swapped: header.frame_id is the parent.',
                'frames',
            )
            expect(
                names == ('planet', 'moon'),
                f'Your transform says where `{names[1]}` is in `{names[0]}`, expected `moon` in `planet`.',
                'frames',
            )
        self.first = heard.moving.numbers[0]  # 2 or more: its publisher has sent others, which nobody could hear yet
        self.pairs = _pairs(heard)

    def _lose_calls(self, learner):
        """Let the clock jump through two rounds of the moon, as if the machine were too busy to call the timer."""
        for _ in range(9):
            with about('rate'):
                learner.jump(2 * self.period / 9)
                learner.run(STEP)

    def angle(self, time: float) -> float:
        """Where the moon is at this time, in rad from the planet's x axis."""
        return 2 * math.pi * time / self.period

    def place(self, angle: float) -> tuple[float, float, float]:
        """The point of the circle at this angle."""
        return _on_circle(self.radius, angle)


def _on_circle(radius: float, angle: float) -> tuple[float, float, float]:
    return radius * math.cos(angle), radius * math.sin(angle), 0.0


def _pairs(heard) -> list[tuple]:
    """What came on /tf: (time of arrival in s, transform)."""
    messages = zip(heard.moving.stamps, heard.moving.messages, strict=True)
    return [(time, transform) for time, message in messages for transform in message.transforms]


def judge_rate(moon: Watched) -> None:
    """The rule `rate`."""
    expect(
        moon.first == 1 and moon.pairs[0][0] > moon.begin + 0.01,  # it may be heard, on a busy machine
        f'A transform went out in the constructor. Send in the timer only, the first time {STEP} s after the start.',
        'rate',
    )
    wanted = round(moon.seconds / STEP)
    expect(
        len(moon.pairs) == wanted,
        f'{len(moon.pairs)} transforms came in {moon.seconds:g} s, expected {wanted}.',
        'rate',
    )
    gaps = np.diff([time for time, _ in moon.pairs])
    expect(
        same(gaps, np.full(wanted - 1, STEP)),
        f'Between two transforms there were {gaps.min():g} to {gaps.max():g} s, expected {STEP} s.',
        'rate',
    )


def judge_goes_on(learner, moon: Watched, seconds: float) -> None:
    """It still speaks after so many seconds, and after an hour: rule `rate`."""
    with about('rate'):
        learner.run(seconds)
        learner.jump(3600.0)
        heard = learner.tf_listener()
        learner.run(10.5 * STEP)
    expect(
        len(heard.transforms) in (10, 11),
        f'After {learner.now / SECOND - moon.begin:.0f} s of its time, {len(heard.transforms)} transforms came in '
        f'{10.5 * STEP:g} s, expected one every {STEP} s.',
        'rate',
    )


def judge_stamp(moon: Watched) -> None:
    """The rule `stamp`."""
    with about('stamp'):
        for time, transform in moon.pairs:
            stamp = transform.header.stamp.sec + transform.header.stamp.nanosec / 1e9
            expect(
                stamp != 0,
                'The stamp of a transform is 0: it was not filled in. So tf2 cannot tell when the moon was there.',
            )
            expect(
                stamp < 1e9 or time > 1e9,
                f'The stamp is {stamp:.0f} s: the time of the wall. Use the clock of the node.',
            )
            expect(abs(stamp - time) < 1e-6, f'At time {time:.13g} s the stamp is {stamp:.13g} s.')


def judge_circle(moon: Watched) -> None:
    """The rules `circle` and `time`."""
    start = moon.pairs[0][0]
    for number, (time, transform) in enumerate(moon.pairs):
        angle, there = moon.angle(time), origin(to_matrix(transform))
        is_at, wanted = apart(there, moon.place(angle))
        told = f'{moon.called}: at time {time:.13g} s the moon is at {is_at}'
        expect(
            same(math.hypot(*there[:2]), moon.radius, 1e-3) and same(there[2], 0.0),
            f'{told}, expected {moon.radius:g} m from the planet, in the x-y plane.',
            'circle',
        )
        right = same(there, moon.place(-angle), 1e-3)
        late = any(same(there, moon.place(moon.angle(time - start + delay)), 1e-3) for delay in (0.0, STEP))
        explain(
            same(there, moon.place(angle), 1e-3),
            f'{told}, expected {wanted}.',
            (
                same(there, moon.place(moon.angle(start + number * STEP)), 1e-3),
                f'This is the place for {start + number * STEP:.13g} s: 0.05 s more for each call of the timer. The '
                'machine was busy, and some calls were left out. Take the time from the clock in each call.',
            ),
            (
                same(there, moon.place(moon.angle(math.floor(time))), 1e-3),
                'This is the place at the whole second before: parts of a second count, too.',
            ),
            (late, 'It started on the x axis when the node was made. Its place depends on the time of the clock only.'),
            (right, 'It goes round to the right, expected to the left: from x to y.'),
            rule='circle' if right and not late else 'time',
        )


def judge_face(moon: Watched) -> None:
    """The rule `face`: the moon looks to the planet from where it is."""
    for time, transform in moon.pairs:
        there = to_matrix(transform)
        view, expected = axis(there, 'x'), -origin(there) / np.linalg.norm(origin(there))
        with about('face'):
            check_rotation(transform, 'An angle is not a part of a quaternion. Use quaternion_from_euler.')
            told = f'{moon.called}: at time {time:.13g} s the x axis of the moon points along {words(view)}'
            explain(
                same(axis(there, 'z'), (0, 0, 1)),
                f'{told}, and its z axis along {words(axis(there, "z"))}, expected (0, 0, 1).',
                (w_first(transform, facing(there)), ORDER),
                (same(axis(there, 'z'), (0, 0, -1)), 'It stands on its head: it needs a yaw, and no roll or pitch.'),
                (True, 'It needs a yaw, and no roll or pitch.'),
            )
            explain(
                same(view, expected, 1e-3),
                f'{told}, expected to the planet: {words(expected)}.',
                (same(view, (1, 0, 0)), 'It never turns.'),
                (
                    same(abs(np.dot(view, expected)), 0.0, 1e-3) and same(view[2], 0.0),
                    'It looks along its way: a quarter of a turn is missing, or too much.',
                ),
                (same(view, -expected, 1e-3), 'It looks away from the planet: half a turn is missing.'),
                (True, 'Is an angle in degrees, or is half an angle missing?'),
            )


def facing(there: np.ndarray) -> np.ndarray:
    """The matrix of a moon at the place of this one that looks to the planet."""
    x, y, z = origin(there)
    return pose(x, y, z, yaw=math.atan2(-y, -x))


def judge_two(learner, moon: Watched) -> None:
    """Another moon in the same program, far away and slow, leaves this one its circle: rules `circle` and `time`."""
    draw, heard = learner.random, learner.tf_listener()
    radius, period = round(draw.uniform(120.0, 900.0), 3), round(draw.uniform(70.0, 200.0), 2)
    learner.start('Moon', radius, period, beside=moon.node)
    learner.run(10 * STEP)
    places = [(time, origin(to_matrix(transform))) for time, transform in _pairs(heard)]
    told = f'Two moons in one program, {moon.called} and Moon({radius}, {period})'
    for wanted in (moon.radius, radius):
        expect(
            any(same(math.hypot(*place[:2]), wanted, 1e-3) for _, place in places),
            f'{told}: none of their transforms is {wanted:g} m from the planet. Keep the numbers of each moon in self, '
            'and in no variable of the class or of the module.',
            'circle',
        )
    for name, its_radius, its_period in (('first', moon.radius, moon.period), ('second', radius, period)):
        hint = 'Keep the numbers of each moon in self, and in no variable of the class or of the module.'
        for time, place in places:
            there = _on_circle(its_radius, 2 * math.pi * time / its_period)
            expect(
                not same(math.hypot(*place[:2]), its_radius, 1e-3) or same(place, there, 0.01),
                f'{told}: at time {time:.13g} s the {name} one is at {words(place)}, expected {words(there)}.'
                + (f' {hint}' if name == 'first' else ''),
                'time',
            )


def judge_one_look(learner) -> None:
    """The clock goes on in the middle of a callback: place, turn and stamp still belong together (rule `stamp`).

    It stands aside at one place of the learner's lines after the other, so that two looks at the clock differ.
    """
    draw = learner.random
    radius, period = round(draw.uniform(0.2, 0.45), 3), round(draw.uniform(0.45, 0.9), 2)
    heard, begin = learner.tf_listener(), learner.now
    with about('stamp'):
        node = learner.start('Moon', radius, period, switches=True)
        learner.run(STEP + PAUSE)
        for transform in heard.transforms:  # what is wrong already now has another cause than the busy machine
            _judge_together(f'Moon({radius}, {period})', radius, period, transform, '')
        for place in range(1, MOST_PLACES):
            node.switch(place, hold=True)
            learner.run(STEP - PAUSE)  # up to the call of the timer
            learner.run(PAUSE)
            before = len(heard.transforms)
            _, stood = node.switch(0)
            learner.settle()
            for transform in heard.transforms[before:]:
                _judge_together(f'Moon({radius}, {period})', radius, period, transform, stood)
            if not stood:  # the callback has fewer places
                break
    expect(
        heard.transforms,
        f'No transform came on /tf within {(learner.now - begin) / SECOND:g} s. A timer sends it, and its period is in '
        'seconds.',
        'rate',
    )


def _judge_together(called: str, radius: float, period: float, transform, stood: str) -> None:
    """The place of a transform is that for its stamp, and it looks to the planet from there."""
    stamp = transform.header.stamp.sec + transform.header.stamp.nanosec / 1e9
    angle = 2 * math.pi * stamp / period
    there, wanted = to_matrix(transform), _on_circle(radius, angle)
    busy = f'on a busy machine the clock went on by {PAUSE} s in the middle of a callback, at {stood}. '
    story = f'{called}: {busy if stood else ""}'
    once = 'Ask the clock once in each callback, and use this time for all.' if stood else ''
    expect(
        same(origin(there), wanted, 1e-3),
        f'{story}The stamp is {stamp:.13g} s, and the place is not that for this time, but {words(origin(there))}, '
        f'expected {words(wanted)}. {once}',
        'stamp',
    )
    expect(
        same(axis(there, 'x'), [-math.cos(angle), -math.sin(angle), 0.0], 1e-3),
        f'{story}The stamp and the place are those of one time, and the moon is turned as at another one. {once}',
        'face',
    )
