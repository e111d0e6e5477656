"""Steering for exercises 8.5 and 8.6: what is right, texts of right and wrong functions, and how 8.5 is judged."""

import math

import pytest

from helpers.runner import about, expect

HEAD = """\
from math import atan2, hypot, remainder, tau


def steer(x, y, yaw, goal_x, goal_y, max_linear, max_angular):
"""
PARTS = {
    'way': '    dx, dy = goal_x - x, goal_y - y\n    distance = hypot(dx, dy)\n',
    'angle': '    angle = remainder(atan2(dy, dx) - yaw, tau)\n',
    'goal': '    if distance == 0:\n        return 0.0, 0.0, 0.0\n',
    'angular': '    angular = max(-max_angular, min(max_angular, 2 * angle))\n',
    'linear': '    linear = min(max_linear, distance) if abs(angle) <= 0.5 else 0.0\n',
    'result': '    return distance, linear, angular\n',
}


def variant(**parts: str) -> str:
    """The right function, with these parts in place of its own; an empty text leaves a part out."""
    return HEAD + ''.join({**PARTS, **parts}.values())


def right(
    x: float, y: float, yaw: float, goal_x: float, goal_y: float, max_linear: float, max_angular: float
) -> tuple[float, float, float]:
    """What `steer` must return: distance in m, linear in m/s, angular in rad/s."""
    distance = math.dist((x, y), (goal_x, goal_y))
    angle = math.remainder(math.atan2(goal_y - y, goal_x - x) - yaw, math.tau) if distance else 0.0
    linear = min(max_linear, distance) if abs(angle) <= 0.5 else 0.0
    return distance, linear, math.copysign(min(max_angular, 2 * abs(angle)), angle)


def words(arguments) -> str:
    """A call of `steer`, for messages."""
    return f'steer({", ".join(f"{value:.3g}" for value in arguments)})'


def steer(learner, rule: str, *arguments: float) -> tuple[float, float, float]:
    """What the learner's function returns: three finite numbers; `rule`: what is broken if it does not."""
    with about(rule):
        found = learner.call('steer', *map(float, arguments))
    expect(
        isinstance(found, (list, tuple))
        and len(found) == 3
        and all(type(one) in (int, float) and math.isfinite(one) for one in found),
        f'{words(arguments)} returned {found!r}, expected three finite numbers: distance, linear, angular.',
        rule,
    )
    wanted = right(*arguments)
    exchanged = list(found) != pytest.approx(wanted) and sorted(found) == pytest.approx(sorted(wanted))
    expect(
        not exchanged,
        f'{words(arguments)} returned {found!r}: the right numbers in another order than distance, linear, angular.',
        'distance',
    )
    return tuple(found)


def case(
    draw, angle: float, distance: float, yaw: float | None = None, max_linear: float = 9.0, max_angular: float = 9.0
) -> tuple[float, ...]:
    """Arguments: the robot anywhere, the goal at this angle (rad) to where it looks, so far away (m)."""
    x, y = draw.choice([-1, 1]) * draw.uniform(0.5, 3), draw.choice([-1, 1]) * draw.uniform(0.5, 3)
    yaw = draw.uniform(-1.2, 1.2) if yaw is None else yaw
    goal = x + distance * math.cos(yaw + angle), y + distance * math.sin(yaw + angle)
    return x, y, yaw, *goal, max_linear, max_angular


def told(got: float, wanted: float) -> str:
    """Both numbers, with as many digits as it needs to tell them apart."""
    digits = next((digits for digits in range(3, 9) if f'{got:.{digits}f}' != f'{wanted:.{digits}f}'), 9)
    return f'{got:.{digits}f}, expected {wanted:.{digits}f}'


def side_of(angle: float) -> str:
    """Where the goal is, for messages."""
    if not angle:
        return 'straight ahead'
    degrees = math.degrees(abs(angle))
    return f'{degrees:.{0 if degrees > 0.5 else 3}f}° to the {"left" if angle > 0 else "right"}'


def judge_distance(learner) -> None:
    """The rule `distance`."""
    draw = learner.random
    for angle, far in (
        (0.0, draw.uniform(0.5, 4)),
        (0.3, draw.uniform(20, 60)),
        (-2.0, draw.uniform(0.5, 4)),
        (0.3, draw.uniform(2e5, 9e5)),
    ):
        arguments = case(draw, angle, far)
        got = steer(learner, 'distance', *arguments)[0]
        wanted = right(*arguments)[0]
        expect(
            got == pytest.approx(wanted, abs=1e-6),
            f'{words(arguments)}: the distance is {told(got, wanted)} m. The way goes from the robot to the goal, and '
            'straight.',
            'distance',
        )


def judge_angle(learner) -> None:
    """The rules `angle`, `short-way` and `max-angular`."""
    draw = learner.random
    for size, yaw in ((0.0, None), (draw.uniform(0.1, 0.4), draw.uniform(2, 2.5)), (draw.uniform(0.6, 1.4), None)):
        for angle in (size, -size):
            arguments = case(draw, angle, draw.uniform(1, 3), yaw=yaw)
            got = steer(learner, 'angle', *arguments)[2]
            expect(
                got == pytest.approx(2 * angle, abs=1e-6),
                f'{words(arguments)}: angular is {got:.3f} rad/s, expected {2 * angle:.3f}: the goal is '
                f'{side_of(angle)} of where the robot looks.',
                'angle',
            )
    for angle in (draw.uniform(0.1, 0.4), -draw.uniform(0.6, 1.4)):
        arguments = case(draw, angle, draw.uniform(0.002, 0.008))
        got = steer(learner, 'angle', *arguments)[2]
        expect(
            got == pytest.approx(2 * angle, abs=1e-6),
            f'{words(arguments)}: angular is {got:.3f} rad/s, expected {2 * angle:.3f}: the goal is '
            f'{side_of(angle)}, {right(*arguments)[0] * 1000:.0f} mm away. Only at distance 0 there is no '
            'direction.',
            'angle',
        )
    for side in (1, -1):
        for yaw in (draw.uniform(2.6, 3.1), 3 * math.pi + draw.uniform(-0.2, 0.2), draw.uniform(11.8, 12.9)):
            angle = side * draw.uniform(1, 2.5)
            arguments = case(draw, angle, 2.0, yaw=side * yaw)
            got = steer(learner, 'short-way', *arguments)[2]
            expect(
                got == pytest.approx(2 * angle, abs=1e-6),
                f'{words(arguments)}: angular is {got:.2f} rad/s, expected {2 * angle:.2f}. The goal is '
                f'{side_of(angle)}, and the robot looks to {side * yaw:.2f} rad. Bring the angle into the range '
                'from -π to π.',
                'short-way',
            )
    for angle in (0.4, -0.4, 1.2, -1.2):
        limit = draw.uniform(0.2, 0.7)
        arguments = case(draw, angle, draw.uniform(1, 3), max_angular=limit)
        got = steer(learner, 'max-angular', *arguments)[2]
        expect(
            got == pytest.approx(math.copysign(limit, angle), abs=1e-6),
            f'{words(arguments)}: angular is {got:.2f} rad/s. The goal is {side_of(angle)}, and max_angular is '
            f'{limit:.2f}.',
            'max-angular',
        )


def judge_speed(learner) -> None:
    """The rules `linear` and `on-the-spot`."""
    draw = learner.random
    for angle in (0.0, draw.uniform(0.1, 0.2), -draw.uniform(0.1, 0.2)):
        for distance in (draw.uniform(0.002, 0.01), draw.uniform(0.05, 0.25), draw.uniform(1.5, 4)):
            limit = draw.uniform(0.3, 0.9)
            arguments = case(draw, angle, distance, max_linear=limit, max_angular=draw.uniform(0.05, 0.25))
            got = steer(learner, 'linear', *arguments)[1]
            expect(
                got == pytest.approx(min(limit, distance), abs=1e-6),
                f'{words(arguments)}: linear, in m/s, is {told(got, min(limit, distance))}. The distance is '
                f'{distance:.6g} m, and max_linear is {limit:.3f}. The angle is {angle:.2f} rad: up to 0.5 rad, linear '
                'is the lesser of the two.',
                'linear',
            )
    for side in (1, -1):
        for angle, distance in ((0.505, draw.uniform(0.5, 2)), (draw.uniform(2, 3), draw.uniform(0.002, 0.3))):
            arguments = case(draw, side * angle, distance, max_angular=draw.uniform(0.2, 0.8))
            got = steer(learner, 'on-the-spot', *arguments)[1]
            expect(
                got == 0,
                f'{words(arguments)}: linear is {got:.3f} m/s, and the goal is {side_of(side * angle)}, '
                'more than 0.5 rad. First the robot must turn.',
                'on-the-spot',
            )
        angle, limit = side * 0.495, draw.uniform(0.3, 0.9)
        arguments = case(draw, angle, draw.uniform(1, 2), max_linear=limit)
        got = steer(learner, 'on-the-spot', *arguments)[1]
        expect(
            got == pytest.approx(limit),
            f'{words(arguments)}: linear is {got:.2f} m/s, expected {limit:.2f}. The '
            f'goal is {side_of(angle)}, less than 0.5 rad: the robot drives while it '
            'turns.',
            'on-the-spot',
        )
        arguments = _just_at_the_limit(draw, side, limit)
        got = steer(learner, 'on-the-spot', *arguments)[1]
        expect(
            got == pytest.approx(limit),
            f'{words(arguments)}: linear is {got:.2f} m/s, expected {limit:.2f}. The angle is 0.5 rad, not '
            'more, so the robot drives while it turns.',
            'on-the-spot',
        )


def judge_borders(learner) -> None:
    """All rules but `at-the-goal`, with limits of 0, angles near π and near 0.5 rad, and a goal that is hardly away."""
    draw = learner.random
    for side in (1, -1):
        limit, turn, near_pi = draw.uniform(0.3, 0.9), draw.uniform(0.3, 0.9), draw.uniform(3.105, 3.14)
        for angle, far, max_linear, max_angular in (
            (draw.uniform(0.1, 0.4), draw.uniform(1, 3), 0.0, turn),
            (draw.uniform(0.1, 0.4), draw.uniform(1, 3), limit, 0.0),
            (near_pi, draw.uniform(1, 3), limit, turn),
            (near_pi, draw.uniform(1, 3), limit, 9.0),
            (0.5002, draw.uniform(1, 3), limit, turn),
            (0.4998, draw.uniform(1, 3), limit, turn),
        ):
            _judge_velocities(learner, case(draw, side * angle, far, None, max_linear, max_angular))
        for exponent in (-7, -9, -12):  # from the origin, where floats can tell such a distance
            angle, yaw, far = side * draw.uniform(0.1, 1.2), draw.uniform(-1.2, 1.2), 10**exponent
            goal = far * math.cos(yaw + angle), far * math.sin(yaw + angle)
            _judge_velocities(learner, (0.0, 0.0, yaw, *goal, limit, 9.0))


def _judge_velocities(learner, arguments: tuple[float, ...]) -> None:
    """Fail unless both velocities are right; the angle is at no border."""
    x, y, yaw, goal_x, goal_y, max_linear, max_angular = arguments
    angle = math.remainder(math.atan2(goal_y - y, goal_x - x) - yaw, math.tau)
    _, linear, angular = steer(learner, 'angle', *arguments)
    distance, wanted, turn = right(*arguments)
    told = f'The goal is {distance:.3g} m away, the angle {angle:.4f} rad, max_linear {max_linear:.3g}'
    expect(
        angular == pytest.approx(turn, abs=1e-6),
        f'{words(arguments)}: angular is {angular:.6g} rad/s, expected {turn:.6g}. {told}, max_angular '
        f'{max_angular:.3g}.' + ('' if distance > 1e-3 else ' Only at distance 0 there is no direction.'),
        'max-angular' if abs(angular) > max_angular and angular * angle >= 0 else 'angle',
    )
    expect(
        linear == pytest.approx(wanted, rel=1e-6, abs=1e-15),
        f'{words(arguments)}: linear is {linear:.6g} m/s, expected {wanted:.6g}. {told}.',
        'linear' if abs(angle) < 0.5 else 'on-the-spot',
    )


def _just_at_the_limit(draw, side: int, limit: float) -> tuple[float, ...]:
    """Arguments with an angle of 0.5 rad: the goal is straight along x, where no usual way to find it rounds it up."""
    x, y = draw.randint(-3, 3), draw.randint(-3, 3)
    return x, y, -side * 0.5, x + draw.choice([1, 2, 4]), y, limit, draw.uniform(0.2, 0.8)


def judge_anywhere(learner) -> None:
    """All rules but `at-the-goal`, with calls from a wide range: the way and the limits are short, long or between.

    The robot may have turned many times, and the goal may lie along an axis. An angle is never at a border.
    """
    draw = learner.random
    for number in range(40):
        size = 10 ** draw.uniform(-4, -0.31) if number % 2 else draw.uniform(0.52, 3.1)
        far, limit, turn = (10 ** draw.uniform(low, high) for low, high in ((-4.6, 4), (-3, 3), (-3, 2)))
        arguments = case(draw, draw.choice([-1, 1]) * size, far, draw.uniform(-120, 120), limit, turn)
        if number % 5 == 0:  # along an axis, to one of its four sides
            x, y = arguments[:2]
            ahead, across = draw.choice([(far, 0.0), (-far, 0.0), (0.0, far), (0.0, -far)])
            yaw = math.atan2(across, ahead) - draw.choice([-1, 1]) * size
            arguments = x, y, yaw, x + ahead, y + across, limit, turn
        direction = math.atan2(arguments[4] - arguments[1], arguments[3] - arguments[0])
        angle = math.remainder(direction - arguments[2], math.tau)
        found, wanted = steer(learner, 'angle', *arguments), right(*arguments)
        limited = 2 * size > turn and found[2] * angle > 0
        rules = 'distance', 'linear' if size < 0.5 else 'on-the-spot', 'max-angular' if limited else 'angle'
        for rule, name, one, other in zip(rules, ('distance', 'linear', 'angular'), found, wanted, strict=True):
            expect(
                one == pytest.approx(other, rel=1e-6, abs=1e-9),
                f'{words(arguments)}: {name} is {one:.6g}, expected {other:.6g}. The goal is {far:.3g} m away and '
                f'{side_of(angle)}, max_linear is {limit:.3g}, max_angular is {turn:.3g}.',
                rule,
            )


def judge_goal(learner) -> None:
    """The rule `at-the-goal`."""
    draw = learner.random
    for yaw in (
        draw.uniform(0.5, 3),
        -draw.uniform(0.5, 3),
        3.14,
        -3.14,
        draw.uniform(4, 40),
        -draw.uniform(4, 40),
        0.0,
    ):
        x, y = (draw.uniform(1, 3), draw.uniform(1, 3)) if yaw else (0.0, 0.0)
        got = steer(learner, 'at-the-goal', x, y, yaw, x, y, 0.5, 1.0)
        expect(
            got == (0, 0, 0),
            f'The robot is at its goal and looks to {yaw:.2f} rad: steer returned {got}, expected '
            'three zeros. At distance 0 there is no direction.',
            'at-the-goal',
        )
