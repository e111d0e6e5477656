"""Where to drive from here. There is no ROS in here."""

import math
