"""What the tests of exercise 8.8 share: the learner's Courier, and somebody who tells it where it is."""

import math
import time

import pytest
from geometry_msgs.msg import Twist

from helpers.checks.chapter_08.deliveries import Localizer
from helpers.runner import about, expect
from helpers.runner.peers import SECOND

QUICK = 0.05  # s of wall time; an answer without a wait takes some milliseconds


class Lost:
    """A Courier that has heard nothing yet, at a time that does not begin at 0."""

    def __init__(self, learner):
        draw = learner.random
        learner.now = draw.randint(100, 900) * SECOND + draw.randint(5, 9) * SECOND // 10
        self.learner, self.draw = learner, draw
        self._side = draw.choice([-1, 1])  # to which odom is turned
        self.localizer = Localizer(learner, self.drift())
        self.node = learner.start('Courier')
        learner.run(0.2)

    def drift(self) -> tuple[float, float, float]:
        """Where odom is in the map, in metres and radians; each time it is turned to the other side."""
        draw, self._side = self.draw, -self._side
        return draw.uniform(0.5, 1), -draw.uniform(0.5, 1), self._side * draw.uniform(1.95, 2.05)

    def where(self, rule: str):
        """What the learner's `where` returns: None, or a list of three numbers. `rule`: what another result breaks."""
        with about('at-once'):
            found = self.node.call('where')
        if found is not None:
            expect(
                isinstance(found, (list, tuple))
                and len(found) == 3
                and all(type(one) in (int, float) and math.isfinite(one) for one in found),
                f'where() is {found!r}, expected (x, y, yaw) or None.',
                rule,
            )
        return found

    def somewhere(self) -> tuple[float, float, float]:
        """A place, in metres and radians."""
        draw = self.draw
        return draw.uniform(1, 3), draw.uniform(1, 3), draw.uniform(0.5, 1)


def same(found, wanted) -> bool:
    return found is not None and list(found) == pytest.approx(list(wanted), abs=1e-4)


def shown(place) -> str:
    return f'({", ".join(f"{value:.2f}" for value in place)})'


def judge_given(learner) -> None:
    """The rule `given`."""
    draw = learner.random
    commands = learner.listen('/cmd_vel', Twist)
    with about('given'):
        node = learner.start('Courier')
        learner.run(0.3)
        before = len(commands.messages)
        for count, size in enumerate((1.0, 0.0, draw.uniform(0.02, 0.1), draw.uniform(12.0, 40.0)), 1):
            signs = draw.choice([-1, 1]), draw.choice([-1, 1])
            speeds = size * signs[0] * draw.uniform(0.1, 0.4), size * signs[1] * draw.uniform(0.5, 0.9)
            node.call('drive', *speeds)
            learner.run(0.1)
            got = [_speeds(twist) for twist in commands.messages[before:]]
            expect(
                len(got) == count and got[-1] == pytest.approx([speeds[0], 0, 0, 0, 0, speeds[1]]),
                f'After drive({speeds[0]:.2f}, {speeds[1]:.2f}), /cmd_vel has brought '
                f'{"nothing new" if len(got) < count else _words(commands.messages[-1])}. `drive` is given: leave it '
                'as it is.',
                'given',
            )
        name = ''.join(draw.choices('abcdefgh', k=6))
        expect(node.call('place', name) is None, f'Nobody has set {name}, and place({name!r}) is not None.', 'given')
        args = ['--ros-args', '-r', f'__ns:=/{name}']
        other = learner.start('Courier', beside=node, cli_args=args)
        expect(
            other.name == f'/{name}/delivery_robot',
            f'Courier(cli_args={args}) is called {other.name}, expected /{name}/delivery_robot, as a StationKeeper '
            'is: its constructor hands **options on.',
            'given',
        )
        for told in (False, True):
            if told:
                Localizer(learner).tell(1.0, 2.0, 0.5)
                learner.run(0.1)
            before = len(commands.messages)
            node.call('where')
            learner.run(0.1)
            state = node.call('__getattribute__', 'state')
            expect(
                len(commands.messages) == before,
                'where() was called, and a command came on /cmd_vel. where() says where the robot is, and changes '
                'nothing.',
                'given',
            )
            expect(
                state == 'idle',
                f"self.state is {state!r}, and the robot drives nowhere: it stays 'idle', as in a StationKeeper. "
                'where() says where the robot is, and changes nothing.',
                'given',
            )


def _speeds(twist: Twist) -> list[float]:
    """Three linear ones (m/s), and three angular ones (rad/s)."""
    return [getattr(part, axis) for part in (twist.linear, twist.angular) for axis in 'xyz']


def _words(twist: Twist) -> str:
    return f'linear {_speeds(twist)[:3]} and angular {_speeds(twist)[3:]}'


def judge_unknown(lost: Lost) -> None:
    """The rules `unknown` and `at-once`."""
    for what, tell in (
        ('No transform has come', lambda: None),
        ('Only odom in map is known', lost.localizer.localize),
        (
            'Only odom in map, and base_footprint in a frame without a parent, are known',
            lambda: lost.localizer.move(1.0, 2.0, 0.5, parent='wheels'),
        ),
    ):
        tell()
        lost.learner.run(0.1)
        found = lost.where('unknown')
        expect(found is None, f'{what}, and where() is {found and shown(found)}, expected None.', 'unknown')
    _judge_at_once(lost, 'While the place is not known')
    # The only transform of the wheels is newer than the only one of the localiser: no moment is known for both.
    lost.localizer.move(1.0, 2.0, 0.5)
    lost.learner.run(0.1)
    lost.where('at-once')


def _judge_at_once(lost: Lost, when: str) -> None:
    """The rule `at-once`."""
    before = lost.learner.slept
    seconds = min(_seconds(lost) for _ in range(5))  # the shortest: a busy machine may be slow once
    slept = lost.learner.slept - before
    expect(
        seconds < QUICK and not slept,
        f'{when}, where() takes {max(seconds, slept / 5):.2f} s. It must not wait: ask without a timeout.',
        'at-once',
    )


def _seconds(lost: Lost) -> float:
    """How long `where` takes, in seconds of wall time."""
    begin = time.monotonic()
    lost.where('at-once')
    return time.monotonic() - begin


def judge_place(lost: Lost) -> None:
    """The rules `place`, `newest` and `yaw`."""
    told = None
    for _ in range(3):
        before, told = told, lost.somewhere()
        x, y, yaw = told
        lost.localizer.tell(*told)
        lost.learner.run(0.1)
        found = lost.where('place')
        expect(
            found is not None,
            f'The robot is at {shown(told)}, tf2 was told so 0.1 s ago, and where() is None.{_full_second(lost)}',
            'place',
        )
        said = f'The robot is at {shown(told[:2])}, and where() says {shown(found[:2])}.'
        expect(
            before is None or not same(found, before),
            f'{said} There it was before. Ask for the newest transform, each time.',
            'newest',
        )
        swapped = [-x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) - y * math.cos(yaw)]
        expect(
            not same(found[:2], swapped),
            f'{said} That is the map in the frame of the robot: target and source are swapped.',
            'place',
        )
        expect(same(found[:2], told[:2]), f'{said} In which frame did you ask for which one?', 'place')
    _judge_correction(lost)
    _judge_moment(lost)
    _judge_zeros(lost)
    for low, high in 2 * ((0.5, 1.5), (-1.5, -0.5), (2.3, 3.1), (-3.1, -2.3)):
        if low == 0.5:
            lost.localizer.drift(*lost.drift())
        yaw = lost.draw.uniform(low, high)
        lost.localizer.tell(1.0, 1.0, yaw)
        lost.learner.run(0.1)
        found = lost.where('yaw')
        expect(
            same(found and found[2:], [yaw]),
            f'The robot looks to {yaw:.2f} rad, and where() says {found and round(found[2], 2)}. '
            + _of_yaw(yaw, found[2] if found else math.nan),
            'yaw',
        )


def _of_yaw(yaw: float, found: float) -> str:
    """What is wrong with a yaw in rad, as far as the number tells; `found` is what `where` says."""
    turns = (found - yaw) / math.tau
    if found == pytest.approx(-yaw, abs=1e-4):
        return 'To the left is positive: the sign of z and that of w say together to which side, atan2 takes both.'
    if found == pytest.approx(yaw / 2, abs=1e-4):
        return 'That is half of it: z and w are sine and cosine of half the angle.'
    if found == pytest.approx(math.degrees(yaw), abs=1e-2):
        return 'That is in degrees: the yaw is in radians.'
    if turns and turns == pytest.approx(round(turns), abs=1e-4):
        return 'That is the same direction, and the yaw is a number from -π to π: bring it there.'
    return 'The yaw is the angle of the rotation, in radians, from -π to π.'


def judge_two(lost: Lost) -> None:
    """The rules `unknown`, `place` and `newest`, of two robots in one program: each one has heard for itself."""
    learner, told = lost.learner, lost.somewhere()
    lost.localizer.tell(*told)
    learner.run(0.1)
    lost.where('place')
    own = 'Buffer and listener belong to the object (self), and not to the class.'
    words = 'A Courier in the same program was told that it is at'
    number = lost.draw.randint(2, 99)
    deaf = ['--ros-args', '-r', f'__ns:=/robot{number}', '-r', f'/tf:=/robot{number}/tf']
    with about('unknown'):
        other = learner.start('Courier', beside=lost.node, cli_args=deaf)
        learner.settle()
        found = other.call('where')
    expect(
        found is None,
        f'{words} {shown(told)}. Another one, to which nobody speaks, says {found and shown(found)}, expected None. '
        f'{own}',
        'unknown',
    )
    with about('place'):
        other = learner.start('Courier', beside=lost.node)
        learner.settle()
        for what in ('A second one was made then. It hears the same, and', 'Both were told a new place, and'):
            told = lost.somewhere()
            lost.localizer.tell(*told)
            learner.run(0.1)
            first, found = lost.where('place'), other.call('where')
            expect(
                first is not None or found is not None,
                f'The robot is at {shown(told)}, tf2 was told so 0.1 s ago, and where() is None.',
                'place',
            )
            expect(
                first is None or same(found, first),  # what is wrong with both, other tests say
                f'There is a Courier in the program already. {what} where() of the second one says '
                f'{found and shown(found)}, and that of the first one {first and shown(first)}. {own}',
                'place',
            )


def _full_second(lost: Lost) -> str:
    """Why a place that was told 0.1 s ago may be taken for an old one, if that depends on the moment."""
    if lost.learner.now % SECOND > SECOND // 10:
        return ''
    return ' Since then a full second has begun: compare whole times, and not `sec` or `nanosec` alone.'


def _judge_zeros(lost: Lost) -> None:
    """The rule `place`, where numbers of it are 0, as at the place where a map begins."""
    lost.localizer.drift(0.0, 0.0, 0.0)
    x, y = -lost.draw.uniform(120, 900), -lost.draw.uniform(120, 900)  # a long way from there, as on a farm
    for told in ((0.0, 0.0, 0.0), (x, 0.0, 0.0), (0.0, y, lost.draw.uniform(0.5, 1))):
        lost.localizer.tell(*told)
        lost.learner.run(0.1)
        found = lost.where('place')
        expect(
            same(found and found[:2], told[:2]),
            f'x, y and yaw of the robot are {shown(told)}, and where() is {found and shown(found)}.'
            + ('' if found else _full_second(lost) or ' 0 is a number like any other: `if x` is false for it.'),
            'place',
        )


def _to_a_good_second(learner) -> None:
    """Go on to a full second from which half a second is no more than that, also in floats.

    A node may compare seconds that it has computed from nanoseconds with 1e-9, which is not exact.
    """
    learner.run((-learner.now % SECOND) / SECOND)
    while (learner.now + SECOND // 2) * 1e-9 - learner.now // SECOND > 0.5:
        learner.run(1.0)


def _judge_correction(lost: Lost) -> None:
    """The rule `newest`: the localiser corrects where odom is in the map, and the wheels have nothing to say."""
    before = lost.where('newest')
    for _ in range(2):
        now = lost.localizer.correct(*lost.drift())
        lost.learner.run(0.1)
        found = lost.where('newest')
        expect(
            same(found and found[:2], now[:2]),
            'The localiser has corrected where odom is in map; base_footprint in odom is the same as before. So the '
            f'robot is at {shown(now[:2])}, and where() says {found and shown(found[:2])}. '
            + ('That is the place without the correction. ' if before and same(found and found[:2], before[:2]) else '')
            + 'Ask for the transform from map to base_footprint, each time anew.',
            'newest',
        )


def _judge_moment(lost: Lost) -> None:
    """The rule `newest`: asked before and after new transforms come, without time between."""
    lost.learner.run(0.1)
    before = lost.where('newest')
    now = lost.somewhere()
    lost.localizer.tell(*now)
    lost.learner.settle()
    found = lost.where('newest')
    expect(
        same(found and found[:2], now[:2]),
        f'where() was asked, new transforms came, and it was asked again: the robot is at {shown(now[:2])}, and '
        f'where() says {found and shown(found[:2])}. '
        + ('That is the answer of before. ' if before and found == before else '')
        + 'Ask tf2 each time, and keep no answer.',
        'newest',
    )


def judge_age(lost: Lost) -> None:
    """The rules `old` and `again`."""
    place = lost.somewhere()
    lost.localizer.tell(*place)
    lost.learner.run(0.1)
    expect(
        lost.where('place') is not None,
        '0.1 s ago the place of odom in map and that of base_footprint in odom were told, and where() is None. These '
        'are the frames that there are: map, odom, base_footprint.',
        'place',
    )
    _judge_at_once(lost, 'While the place is known')
    lost.localizer.tell(*place)
    lost.learner.run(0.45)
    for again in ('', ', asked once more,'):
        expect(
            lost.where('old') is not None,
            f'The transforms are 0.45 s old, and where(){again} is None. That is good enough.',
            'old',
        )
    _to_a_good_second(lost.learner)
    lost.localizer.tell(*place)
    lost.learner.run(0.5)
    expect(
        lost.where('old') is not None,
        'The transforms are exactly 0.5 s old, and where() is None. Up to 0.5 s they are good.',
        'old',
    )
    hardly = lost.draw.randint(1, 15)  # ms
    lost.learner.run(hardly / 1000)
    found = lost.where('old')
    expect(
        found is None,
        f'The transforms are {0.5 + hardly / 1000:.3f} s old, and where() still says {found and shown(found)}. They '
        'are older than 0.5 s: compare without rounding.',
        'old',
    )
    lost.localizer.tell(*place)
    lost.learner.run(0.45)
    age = lost.draw.uniform(0.08, 0.3)
    lost.learner.run(age)
    found = lost.where('old')
    expect(
        found is None,
        f'The transforms are {0.45 + age:.2f} s old, and where() still says '
        f'{found and shown(found)}. Compare their stamp with the clock of the node.',
        'old',
    )
    lost.learner.run(lost.draw.uniform(0.5, 2.0))
    found = lost.where('old')
    expect(
        found is None,
        f'The transforms are more than a second old, and where() still says {found and shown(found)}.',
        'old',
    )
    _judge_at_once(lost, 'While the place is too old')
    _judge_halves(lost)
    _judge_stamps(lost)
    _judge_long_silence(lost)


def _judge_halves(lost: Lost) -> None:
    """The rules `old` and `again`, where one of the two transforms goes on and the other one does not."""
    for new, old, go_on in (
        ('base_footprint in odom', 'odom in map', lost.localizer.move),
        ('odom in map', 'base_footprint in odom', lambda *_: lost.localizer.localize()),
    ):
        back = _judge_return(lost, 'After a pause the transforms came again')
        for age in (0.4, 0.7):  # s; 0.1 s have passed since the return
            for _ in range(3):
                lost.learner.run(0.1)
                go_on(*back)
            lost.learner.run(0.02)
            found = lost.where('old')
            expect(
                (found is None) == (age > 0.5),
                f'{new} is new, and {old} is {age} s old: so the place is {age} s old, and where() is '
                f'{found and shown(found)}. Up to 0.5 s it is good, and then no more.',
                'old',
            )


def _judge_stamps(lost: Lost) -> None:
    """The rule `old`: the stamps count, not the moments at which the transforms came."""
    late = lost.learner.now / SECOND - 0.6
    lost.localizer.tell(*lost.somewhere(), late - 0.02)
    lost.localizer.tell(*lost.somewhere(), late)
    lost.learner.run(0.02)
    found = lost.where('old')
    expect(
        found is None,
        'Transforms have just come, and their stamps are 0.62 s old: where() says '
        f'{found and shown(found)}. Look at the stamp, not at the moment of arrival.',
        'old',
    )
    place = lost.somewhere()
    lost.localizer.tell(*place, lost.learner.now / SECOND - 0.4)
    lost.learner.run(0.02)
    found = lost.where('again')
    expect(
        same(found, place),
        f'The place was too old. Then transforms came whose stamps are 0.42 s old, and where() is '
        f'{found and shown(found)}, expected {shown(place)}: up to 0.5 s a place is good, whatever was before.',
        'again',
    )
    lost.localizer.tell(*lost.somewhere(), lost.learner.now / SECOND + 0.7)
    lost.learner.run(0.02)
    expect(
        lost.where('old') is not None,
        'The stamps of the newest transforms are 0.68 s ahead of the clock, and where() is None. That is not older '
        'than 0.5 s.',
        'old',
    )


def _judge_long_silence(lost: Lost) -> None:
    """The rules `old` and `again`, of a localiser that is silent until no moment is left for which tf2 knows both."""
    for _ in range(13):  # a buffer keeps 10 s
        lost.learner.run(1.0)
        lost.localizer.move(*lost.somewhere())
    lost.learner.run(0.02)
    found = lost.where('old')
    expect(
        found is None,
        'The localiser has said nothing for 13 s, and base_footprint in odom came all the time: tf2 cannot look the '
        f'place up any more, and where() still says {found and shown(found)}. Do not return a place of before.',
        'old',
    )
    _judge_return(lost, 'After a silence of 13 s the localiser came back')


def _judge_return(lost: Lost, what: str) -> tuple[float, float, float]:
    """The rule `again`, once `what` has happened. Returns where the robot is, in metres and radians."""
    back = lost.somewhere()
    lost.localizer.tell(*back)
    lost.learner.run(0.1)
    found = lost.where('again')
    expect(
        same(found, back), f'{what}: the robot is at {shown(back)}, and where() is {found and shown(found)}.', 'again'
    )
    return back
