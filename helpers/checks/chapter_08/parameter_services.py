"""Parameters of the learner's node, as another program sets and reads them: over its services."""

from rcl_interfaces.msg import ParameterDescriptor
from rcl_interfaces.srv import DescribeParameters, GetParameters, SetParametersAtomically
from rclpy.parameter import Parameter, parameter_value_to_python

from helpers.runner import expect


class Parameters:
    """The parameters of one node of the learner's."""

    def __init__(self, learner, node: str = '/governor'):
        """:param node: its full name."""
        self._set = learner.client(f'{node}/set_parameters_atomically', SetParametersAtomically)
        self._get = learner.client(f'{node}/get_parameters', GetParameters)
        self._describe = learner.client(f'{node}/describe_parameters', DescribeParameters)

    def set(self, **values):
        """Set all of these, or none; the answer has `successful` and `reason`."""
        parameters = [Parameter(name, value=value).to_parameter_msg() for name, value in values.items()]
        return self._set.call(parameters=parameters).result

    def get(self, name: str):
        """The value of a parameter; None if there is none of this name."""
        values = self._get.call(names=[name]).values
        return parameter_value_to_python(values[0]) if values else None

    def describe(self, name: str):
        """Its descriptor; None if there is no parameter of this name."""
        descriptors = self._describe.call(names=[name]).descriptors
        return descriptors[0] if descriptors and descriptors[0].type else None


def check_bounds(descriptor: ParameterDescriptor, bounds: tuple[float, float]) -> None:
    """The rule `bounds`: a parameter of the type double has this lowest and highest value, and no step."""
    name, found = descriptor.name, descriptor.floating_point_range
    ranges = [(one.from_value, one.to_value) for one in found]
    expect(ranges == [bounds], f'The descriptor of {name} has the bounds {ranges}, expected {[bounds]}.', 'bounds')
    expect(
        not found[0].step,
        f'The descriptor of {name} has the step {found[0].step:g}: then most values between the bounds are refused. '
        'Leave it out.',
        'bounds',
    )
