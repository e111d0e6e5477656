from environment.tests.commands import node, robot, ros2, several_nodes  # noqa: F401
