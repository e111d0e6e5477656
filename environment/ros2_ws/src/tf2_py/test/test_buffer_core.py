"""What the buffer does, beyond the recorded answers."""

import math
import threading

import pytest
from builtin_interfaces.msg import Time as TimeMessage
from rclpy.clock import ClockType
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_py import (
    BufferCore,
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from tf2_py.time_cache import from_seconds, seconds

from environment.tests.tf2_messages import position, transform

LATEST = Time()
HALF = math.sqrt(0.5)


def at(seconds):
    return Time(nanoseconds=round(seconds * 1e9))


@pytest.fixture
def moving():
    """`base` moves along x in `odom`: 1 m/s from second 1 to second 3, and turns a quarter about z."""
    core = BufferCore()
    core.set_transform(transform('odom', 'base', 1.0, (1, 0, 0)), 'test')
    core.set_transform(transform('odom', 'base', 3.0, (3, 0, 0), (0, 0, HALF, HALF)), 'test')
    return core


def test_exceptions_are_those_of_the_module_tf2():
    for kind in (
        ConnectivityException,
        ExtrapolationException,
        InvalidArgumentException,
        LookupException,
        TimeoutException,
    ):
        assert issubclass(kind, TransformException) and kind.__module__ == 'tf2'


def test_interpolates_between_samples(moving):
    found = moving.lookup_transform_core('odom', 'base', at(2.0))
    assert position(found) == pytest.approx((2, 0, 0))
    assert found.transform.rotation.z == pytest.approx(math.sin(math.pi / 8))
    assert (found.header.frame_id, found.child_frame_id) == ('odom', 'base')
    assert (found.header.stamp.sec, found.header.stamp.nanosec) == (2, 0)


def test_inverts(moving):
    assert position(moving.lookup_transform_core('base', 'odom', at(3.0))) == pytest.approx((0, 3, 0))


def test_latest_is_the_latest_common_time(moving):
    moving.set_transform(transform('base', 'laser', 2.0, (0, 0, 1)), 'test')
    found = moving.lookup_transform_core('odom', 'laser', LATEST)
    assert (found.header.stamp.sec, position(found)) == (2, pytest.approx((2, 0, 1)))
    common = moving.get_latest_common_time('odom', 'laser')
    assert (common.nanoseconds, common.clock_type) == (2 * 10**9, ClockType.SYSTEM_TIME)


def test_full_goes_by_way_of_a_frame_that_stands_still(moving):
    found = moving.lookup_transform_full_core('base', at(1.0), 'base', at(2.0), 'odom')
    assert position(found) == pytest.approx((1, 0, 0))
    assert found.header.stamp.sec == 1
    assert moving.can_transform_full_core('base', at(1.0), 'base', at(2.0), 'odom') == (1, '')
    with pytest.raises(ExtrapolationException):
        moving.lookup_transform_full_core('base', at(1.0), 'base', at(4.0), 'odom')
    assert moving.can_transform_full_core('base', at(1.0), 'base', at(4.0), 'odom')[0] == 0


def test_one_nanosecond_too_late_is_too_late(moving):
    with pytest.raises(ExtrapolationException, match='into the future.  Requested time 3.000000 but the latest data'):
        moving.lookup_transform_core('odom', 'base', Time(nanoseconds=3 * 10**9 + 1))


@pytest.mark.parametrize('time', [at(2.0), TimeMessage(sec=2), Duration(seconds=2)])
def test_takes_every_kind_of_time(moving, time):
    assert position(moving.lookup_transform_core('odom', 'base', time)) == pytest.approx((2, 0, 0))


def test_names_of_arguments(moving):
    assert moving.can_transform_core(target_frame='odom', source_frame='base', time=LATEST) == (1, '')
    assert moving.lookup_transform_full_core(
        target_frame='odom', target_time=LATEST, source_frame='base', source_time=LATEST, fixed_frame='odom'
    )
    assert moving.lookup_transform_core(target_frame='odom', source_frame='base', time=LATEST)


@pytest.mark.parametrize(
    ('target', 'source', 'kind', 'text'),
    [
        (
            '',
            'base',
            InvalidArgumentException,
            'Invalid argument "" passed to lookupTransform argument target_frame - in tf2 frame_ids cannot be empty',
        ),
        (
            'odom',
            '/base',
            InvalidArgumentException,
            'Invalid argument "/base" passed to lookupTransform argument source_frame - '
            "in tf2 frame_ids cannot start with a '/'",
        ),
        ('odom', 'moon', LookupException, '"moon" passed to lookupTransform argument source_frame does not exist. '),
    ],
)
def test_bad_frame_ids(moving, target, source, kind, text):
    with pytest.raises(kind) as caught:
        moving.lookup_transform_core(target, source, LATEST)
    assert str(caught.value) == text
    assert moving.can_transform_core(target, source, LATEST)[0] == 0


def test_wrong_types(moving):
    with pytest.raises(TypeError, match='^time must have sec and nanosec, or nanoseconds.$'):
        moving.lookup_transform_core('odom', 'base', 2.0)
    with pytest.raises(TypeError):
        moving.lookup_transform_core(None, 'base', LATEST)


def test_two_trees(moving):
    moving.set_transform(transform('mars', 'rover', 1.0), 'test')
    with pytest.raises(ConnectivityException) as caught:
        moving.lookup_transform_core('odom', 'rover', LATEST)
    assert str(caught.value) == (
        "Could not find a connection between 'odom' and 'rover' because they are not part of "
        'the same tree.Tf has two or more unconnected trees.'
    )
    with pytest.raises(TransformException) as caught:
        moving.get_latest_common_time('odom', 'rover')
    assert type(caught.value) is TransformException


def test_loop():
    core = BufferCore()
    for parent, child in (('a', 'b'), ('b', 'c'), ('c', 'a'), ('x', 'y')):
        core.set_transform(transform(parent, child, 1.0), 'test')
    for time in (LATEST, at(1.0)):
        with pytest.raises(
            LookupException,
            match='^The tf tree is invalid because it contains a loop.\nFrame b exists with parent a.\n',
        ):
            core.lookup_transform_core('y', 'a', time)
        assert core.can_transform_core('y', 'a', time)[0] == 0


@pytest.mark.parametrize(
    ('message', 'complaints'),
    [
        (
            transform('a', 'a'),
            [
                'TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and  child_frame_id "a" '
                'because they are the same'
            ],
        ),
        (
            transform('/a', 'a'),
            [
                'TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and  child_frame_id "a" '
                'because they are the same'
            ],
        ),
        (
            transform('a', ''),
            ['TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "me" because child_frame_id not set '],
        ),
        (
            transform('', 'b'),
            [
                'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "b"  from authority "me" '
                'because frame_id not set'
            ],
        ),
        (
            transform('a', 'b', xyz=(math.nan, 0, 0)),
            [
                'TF_NAN_INPUT: Ignoring transform for child_frame_id "b" from authority "me" because of a nan value '
                'in the transform (nan 0.000000 0.000000) (0.000000 0.000000 0.000000 1.000000)'
            ],
        ),
        (
            transform('a', 'b', xyzw=(0, 0, 0, 0)),
            [
                'TF_NAN_INPUT: Ignoring transform for child_frame_id "b" from authority "me" because of a nan value '
                'in the transform (0.000000 0.000000 0.000000) (-nan -nan -nan -nan)',
                'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "b" from authority "me" '
                'because of an invalid quaternion in the transform (0.000000 0.000000 0.000000) (-nan -nan -nan -nan)',
            ],
        ),
    ],
)
def test_refuses_what_makes_no_sense(message, complaints, logged):
    core = BufferCore()
    assert core.set_transform(message, 'me') is None
    core.set_transform_static(message, 'me')
    said = logged()
    for complaint in complaints:
        assert said.count(complaint) == 2, said
    assert said.count('[ERROR]') == 2 * len(complaints)
    assert core.all_frames_as_yaml() == '[]'


@pytest.mark.parametrize('xyzw', [(0, 0, 0, 2), (0, 0, 3, 3), (1e-3, 0, 0, 1e-3)])
def test_normalizes_quaternions(xyzw):
    core = BufferCore()
    core.set_transform(transform('a', 'b', 1.0, xyzw=xyzw), 'test')
    rotation = core.lookup_transform_core('a', 'b', LATEST).transform.rotation
    length = math.hypot(*xyzw)
    assert (rotation.x, rotation.y, rotation.z, rotation.w) == pytest.approx([part / length for part in xyzw])


@pytest.mark.parametrize('xyzw', [(math.inf, 0, 0, 1), (1e-300, 0, 0, 0), (0, math.nan, 0, 1)])
def test_rotations_without_meaning_are_refused(xyzw):
    core = BufferCore()
    core.set_transform(transform('a', 'b', 1.0, xyzw=xyzw), 'test')
    assert core.all_frames_as_yaml() == '[]'


def test_an_infinite_translation_is_accepted():
    core = BufferCore()
    core.set_transform(transform('a', 'b', 1.0, (math.inf, -math.inf, 0)), 'test')
    assert position(core.lookup_transform_core('a', 'b', LATEST)) == (math.inf, -math.inf, 0)


def test_leading_slashes_of_what_is_sent_are_dropped():
    core = BufferCore()
    core.set_transform(transform('/a', '/b', 1.0), 'test')
    assert core._getFrameStrings() == ['b', 'a']


def test_old_data_is_refused_with_a_warning(logged):
    core = BufferCore(Duration(seconds=2))
    for stamp in (10.0, 8.0, 7.999999):
        core.set_transform(transform('a', 'b', stamp), 'me')
    assert logged() == (
        '[WARN] []: TF_OLD_DATA ignoring data from the past for frame b at time 7.999999 according to '
        'authority me\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%20explained\n'
    )
    assert core.can_transform_core('a', 'b', at(8.0))[0] == 1


def test_clear_keeps_names_and_statics(moving):
    moving.set_transform_static(transform('base', 'laser', xyz=(0, 0, 1)), 'test')
    moving.clear()
    assert moving._frameExists('odom') and moving._frameExists('base')
    assert moving.can_transform_core('base', 'laser', at(99.0))[0] == 1
    assert moving.can_transform_core('odom', 'base', LATEST)[0] == 0
    assert (
        moving.all_frames_as_string() == 'Frame base exists with parent NO_PARENT.\n'
        'Frame laser exists with parent base.\n'
    )


def test_static_and_moving_replace_each_other(moving):
    moving.set_transform_static(transform('odom', 'base', 5.0, (7, 0, 0)), 'test')
    assert position(moving.lookup_transform_core('odom', 'base', at(99.0))) == (7, 0, 0)
    moving.set_transform(transform('odom', 'base', 4.0, (4, 0, 0)), 'test')
    assert moving.can_transform_core('odom', 'base', at(2.0))[0] == 0


def test_dot_and_chain(moving):
    moving.set_transform_static(transform('base', 'laser'), 'me')
    moving.set_transform_static(transform('base', 'camera'), 'me')
    text = moving._allFramesAsDot(at(5.0))
    assert (
        '"odom" -> "base"[label="Broadcaster: test\\nAverage rate: 1.000 Hz\\n'
        'Most recent transform: 3.000000 ( 2.000 sec old)\\nBuffer length: 2.000 sec\\n"];' in text
    )
    assert BufferCore()._allFramesAsDot() == 'digraph G {\n"no tf data received"\n}'
    chain = moving._chain(
        target_frame='camera', target_time=LATEST, source_frame='laser', source_time=LATEST, fixed_frame='laser'
    )
    assert chain == ['laser', 'base', 'camera']
    assert moving._chain('odom', LATEST, 'laser', LATEST, 'odom') == ['laser', 'base', 'odom']
    assert moving._chain('laser', LATEST, 'odom', LATEST, 'laser') == ['odom', 'base', 'laser']
    assert moving._chain('camera', LATEST, 'laser', LATEST, 'odom') == ['laser', 'base', 'camera']


@pytest.mark.parametrize(('speed', 'turn'), [(3.0, 0.0), (0.0, 0.1)])
def test_velocity(speed, turn):
    core = BufferCore()
    for second in range(5):
        angle = turn * second
        core.set_transform(
            transform(
                'odom', 'base', float(second), (speed * second, 0, 0), (0, 0, math.sin(angle / 2), math.cos(angle / 2))
            ),
            'test',
        )
    linear, angular = core.lookupVelocityCore('base', 'odom', at(2.0), Duration(seconds=2))
    assert linear == pytest.approx((speed, 0, 0), abs=1e-6)
    assert angular == pytest.approx((0, 0, turn), abs=1e-6)
    assert (linear, angular) == core.lookupVelocityFullCore(
        'base', 'odom', 'odom', (0, 0, 0), 'base', at(2.0), Duration(seconds=2)
    )


def test_seconds_become_the_nearest_nanosecond():
    for nanoseconds in (0, 1, 290_000_000, 999_999_999, 1_100_000_000, 123_456_000_000_001):
        assert from_seconds(seconds(nanoseconds)) == nanoseconds


def test_threads_can_share_a_buffer():
    core = BufferCore()
    core.set_transform_static(transform('world', 'odom'), 'test')
    core.set_transform(transform('odom', 'base', 0.01, (0.01, 0, 0)), 'test')
    failures, done = [], threading.Event()

    def insert():
        for step in range(2, 4000):
            core.set_transform(transform('odom', 'base', step / 100, (step / 100, 0, 0)), 'test')
        done.set()

    def ask():
        try:
            while not done.is_set():
                found = core.lookup_transform_core('world', 'base', LATEST)
                stamp = found.header.stamp.sec + found.header.stamp.nanosec / 1e9
                assert position(found)[0] == pytest.approx(stamp)
                assert 'base' in core.all_frames_as_yaml()
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=insert), *(threading.Thread(target=ask) for _ in range(3))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60.0)
    assert done.is_set() and not failures
