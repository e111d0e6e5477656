from environment.tests.ros2_command import node, ros2  # noqa: F401
from environment.tests.running import domain, terminal  # noqa: F401
