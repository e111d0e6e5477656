"""What the tests of exercise 6.1 know of the mast."""

import math
from difflib import get_close_matches

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
from helpers.runner.frames import Listener, pose, to_matrix
from helpers.runner.started_nodes import StartedNodes

PARENTS = {'mast': 'base_link', 'lidar': 'mast', 'camera': 'mast', 'camera_optical': 'camera'}
RULES = {'mast': 'places', 'lidar': 'lidar', 'camera': 'tilt', 'camera_optical': 'optical'}  # how each is turned
NOT_TURNED = '"Not turned" is x=0, y=0, z=0, w=1.'
LATER = 12.0  # simulated seconds after which the late listener comes


def truth(height: float, tilt: float) -> dict:
    """The matrix of each child in its parent; `tilt` in degrees."""
    return {
        'mast': pose(x=-0.1, z=0.3),
        'lidar': pose(z=height, roll=math.pi),
        'camera': pose(x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
        'camera_optical': pose(roll=-math.pi / 2, yaw=-math.pi / 2),
    }


class Mast:
    """The learner's mast, of another height and tilt each time, and what a listener hears that comes late."""

    def __init__(self, learner, numbers: tuple[float, float] | None = None):
        """Fails if not all frames are heard, with their parents. `numbers`: height in m, tilt in degrees."""
        self.height, self.tilt = numbers or _drawn(learner.random)
        with about('late'):
            self.late, self.node = _late_joiner(learner, self.height, self.tilt)
        self.called = f'SensorMast({self.height}, {self.tilt})'

    def in_base(self, child: str):
        """The matrix of a frame in base_link; fails if there is no way."""
        matrix = self.late.matrix('base_link', child)
        expect(
            matrix is not None,
            f'tf2 finds no way from `{child}` to `base_link`: the frames are no tree. Look at the parents.',
            'tree',
        )
        return matrix


def _drawn(draw) -> tuple[float, float]:
    """A height and a tilt; some degrees look the same as radians, and they are left out."""
    height, tilt = round(draw.uniform(0.6, 2.5), 2), 0.0
    while abs(math.sin(tilt) - math.sin(math.radians(tilt))) < 0.2:
        tilt = round(draw.uniform(48, 80), 1)  # steep: no tilt is too large
    return height, tilt


def _late_joiner(learner, height: float, tilt: float) -> tuple[Listener, StartedNodes]:
    """Start the mast, and listen when all has been said; returns the listener and the mast's node."""
    early = learner.tf_listener()
    node = learner.start('SensorMast', height, tilt)
    learner.settle()
    at_once = set(early.static_transforms)
    learner.run(LATER, step=LATER)  # what a timer of a few seconds sends, too, is said before the late one listens
    expect(node.name == '/sensor_mast', f'Your node is called {node.name}, expected /sensor_mast.', 'name')
    late = learner.tf_listener()
    learner.settle()
    heard = late.static_transforms
    on_tf = learner.endpoints('/tf').publishers
    expect(
        heard or not on_tf,
        'Your transforms went to /tf. That is for frames that move; who comes late does not get '
        'them. Use a StaticTransformBroadcaster.',
    )
    expect(heard, 'A listener that came late heard nothing on /tf_static.')
    children = sorted({transform.child_frame_id for transform in early.transforms})
    expect(
        not children,
        f'Your transforms also went to /tf: {", ".join(children)}. '
        'They are static ones: send each of them once, with a StaticTransformBroadcaster.',
    )
    for child, transform in heard.items():
        swapped = PARENTS.get(transform.header.frame_id) == child
        expect(
            not swapped,
            f'You sent `{transform.header.frame_id}` as the parent of `{child}`. Parent and child are '
            'swapped: header.frame_id is the parent.',
            'tree',
        )
    lost = [child for child in PARENTS if child not in heard]
    expect(
        not lost,
        f'A listener that came late heard of {", ".join(f"`{child}`" for child in sorted(heard))}, and '
        f'nothing of `{lost and lost[0]}`. {_why(heard, lost)}',
        'late' if len(heard) == 1 else 'tree',
    )
    waiting = [child for child in PARENTS if child not in at_once]
    expect(
        not waiting,
        f'`SensorMast({height}, {tilt})` was made, and at this moment nobody heard of '
        f'`{waiting and waiting[0]}`; later somebody did. Send the transforms in the constructor, not in a timer or '
        'another callback.',
        'late',
    )
    return late, node


def _why(heard, lost: list[str]) -> str:
    """Why frames may be missing among those that were heard."""
    if len(heard) == 1:
        return 'It gets the last message of each publisher: send all transforms in one list.'
    others = [child for child in heard if child not in PARENTS]
    near = get_close_matches(lost[0], others, 1, 0.5) if lost else []
    return f'Is it what you call `{near[0]}`? A name counts letter by letter.' if near else 'Nobody has sent it.'


def judge_tree(mast: Mast) -> None:
    """The rule `tree`."""
    heard = mast.late.static_transforms
    for child, parent in PARENTS.items():
        there = heard[child].header.frame_id
        expect(there == parent, f'The parent of `{child}` is `{there}`, expected `{parent}`.', 'tree')
    others = sorted(set(heard) - set(PARENTS))
    expect(not others, f'There is one more frame, `{others and others[0]}`.', 'tree')


def judge_places(mast: Mast) -> None:
    """The rule `places`."""
    with about('places'):
        for child, expected in truth(mast.height, mast.tilt).items():
            transform = mast.late.static_transforms[child]
            place = origin(to_matrix(transform))
            is_at, wanted = apart(place, origin(expected))
            expect(
                same(place, origin(expected)),
                f'{mast.called}: `{child}` is at {is_at} in its parent, expected {wanted}.',
            )
            check_rotation(transform, NOT_TURNED)
        turned = mast.late.static_transforms['mast']
        explain(
            same(to_matrix(turned)[:3, :3], np.eye(3)),
            f'{mast.called}: `mast` is turned. {NOT_TURNED}',
            (w_first(turned, np.eye(4)), ORDER),
        )


def judge_camera(mast: Mast) -> None:
    """The rule `tilt`."""
    view, tilt, angle = axis(mast.in_base('camera'), 'x'), mast.tilt, math.radians(mast.tilt)
    expected = math.cos(angle), 0, -math.sin(angle)
    looks, wanted = apart(view, expected)
    explain(
        same(view, expected),
        f'{mast.called}: the camera looks along {looks} in base_link, expected {wanted}.',
        (
            same(view, (math.cos(angle), 0, math.sin(angle))),
            'That is up. Positive angles turn from z to x: a positive pitch looks down.',
        ),
        (same(view, (math.cos(tilt), 0, -math.sin(tilt))), 'The tilt was taken for radians. It is in degrees.'),
        (w_first(mast.late.static_transforms['camera'], truth(mast.height, tilt)['camera']), ORDER),
        (
            same(view, (math.sin(angle), 0, -math.cos(angle))),
            'This angle is counted from straight down. A tilt of 0 looks straight ahead.',
        ),
        (
            any(same(view, (math.cos(math.radians(n)), 0, -math.sin(math.radians(n)))) for n in _whole(tilt)),
            'This is a whole number of degrees: parts of a degree count, too.',
        ),
        (True, 'Which angle is it?'),
        rule='tilt',
    )


def _whole(tilt: float) -> set[int]:
    return {math.floor(tilt), math.ceil(tilt)}


def judge_upwards(learner) -> None:
    """The rules `tilt` and `places`, for a mast that is very low, and a camera that looks up."""
    draw = learner.random
    mast = Mast(learner, (round(draw.uniform(0.02, 0.08), 2), -round(draw.uniform(48, 88), 1)))
    judge_places(mast)
    view, angle = axis(mast.in_base('camera'), 'x'), math.radians(mast.tilt)
    expected = math.cos(angle), 0, -math.sin(angle)
    expect(
        same(view, expected),
        f'{mast.called}: the camera looks along {words(view)} in base_link, expected {words(expected)}: with a '
        'negative tilt it looks up.',
        'tilt',
    )


def judge_numbers(learner) -> None:
    """The rules `places`, `tilt`, `lidar` and `optical`, for other masts in the program of the first one."""
    draw = learner.random
    mast = Mast(learner)
    live = learner.tf_listener()
    numbers = [
        (round(draw.uniform(0.6, 2.5), 2), 0.0),
        (0.0, round(draw.uniform(5.0, 40.0), 1)),
        (round(draw.uniform(3.0, 30.0), 3), 90.0),
        (round(draw.uniform(0.6, 2.5), 3), round(draw.uniform(100.0, 170.0), 2)),
        (round(draw.uniform(0.6, 2.5), 2), round(draw.uniform(190.0, 260.0), 1)),
        (round(draw.uniform(0.6, 2.5), 2), -round(draw.uniform(0.1, 3.0), 2)),
        (round(draw.uniform(0.6, 2.5), 2), -round(draw.uniform(100.0, 170.0), 1)),
        (round(draw.randrange(700, 2500) / 1000 + draw.uniform(0.0003, 0.0005), 6), -90.0),  # not in whole millimetres
    ]
    draw.shuffle(numbers)
    for height, tilt in numbers:
        learner.start('SensorMast', height, tilt, beside=mast.node)
        learner.settle()
        told = f'SensorMast({height}, {tilt}), made in a program that has others, too: '
        for child, expected in truth(height, tilt).items():
            found = to_matrix(live.static_transforms[child])
            is_at, wanted = apart(origin(found), origin(expected))
            expect(
                same(origin(found), origin(expected)),
                f'{told}`{child}` is at {is_at} in its parent, expected {wanted}.',
                'places',
            )
            expect(
                same(found[:3, :3], expected[:3, :3]),
                f'{told}the x axis of `{child}` points along {words(axis(found, "x"))} in its parent and the z axis '
                f'along {words(axis(found, "z"))}, expected {words(axis(expected, "x"))} and '
                f'{words(axis(expected, "z"))}.',
                RULES[child],
            )


def judge_lidar(mast: Mast) -> None:
    """The rule `lidar`."""
    lidar, angle = mast.in_base('lidar'), math.radians(mast.tilt)
    expect(not same(lidar[:3, :3], np.eye(3)), 'The lidar stands upright. It hangs upside down.', 'lidar')
    tilted = any(same(lidar[:3, :3], (pose(pitch=one) @ pose(roll=math.pi))[:3, :3]) for one in (angle, -angle))
    for name, expected in (('x', (1, 0, 0)), ('y', (0, -1, 0)), ('z', (0, 0, -1))):
        explain(
            same(axis(lidar, name), expected),
            f'The {name} axis of the lidar points along {words(axis(lidar, name))} in base_link, expected '
            f'{words(expected)}: half a turn about x.',
            (w_first(mast.late.static_transforms['lidar'], pose(roll=math.pi)), ORDER),
            (tilted, 'It is tilted as the camera. Only the camera is tilted.'),
            (same(lidar[:3, :3], pose(pitch=math.pi)[:3, :3]), 'This is half a turn about y.'),
            (same(lidar[:3, :3], pose(yaw=math.pi)[:3, :3]), 'This is half a turn about z.'),
            rule='lidar',
        )


def judge_optical(mast: Mast) -> None:
    """The rule `optical`."""
    optical = mast.late.matrix('camera', 'camera_optical')
    expect(optical is not None, 'tf2 finds no way from `camera_optical` to `camera`.', 'tree')
    for name, where, expected in (
        ('z', 'ahead', (1, 0, 0)),
        ('x', 'to the right', (0, -1, 0)),
        ('y', 'down', (0, 0, -1)),
    ):
        expect(
            same(axis(optical, name), expected),
            f'The {name} axis of camera_optical points along {words(axis(optical, name))} in the frame camera. '
            f'Expected {where}: {words(expected)}.',
            'optical',
        )
