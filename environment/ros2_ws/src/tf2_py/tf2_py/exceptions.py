"""The exceptions of tf2. Their module is called `tf2`, as in the C++ library, so that printed names agree."""


class TransformException(Exception):
    """Base of everything that can go wrong with a transform."""

    __module__ = 'tf2'


class ConnectivityException(TransformException):
    """The two frames exist, but no chain of transforms joins them."""

    __module__ = 'tf2'


class LookupException(TransformException):
    """A frame does not exist, or the frames form a loop."""

    __module__ = 'tf2'


class ExtrapolationException(TransformException):
    """The requested time lies outside of what the buffer holds."""

    __module__ = 'tf2'


class InvalidArgumentException(TransformException):
    """A frame id is empty or begins with a slash."""

    __module__ = 'tf2'


class TimeoutException(TransformException):
    """A remote buffer did not answer in time."""

    __module__ = 'tf2'
