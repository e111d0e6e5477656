"""
Transforms on ROS topics: broadcasters, listeners and the buffer between them, under the names of ROS 2's `tf2_ros`.

Everything is reachable as `tf2_ros.<name>`. The star imports are upstream's public face: programs rely on the names
that they let through (`tf2_ros.TransformStamped`, `tf2_ros.Duration`, ...).
"""

from tf2_py import *  # noqa: F403

from tf2_ros.buffer import *  # noqa: F403
from tf2_ros.buffer_client import *  # noqa: F403
from tf2_ros.buffer_interface import *  # noqa: F403
from tf2_ros.static_transform_broadcaster import *  # noqa: F403
from tf2_ros.static_transform_listener import *  # noqa: F403
from tf2_ros.transform_broadcaster import *  # noqa: F403
from tf2_ros.transform_listener import *  # noqa: F403
