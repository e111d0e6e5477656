"""The store of transforms: who is where relative to whom, and when."""

from math import acos, copysign, sqrt
from operator import attrgetter
from threading import Lock

from geometry_msgs.msg import TransformStamped
from rclpy.clock import ClockType
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.time import Time

from tf2_py.exceptions import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TransformException,
)
from tf2_py.rotation import canonical, matrix_from_quaternion, multiply, quaternion_from_matrix, rotate
from tf2_py.time_cache import StaticCache, TimeCache, from_seconds, seconds

DEFAULT_CACHE_TIME = 10 * 10**9  # nanoseconds
MAX_GRAPH_DEPTH = 1000  # a longer way to the root means that the frames form a loop
NO_ONE = 'NO_PARENT'
NO_AUTHORITY = 'no recorded authority'

# Stock logs these through the unnamed root logger.
_logger = RcutilsLogger()

# One call instead of a dozen attribute look-ups: this is what bounds the rate of insertion.
_fields_of = attrgetter(
    'header.frame_id',
    'child_frame_id',
    'header.stamp',
    'transform.translation.x',
    'transform.translation.y',
    'transform.translation.z',
    'transform.rotation.x',
    'transform.rotation.y',
    'transform.rotation.z',
    'transform.rotation.w',
)


def to_nanoseconds(time):
    """
    Return a time or a duration in nanoseconds.

    Takes what has `nanoseconds` (rclpy's classes) or `sec` and `nanosec` (messages).

    :raises TypeError: if it has neither.
    """
    try:
        return time.sec * 1_000_000_000 + time.nanosec
    except AttributeError:
        try:
            return time.nanoseconds
        except AttributeError:
            raise TypeError('time must have sec and nanosec, or nanoseconds.') from None


class BufferCore:
    """
    The frames of a robot over time.

    Frames form a tree: every frame has at most one parent. The buffer keeps, for each, where it was relative to its
    parent during the last `cache_time` (by default 10 s), or one static transform, which holds for every time. From
    these it answers where any frame was relative to any other. All methods may be called from several threads.

    :param cache_time: how long history is kept; anything with `nanoseconds`, or `sec` and `nanosec`.
    """

    def __init__(self, cache_time=None, /):
        self._cache_length = DEFAULT_CACHE_TIME if cache_time is None else to_nanoseconds(cache_time)
        self._frames = {}  # frame id -> its cache; None for a frame that is only known as a parent
        self._authorities = {}  # frame id -> who sent it last
        self._lock = Lock()

    # -- inserting

    def set_transform(self, transform, authority):
        """
        Add a `TransformStamped`: where `child_frame_id` is in `header.frame_id` at `header.stamp`.

        What cannot be accepted (a frame relative to itself, an empty id, NaN, a zero quaternion, something older than
        the cache reaches back) is logged and ignored, as upstream does; no exception is raised.
        """
        self._insert(transform, authority, False)

    def set_transform_static(self, transform, authority):
        """Add a `TransformStamped` that holds for all times. It replaces the history of its child frame."""
        self._insert(transform, authority, True)

    def _insert(self, transform, authority, static):
        parent, child, stamp, x, y, z, qx, qy, qz, qw = _fields_of(transform)
        if parent[:1] == '/':
            parent = parent[1:]
        if child[:1] == '/':
            child = child[1:]
        qx, qy, qz, qw = canonical(qx, qy, qz, qw)
        total = x + y + z + qx + qy + qz + qw
        if parent == child or not child or not parent or total != total:
            # The sum is NaN for opposite infinities as well, which are accepted: so ask in detail.
            if _refused(parent, child, (x, y, z), (qx, qy, qz, qw), authority):
                return
        stamp = to_nanoseconds(stamp)
        frames = self._frames
        with self._lock:
            cache = frames.get(child)
            if cache is None or cache.static is not static:
                cache = frames[child] = StaticCache() if static else TimeCache(self._cache_length)
            if parent not in frames:
                frames[parent] = None
            accepted = cache.insert(stamp, (parent, x, y, z, qx, qy, qz, qw))
            if accepted:
                self._authorities[child] = authority
        if not accepted:
            _logger.warning(
                f'TF_OLD_DATA ignoring data from the past for frame {child} at time {seconds(stamp):.6f} '
                f'according to authority {authority}\n'
                'Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained'
            )

    def clear(self):
        """Forget the history of every moving frame. Static transforms and the names of the frames stay."""
        with self._lock:
            for cache in self._frames.values():
                if cache is not None:
                    cache.clear()

    # -- asking

    def lookup_transform_core(self, target_frame, source_frame, time):
        """
        Return the `TransformStamped` that takes data from the source frame into the target frame.

        :param time: when; 0 means the latest time at which all transforms on the way are known.
        :raises LookupException: if a frame does not exist or the frames form a loop.
        :raises ConnectivityException: if the frames are not in one tree.
        :raises ExtrapolationException: if the time is outside of what is stored.
        :raises InvalidArgumentException: if a frame id is empty or begins with a slash.
        """
        time = to_nanoseconds(time)
        with self._lock:
            return _message(target_frame, source_frame, *self._lookup(target_frame, source_frame, time))

    def lookup_transform_full_core(self, target_frame, target_time, source_frame, source_time, fixed_frame):
        """
        Return the transform from the source frame at one time into the target frame at another.

        The fixed frame is the one that did not move between the two times. Raises as :meth:`lookup_transform_core`.
        """
        target_time, source_time = to_nanoseconds(target_time), to_nanoseconds(source_time)
        with self._lock:
            self._validate('lookupTransform argument target_frame', target_frame)
            self._validate('lookupTransform argument source_frame', source_frame)
            self._validate('lookupTransform argument fixed_frame', fixed_frame)
            first = _compose(*self._walk(fixed_frame, source_frame, source_time)[1:])
            stamp, up, down = self._walk(target_frame, fixed_frame, target_time)
            stamp = stamp or self._latest_common_time(target_frame, fixed_frame)
        values = _after(_compose(up, down), first)
        return _message(target_frame, source_frame, stamp, values)

    def can_transform_core(self, target_frame, source_frame, time):
        """Return `(1, '')` if :meth:`lookup_transform_core` would succeed, else `(0, why not)`."""
        time = to_nanoseconds(time)
        if target_frame == source_frame:
            return 1, ''
        with self._lock:
            problem = self._problem('target_frame', target_frame) or self._problem('source_frame', source_frame)
            if problem:
                return 0, problem
            try:
                self._walk(target_frame, source_frame, time, only_parents=True)
            except TransformException as error:
                return 0, str(error)
        return 1, ''

    def can_transform_full_core(self, target_frame, target_time, source_frame, source_time, fixed_frame):
        """Return `(1, '')` if :meth:`lookup_transform_full_core` would succeed, else `(0, why not)`."""
        target_time, source_time = to_nanoseconds(target_time), to_nanoseconds(source_time)
        with self._lock:
            problem = (
                self._problem('target_frame', target_frame)
                or self._problem('source_frame', source_frame)
                or self._problem('fixed_frame', fixed_frame)
            )
            if problem:
                return 0, problem
            try:
                self._walk(target_frame, fixed_frame, target_time, only_parents=True)
                self._walk(fixed_frame, source_frame, source_time, only_parents=True)
            except TransformException as error:
                return 0, str(error)
        return 1, ''

    def get_latest_common_time(self, target_frame, source_frame):
        """
        Return the latest time at which the transform between the frames is known, as an rclpy `Time`.

        :raises TransformException: if there is none; LookupException and InvalidArgumentException for the frame ids.
        """
        with self._lock:
            self._validate('get_latest_common_time', target_frame)
            self._validate('get_latest_common_time', source_frame)
            try:
                stamp = self._latest_common_time(target_frame, source_frame)
            except TransformException as error:
                raise TransformException(str(error)) from None
        return Time(nanoseconds=stamp, clock_type=ClockType.SYSTEM_TIME)

    def lookupVelocityCore(self, tracking_frame, observation_frame, time, averaging_interval):
        """
        Return how the tracking frame moves, seen from the observation frame: `((vx, vy, vz), (wx, wy, wz))`.

        Metres and radians per second, averaged over the interval around the time. Raises as
        :meth:`lookup_transform_core`.
        """
        return self.lookupVelocityFullCore(
            tracking_frame,
            observation_frame,
            observation_frame,
            (0.0, 0.0, 0.0),
            tracking_frame,
            time,
            averaging_interval,
        )

    def lookupVelocityFullCore(
        self,
        tracking_frame,
        observation_frame,
        reference_frame,
        reference_point,
        reference_point_frame,
        time,
        averaging_interval,
    ):
        """Like :meth:`lookupVelocityCore`, expressed in a reference frame, at a reference point."""
        time, interval = to_nanoseconds(time), to_nanoseconds(averaging_interval)
        with self._lock:
            # Unknown frames and separate trees count as "no common time" here; the look-ups below report them.
            try:
                latest = self._latest_common_time(observation_frame, tracking_frame)
            except TransformException:
                latest = 0
            time = time or latest
            # In floating-point seconds, as stock: for today's dates that rounds to a quarter of a microsecond, which
            # can push the end beyond the latest data. The 10 us are there because time 0 would mean "latest".
            width = seconds(interval)
            end = min(seconds(time) + width * 0.5, seconds(latest))
            start = max(1e-5 + width, end) - width
            window = end - start
            start, end, time = (from_seconds(t) for t in (start, end, seconds(time)))
            _, (x0, y0, z0, *rotation0) = self._lookup(observation_frame, tracking_frame, start)
            _, (x1, y1, z1, *rotation1) = self._lookup(observation_frame, tracking_frame, end)
            _, (ox, oy, oz, *to_reference) = self._lookup(reference_frame, tracking_frame, time)
            _, (px, py, pz, *of_point) = self._lookup(reference_frame, reference_point_frame, time)
        axis, angle = _axis_and_angle(multiply(-rotation0[0], -rotation0[1], -rotation0[2], rotation0[3], *rotation1))
        axis = rotate(*rotation0, *axis)
        linear = [_divide(b - a, window) for a, b in ((x0, x1), (y0, y1), (z0, z1))]
        angular = [_divide(component * angle, window) for component in axis]
        wx, wy, wz = rotate(*to_reference, *angular)
        vx, vy, vz = rotate(*to_reference, *linear)
        rx, ry, rz = rotate(*of_point, *(float(component) for component in reference_point))
        # Upstream multiplies component by component here, where physics wants a cross product; kept, because programs
        # must see the same numbers. Both are zero for the usual reference point, the tracking frame's origin.
        return (
            (
                vx + oy * wz - oz * wy + wx * (rx + px - ox),
                vy + oz * wx - ox * wz + wy * (ry + py - oy),
                vz + ox * wy - oy * wx + wz * (rz + pz - oz),
            ),
            (wx, wy, wz),
        )

    # -- describing

    def all_frames_as_yaml(self):
        """Return a YAML text with every frame's parent, broadcaster, rate, span of time; `[]` if there are none."""
        entries = []
        with self._lock:
            for name, parent, rate, latest, oldest in self._statistics():
                entries.append(
                    f'{name}: \n'
                    f"  parent: '{parent}'\n"
                    f"  broadcaster: '{self._authorities.get(name, NO_AUTHORITY)}'\n"
                    f'  rate: {rate:.3f}\n'
                    f'  most_recent_transform: {seconds(latest):.6f}\n'
                    f'  oldest_transform: {seconds(oldest):.6f}\n'
                    f'  buffer_length: {seconds(latest - oldest):.3f}\n'
                )
        return ''.join(entries) or '[]'

    def all_frames_as_string(self):
        """Return one line per frame: `Frame <id> exists with parent <id>.`."""
        with self._lock:
            return self._frames_as_string()

    def _frames_as_string(self):
        return ''.join(
            f'Frame {name} exists with parent {cache.latest()[1] or NO_ONE}.\n'
            for name, cache in self._frames.items()
            if cache is not None
        )

    def _allFramesAsDot(self, time=None):
        """Return the tree as a Graphviz digraph; with a time, how old each transform is then."""
        now = 0 if time is None else to_nanoseconds(time)
        lines = ['digraph G {']
        legend = [
            'edge [style=invis];',
            ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";',
        ]
        if now:
            legend.append(f'"Recorded at time: {seconds(now):.6f}"[ shape=plaintext ] ;')
        with self._lock:
            if not self._frames:
                lines.append('"no tf data received"')
            for name, parent, rate, latest, oldest in self._statistics():
                age = f'( {seconds(now - latest):.3f} sec old)' if now else ''
                lines.append(
                    f'"{parent}" -> "{name}"[label="'
                    f'Broadcaster: {self._authorities.get(name, NO_AUTHORITY)}\\n'
                    f'Average rate: {rate:.3f} Hz\\n'
                    f'Most recent transform: {seconds(latest):.6f} {age}\\n'
                    f'Buffer length: {seconds(latest - oldest):.3f} sec\\n"];'
                )
            for name, cache in self._frames.items():
                is_root = cache is None
                if (is_root and now) or (not is_root and cache.latest()[1] is None):
                    lines += [*legend, f'}}->"{name}";']
        return '\n'.join([*lines, '}'])

    def _statistics(self):
        """Yield `(name, parent, rate in Hz, latest stamp, oldest stamp)` of every frame that has data."""
        for name, cache in self._frames.items():
            if cache is None or not cache.stamps:
                continue
            stamps = cache.stamps
            latest, oldest = stamps[-1], stamps[0]
            yield name, cache.latest()[1], len(stamps) * 1e9 / max(latest - oldest, 100_000), latest, oldest

    def _frameExists(self, frame_id):
        """Return whether the frame was ever heard of; :meth:`clear` does not change that."""
        with self._lock:
            return frame_id in self._frames

    def _getFrameStrings(self):
        """Return the ids of all frames in the order in which they were first heard of."""
        with self._lock:
            return list(self._frames)

    def _chain(self, target_frame, target_time, source_frame, source_time, fixed_frame):
        """Return the ids of the frames on the way from the source to the target by way of the fixed frame."""
        target_time, source_time = to_nanoseconds(target_time), to_nanoseconds(source_time)
        with self._lock:
            for frame in (target_frame, source_frame, fixed_frame):
                self._validate('_chain', frame)
            way = self._frames_on_way(fixed_frame, source_frame, source_time)
            for frame in self._frames_on_way(target_frame, fixed_frame, target_time)[1:]:
                if len(way) > 1 and way[-2] == frame:  # going back the way it came
                    way.pop()
                else:
                    way.append(frame)
        return way

    def _frames_on_way(self, target, source, time):
        _, up, down = self._walk(target, source, time, only_parents=True)
        ascent = [source, *(sample[0] for sample in up)]
        descent = [target, *(sample[0] for sample in down)]
        while len(ascent) > 1 and len(descent) > 1 and ascent[-2] == descent[-2]:
            ascent.pop()
            descent.pop()
        return ascent + descent[-2::-1]

    # -- the tree (the lock is held)

    def _validate(self, argument, frame):
        """Raise if the frame id is not one that can be asked for."""
        if frame in self._frames:
            return
        complaint = _ill_formed(frame)
        if complaint:
            raise InvalidArgumentException(f'Invalid argument "{frame}" passed to {argument} - {complaint}')
        raise LookupException(f'"{frame}" passed to {argument} does not exist. ')

    def _problem(self, argument, frame):
        """Return why the frame id cannot be asked for, or None."""
        if frame in self._frames:
            return None
        complaint = _ill_formed(frame) or 'frame does not exist'
        return f'Invalid frame ID "{frame}" passed to canTransform argument {argument} - {complaint}'

    def _lookup(self, target, source, time):
        """Return `(stamp, (x, y, z, qx, qy, qz, qw))` of the transform from source to target."""
        if target == source:  # not even validated: every frame is where it is
            if not time:
                cache = self._frames.get(target)
                time = cache.latest()[0] if cache is not None else 0
            return time, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
        self._validate('lookupTransform argument target_frame', target)
        self._validate('lookupTransform argument source_frame', source)
        stamp, up, down = self._walk(target, source, time)
        return stamp, _compose(up, down)

    def _walk(self, target, source, time, only_parents=False):
        """
        Climb from the source and from the target to where they meet.

        Returns the resolved stamp and the samples met on the way from the source and from the target. The source
        climbs to the root, or as far as the stored times allow, because the target may still join below.
        """
        if source == target:
            return time, (), ()
        if not time:
            time = self._latest_common_time(target, source)
        frames = self._frames
        up = []
        frame = source
        stopped_by = None  # the cache that had nothing for this time
        while True:
            cache = frames[frame]
            if cache is None:
                break
            sample = cache.near(time) if only_parents else cache.at(time)
            if sample is None:
                stopped_by = cache
                break
            if frame == target:
                return time, up, ()
            up.append(sample)
            frame = sample[0]
            if len(up) > MAX_GRAPH_DEPTH:
                raise self._loop()
        top = frame

        down = []
        frame = target
        while frame != top:
            cache = frames[frame]
            if cache is None:
                break
            sample = cache.near(time) if only_parents else cache.at(time)
            if sample is None:
                raise ExtrapolationException(
                    f'{cache.why_not(time)}, when looking up transform from frame [{source}] to frame [{target}]'
                )
            if frame == source:
                return time, (), down
            down.append(sample)
            frame = sample[0]
            if len(down) > MAX_GRAPH_DEPTH:
                raise self._loop()
        if frame != top:
            if stopped_by is not None:
                raise ExtrapolationException(
                    f'{stopped_by.why_not(time)}, when looking up transform from frame [{source}] to frame [{target}]'
                )
            raise _not_connected(target, source)
        return time, up, down

    def _latest_common_time(self, target, source):
        """Return the latest stamp at which every moving frame between the two is known; 0 if none of them moves."""
        frames = self._frames
        if target not in frames or source not in frames:
            raise LookupException('Source or target frame is not yet defined')
        if target == source:
            cache = frames[source]
            return cache.latest()[0] if cache is not None else 0
        ascent = {}  # parent -> the earliest of the latest stamps from the source up to it
        common = None
        frame = source
        depth = 0
        while True:
            cache = frames[frame]
            if cache is None:
                break
            stamp, frame = cache.latest()
            if frame is None:
                break
            if stamp and (common is None or stamp < common):
                common = stamp
            ascent.setdefault(frame, common)
            if frame == target:
                return common or 0
            depth += 1
            if depth > MAX_GRAPH_DEPTH:
                raise self._loop()

        common = None
        frame = target
        depth = 0
        while True:
            cache = frames[frame]
            if cache is None:
                break
            stamp, frame = cache.latest()
            if frame is None:
                break
            if stamp and (common is None or stamp < common):
                common = stamp
            if frame in ascent:
                other = ascent[frame]
                return min(common or other or 0, other or common or 0)
            if frame == source:
                return common or 0
            depth += 1
            if depth > MAX_GRAPH_DEPTH:
                raise self._loop()
        raise _not_connected(target, source)

    def _loop(self):
        return LookupException(f'The tf tree is invalid because it contains a loop.\n{self._frames_as_string()}\n')


def _not_connected(target, source):
    return ConnectivityException(
        f"Could not find a connection between '{target}' and '{source}' because they are "
        'not part of the same tree.Tf has two or more unconnected trees.'
    )


def _ill_formed(frame):
    """Return what is wrong with a frame id as such, or None."""
    if not isinstance(frame, str):
        raise TypeError(f'a frame id must be str, not {type(frame).__name__}')
    if not frame:
        return 'in tf2 frame_ids cannot be empty'
    if frame[0] == '/':
        return "in tf2 frame_ids cannot start with a '/'"
    return None


def _refused(parent, child, translation, rotation, authority):
    """Log everything that is wrong with a transform; return whether anything is."""
    complaints = []
    by = f'from authority "{authority}"'
    if child == parent:
        complaints.append(
            f'TF_SELF_TRANSFORM: Ignoring transform {by} '
            f'with frame_id and  child_frame_id "{child}" because they are the same'
        )
    if not child:
        complaints.append(f'TF_NO_CHILD_FRAME_ID: Ignoring transform {by} because child_frame_id not set ')
    if not parent:
        complaints.append(
            f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  {by} because frame_id not set'
        )
    values = f'in the transform ({_printf(translation)}) ({_printf(rotation)})'
    if any(value != value for value in (*translation, *rotation)):
        complaints.append(
            f'TF_NAN_INPUT: Ignoring transform for child_frame_id "{child}" {by} because of a nan value {values}'
        )
    if any(value != value for value in rotation):
        complaints.append(
            f'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "{child}" {by} '
            f'because of an invalid quaternion {values}'
        )
    for complaint in complaints:
        _logger.error(complaint)
    return bool(complaints)


def _printf(values):
    """Format as C's "%f %f %f" does, which tells the two signs of NaN apart."""
    return ' '.join(
        ('-nan' if copysign(1.0, value) < 0 else 'nan') if value != value else f'{value:f}' for value in values
    )


def _compose(up, down):
    """Return `(x, y, z, qx, qy, qz, qw)`: the climb along `up`, then `down` the other way."""
    if not down:
        return _climb(up)
    x, y, z, qx, qy, qz, qw = _climb(down)
    ix, iy, iz = rotate(-qx, -qy, -qz, qw, -x, -y, -z)
    inverse = (ix, iy, iz, -qx, -qy, -qz, qw)
    return _after(inverse, _climb(up)) if up else inverse


def _climb(samples):
    """Return the transform from the first sample's frame into the last one's parent."""
    if not samples:
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0
    steps = iter(samples)
    _, x, y, z, qx, qy, qz, qw = next(steps)
    # Written out instead of calling rotate and multiply: this is the inner loop of every look-up.
    for _, sx, sy, sz, rx, ry, rz, rw in steps:
        tx = 2.0 * (ry * z - rz * y)
        ty = 2.0 * (rz * x - rx * z)
        tz = 2.0 * (rx * y - ry * x)
        x += rw * tx + ry * tz - rz * ty + sx
        y += rw * ty + rz * tx - rx * tz + sy
        z += rw * tz + rx * ty - ry * tx + sz
        qx, qy, qz, qw = (
            rw * qx + rx * qw + ry * qz - rz * qy,
            rw * qy + ry * qw + rz * qx - rx * qz,
            rw * qz + rz * qw + rx * qy - ry * qx,
            rw * qw - rx * qx - ry * qy - rz * qz,
        )
    return x, y, z, qx, qy, qz, qw


def _after(second, first):
    """Return the transform that applies `first`, then `second`."""
    x, y, z, *rotation = second
    fx, fy, fz, *first_rotation = first
    rx, ry, rz = rotate(*rotation, fx, fy, fz)
    return (rx + x, ry + y, rz + z, *multiply(*rotation, *first_rotation))


def _message(target, source, stamp, values):
    message = TransformStamped()
    header = message.header
    header.frame_id = target
    header.stamp.sec, header.stamp.nanosec = divmod(stamp, 1_000_000_000)
    message.child_frame_id = source
    translation, rotation = message.transform.translation, message.transform.rotation
    translation.x, translation.y, translation.z, qx, qy, qz, qw = values
    rotation.x, rotation.y, rotation.z, rotation.w = canonical(qx, qy, qz, qw)
    return message


def _axis_and_angle(quaternion):
    """Return the unit axis and the angle in radians of a quaternion; the x axis for no rotation."""
    x, y, z, w = quaternion_from_matrix(*matrix_from_quaternion(*quaternion))
    s2 = 1.0 - w * w
    angle = 2.0 * acos(max(-1.0, min(1.0, w)))
    if s2 < 10.0 * 2.220446049250313e-16:
        return (1.0, 0.0, 0.0), angle
    s = sqrt(s2)
    return (x / s, y / s, z / s), angle


def _divide(value, by):
    """Divide as C does, where nothing can go wrong."""
    if by:
        return value / by
    return copysign(float('inf'), value) if value else float('nan')
