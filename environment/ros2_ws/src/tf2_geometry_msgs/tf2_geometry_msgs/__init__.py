"""Transform the messages of geometry_msgs; importing it is enough for `Buffer.transform` to know them."""

from tf2_geometry_msgs.tf2_geometry_msgs import *  # noqa: F403
