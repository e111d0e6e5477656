"""Lengths and directions."""

import math

import numpy

# Below this a number counts as zero.
EPS = numpy.finfo(float).eps * 4.0


def vector_norm(data, axis=None, out=None):
    """
    Return the Euclidean length of a vector, or of those along an axis of an array.

    :param out: write the lengths here and return None.
    """
    data = numpy.asarray(data, dtype=numpy.float64)
    if out is None and data.ndim == 1:
        return math.sqrt(numpy.dot(data, data))
    lengths = numpy.atleast_1d(numpy.sqrt(numpy.sum(data * data, axis=axis)))
    if out is None:
        return lengths
    out[...] = lengths
    return None


def unit_vector(data, axis=None, out=None):
    """
    Return the vector, or those along an axis of an array, with the length 1.

    :param out: write them here and return None.
    """
    values = numpy.array(data, dtype=numpy.float64)
    if values.ndim == 1:
        lengths = math.sqrt(numpy.dot(values, values))
    else:
        lengths = numpy.sqrt(numpy.sum(values * values, axis=axis, keepdims=axis is not None))
    values /= lengths
    if out is None:
        return values
    out[...] = values
    return None


def random_vector(size):
    """Return an array of uniformly distributed numbers from 0 up to, but not including, 1."""
    return numpy.random.random(size)
