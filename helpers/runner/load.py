"""Whether this machine has so much to do that a right program may be late."""

import os


def busy() -> bool:
    """Whether more programs want a processor than there are."""
    return os.getloadavg()[0] > 1.5 * (os.cpu_count() or 1)


def share() -> float:
    """The part of a processor that a program gets at most, where all want as much."""
    return min(1.0, (os.cpu_count() or 1) / max(1.0, os.getloadavg()[0]))


def starved(used: float, seconds: float) -> bool:
    """Whether a program that has used so much processor time in these seconds may have wanted more than it got."""
    return used > 0.1 * share() * seconds
