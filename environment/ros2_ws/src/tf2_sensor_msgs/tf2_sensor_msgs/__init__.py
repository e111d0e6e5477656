"""Transform the messages of sensor_msgs; importing it is enough for `Buffer.transform` to know them."""

from tf2_sensor_msgs.tf2_sensor_msgs import *  # noqa: F403
