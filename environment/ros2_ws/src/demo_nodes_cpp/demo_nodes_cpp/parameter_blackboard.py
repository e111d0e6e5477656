"""A node with any parameters that others want to keep in it."""

from node_program.running import run
from rclpy.node import Node


class ParameterBlackboard(Node):
    """Takes every parameter, from the command line, a file, or another program."""

    def __init__(self) -> None:
        """Declare what it was started with."""
        super().__init__(
            'parameter_blackboard',
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )
        count = len(self.list_parameters([], 0).names)  # 0: of any depth
        self.get_logger().info(
            f"Parameter blackboard node named '{self.get_fully_qualified_name()}' ready, "
            f"and serving '{count}' parameters already!"
        )


def main(args: list[str] | None = None) -> None:
    """Run the node."""
    run(ParameterBlackboard, args)
