"""From the ticks of a wheel's encoder to a distance."""

import math


def distance(ticks, radius=0.033, ticks_per_turn=360):
    """Return the way (m) of a wheel of this radius (m) that has turned by so many ticks."""
    return 2 * math.pi * radius * ticks / ticks_per_turn
