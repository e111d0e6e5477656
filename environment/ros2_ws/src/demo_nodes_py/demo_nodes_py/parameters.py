"""A node with all three callbacks for parameters: setting param1 also sets param2."""

from node_program.running import run
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter


class SetParametersCallback(Node):
    """Has the parameters param1 and param2, and keeps their values in an attribute, too."""

    def __init__(self) -> None:
        """Declare the parameters, and register the callbacks in the order in which they are called."""
        super().__init__('set_parameters_callback')
        self.tracked = {name: self.declare_parameter(name, 0.0).value for name in ('param1', 'param2')}
        self.add_pre_set_parameters_callback(self._add_param2)
        self.add_on_set_parameters_callback(self._check)
        self.add_post_set_parameters_callback(self._track)

    def _add_param2(self, parameters: list[Parameter]) -> list[Parameter]:
        """Return what shall be set instead of what was asked for."""
        if any(each.name == 'param1' for each in parameters):
            return [*parameters, Parameter('param2', Parameter.Type.DOUBLE, 4.0)]
        return parameters

    def _check(self, parameters: list[Parameter]) -> SetParametersResult:
        """Say whether the values may be set; nothing may be changed here."""
        known = [each.name for each in parameters if each.name in self.tracked]
        return SetParametersResult(successful=bool(known), reason=f'success {known[-1]}' if known else '')

    def _track(self, parameters: list[Parameter]) -> None:
        """Do what follows from the values, now that they are set."""
        self.tracked.update((each.name, each.value) for each in parameters if each.name in self.tracked)


def main(args: list[str] | None = None) -> None:
    """Run the node."""
    run(SetParametersCallback, args)
