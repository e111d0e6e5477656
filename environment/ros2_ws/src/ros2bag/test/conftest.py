from environment.tests.ros2_command import node, ros2  # noqa: F401
