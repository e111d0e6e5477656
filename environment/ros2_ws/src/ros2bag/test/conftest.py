from environment.tests.commands import node, ros2  # noqa: F401
