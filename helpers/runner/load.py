"""Whether this machine has so much to do that a right program may be late."""

import os


def busy() -> bool:
    """Whether more programs want a processor than there are."""
    return os.getloadavg()[0] > 1.5 * (os.cpu_count() or 1)
