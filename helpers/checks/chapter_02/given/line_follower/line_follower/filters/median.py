"""A filter against single wrong values."""


def median(values):
    """Return the middle one of the sorted values."""
    return sorted(values)[len(values) // 2]
