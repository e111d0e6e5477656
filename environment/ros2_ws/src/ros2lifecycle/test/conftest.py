from environment.tests.ros2_command import node, robot, ros2, several_nodes  # noqa: F401
