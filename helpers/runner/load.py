"""Whether this machine has so much to do that a right program may be late."""

import os


def busy() -> bool:
    """Whether more programs want a processor than there are."""
    return os.getloadavg()[0] > 1.5 * (os.cpu_count() or 1)


def starved(used: float, seconds: float) -> bool:
    """Whether a program that has used so much processor time in these seconds may have wanted more than it got."""
    share = min(1.0, (os.cpu_count() or 1) / max(1.0, os.getloadavg()[0]))
    return used > 0.1 * share * seconds
