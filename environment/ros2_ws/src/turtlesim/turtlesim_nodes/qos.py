"""The quality of service of all turtlesim topics."""

from rclpy.qos import QoSProfile, ReliabilityPolicy

# Stock keeps one message. Seven is what it kept up to Humble; a reader cannot tell, and a burst of velocity
# commands survives a busy machine.
TOPIC_QOS = QoSProfile(depth=7, reliability=ReliabilityPolicy.RELIABLE)
