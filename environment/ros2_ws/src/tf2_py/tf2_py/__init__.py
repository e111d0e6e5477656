"""
The transform buffer of tf2 in pure Python, under the names of ROS 2's `tf2_py`.

:class:`BufferCore` stores where frames are relative to each other over time and answers where any frame was, seen from
any other. `tf2_ros` puts it on ROS topics.
"""

from tf2_py.buffer_core import BufferCore
from tf2_py.exceptions import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

__all__ = [
    'BufferCore',
    'ConnectivityException',
    'ExtrapolationException',
    'InvalidArgumentException',
    'LookupException',
    'TimeoutException',
    'TransformException',
]
