from environment.tests.commands import ros2  # noqa: F401
