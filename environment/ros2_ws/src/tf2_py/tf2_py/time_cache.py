"""
The history of one frame relative to its parent.

A sample is a tuple `(parent, x, y, z, qx, qy, qz, qw)`: metres and a unit quaternion. Stamps are integer nanoseconds;
the stamp 0 asks for the latest sample. Not thread-safe: the buffer holds a lock around every call.
"""

import math
from bisect import bisect_left, bisect_right

from tf2_py.rotation import interpolate


def seconds(nanoseconds):
    """Return nanoseconds as seconds, rounded as stock rounds them: whole seconds and the rest apart."""
    whole, rest = divmod(nanoseconds, 1_000_000_000)
    return whole + 1e-9 * rest


def from_seconds(seconds):
    """Return seconds as nanoseconds, to the nearest one, as stock does (tf2::timeFromSec)."""
    whole = math.floor(seconds)
    return whole * 1_000_000_000 + math.floor((seconds - whole) * 1e9 + 0.5)


class TimeCache:
    """Samples of a moving frame, kept for `length` nanoseconds behind the latest."""

    static = False
    __slots__ = ('length', 'stamps', 'samples')

    def __init__(self, length):
        self.length = length
        self.stamps = []  # ascending; among equal stamps the last inserted comes last and wins
        self.samples = []  # parallel to stamps

    def insert(self, stamp, sample):
        """Add a sample; return False if it is older than the cache reaches back. An exact duplicate is dropped."""
        stamps, samples = self.stamps, self.samples
        if stamps:
            latest = stamps[-1]
            horizon = latest - self.length
            # What is too old is dropped relative to the latest stamp before this insertion, as stock does.
            if stamps[0] < horizon:
                gone = bisect_left(stamps, horizon)
                del stamps[:gone]
                del samples[:gone]
            if stamp <= latest:
                if stamp < horizon:
                    return False
                place = bisect_right(stamps, stamp)
                for index in range(place - 1, -1, -1):
                    if stamps[index] != stamp:
                        break
                    if samples[index] == sample:
                        return True
                stamps.insert(place, stamp)
                samples.insert(place, sample)
                return True
        stamps.append(stamp)
        samples.append(sample)
        return True

    def at(self, stamp):
        """Return the sample at this time, interpolated if necessary, or None if it lies outside of the history."""
        stamps = self.stamps
        if not stamps:
            return None
        latest = stamps[-1]
        if stamp == latest or stamp == 0:
            return self.samples[-1]
        earliest = stamps[0]
        if stamp == earliest:
            return self.samples[0]
        if stamp > latest or stamp < earliest:
            return None
        newer = bisect_right(stamps, stamp)
        a, b = self.samples[newer - 1], self.samples[newer]
        if a[0] != b[0]:  # re-parented in between: there is nothing to interpolate
            return a
        before = stamps[newer - 1]
        return interpolate(a, b, (stamp - before) / (stamps[newer] - before))

    def near(self, stamp):
        """Like :meth:`at`, but not interpolated: for who only wants the parent at that time."""
        stamps = self.stamps
        if not stamps:
            return None
        latest = stamps[-1]
        if stamp == latest or stamp == 0:
            return self.samples[-1]
        earliest = stamps[0]
        if stamp == earliest:
            return self.samples[0]
        if stamp > latest or stamp < earliest:
            return None
        return self.samples[bisect_right(stamps, stamp) - 1]

    def why_not(self, stamp):
        """Return the text that explains why :meth:`at` found nothing at this time."""
        stamps = self.stamps
        if not stamps:
            return ''
        asked = seconds(stamp)
        if len(stamps) == 1:
            return (
                f'Lookup would require extrapolation at time {asked:.6f}, '
                f'but only time {seconds(stamps[0]):.6f} is in the buffer'
            )
        if stamp > stamps[-1]:
            return (
                f'Lookup would require extrapolation into the future.  Requested time {asked:.6f} '
                f'but the latest data is at time {seconds(stamps[-1]):.6f}'
            )
        return (
            f'Lookup would require extrapolation into the past.  Requested time {asked:.6f} '
            f'but the earliest data is at time {seconds(stamps[0]):.6f}'
        )

    def latest(self):
        """Return `(stamp, parent)` of the latest sample, `(0, None)` if there is none."""
        if not self.stamps:
            return 0, None
        return self.stamps[-1], self.samples[-1][0]

    def clear(self):
        """Forget every sample."""
        self.stamps.clear()
        self.samples.clear()


class StaticCache:
    """The one sample of a frame that never moves: good for every time; `clear` does not touch it."""

    static = True
    stamps = (0,)  # for the statistics: one sample, at no particular time
    __slots__ = ('sample',)

    def __init__(self):
        self.sample = None

    def insert(self, stamp, sample):
        """Replace the sample."""
        self.sample = sample
        return True

    def at(self, stamp):
        """Return the sample; None only before the first insertion."""
        return self.sample

    near = at

    def latest(self):
        """Return `(0, parent)`: a static transform has no stamp of its own."""
        return 0, self.sample[0]

    def clear(self):
        """Do nothing: a static transform holds until it is replaced."""
