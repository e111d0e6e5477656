"""What stock's turtlesim has because its nodes are C++, and what nodes of rclpy lack or say in other words."""

import copy

from rcl_interfaces.msg import ParameterEvent, ParameterType, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import QoSPolicyKind, qos_profile_parameter_events
from rclpy.qos_overriding_options import QoSOverridingOptions

_TOPIC = '/parameter_events'
_POLICIES = (QoSPolicyKind.DEPTH, QoSPolicyKind.DURABILITY, QoSPolicyKind.HISTORY, QoSPolicyKind.RELIABILITY)
_RANGES = {ParameterType.PARAMETER_INTEGER: 'integer', ParameterType.PARAMETER_DOUBLE: 'floating point'}


class TurtlesimNode(Node):
    """
    A node that the command line shows as it shows a node of C++.

    It hears of changed parameters, the quality of service of its own announcements of them is a parameter, which only
    the command line that starts the node can set, and it refuses values in the words of C++.
    """

    def __init__(self, name: str):
        super().__init__(name)
        plain = self._parameter_event_publisher
        self._parameter_event_publisher = self.create_publisher(
            ParameterEvent,
            _TOPIC,
            copy.copy(qos_profile_parameter_events),  # rclpy writes the values of the parameters into it
            qos_overriding_options=QoSOverridingOptions(_POLICIES),
        )
        self.destroy_publisher(plain)
        self.create_subscription(ParameterEvent, _TOPIC, lambda event: None, qos_profile_parameter_events)

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Set all of the parameters or none; clients of the services come here, too."""
        for parameter in parameter_list:
            reason = self._reason_to_refuse(parameter)
            if reason:
                return SetParametersResult(successful=False, reason=reason)
        return super().set_parameters_atomically(parameter_list)

    def _reason_to_refuse(self, parameter: Parameter) -> str:
        """Return why a parameter cannot have this value, as C++ says it; an empty text if it can."""
        name = parameter.name
        if not self.has_parameter(name):
            return f"parameter '{name}' cannot be set because it was not declared"
        descriptor = self.describe_parameter(name)
        if descriptor.read_only:
            return f"parameter '{name}' cannot be set because it is read-only"
        if parameter.type_.value != descriptor.type and not descriptor.dynamic_typing:
            return (
                f'Wrong parameter type, parameter {{{name}}} is of type {{{_type_name(descriptor.type)}}}, '
                f'setting it to {{{_type_name(parameter.type_.value)}}} is not allowed.'
            )
        for limits in (*descriptor.integer_range, *descriptor.floating_point_range):
            if not limits.from_value <= parameter.value <= limits.to_value:
                return f"Parameter {{{name}}} doesn't comply with {_RANGES[descriptor.type]} range."
        return ''


def _type_name(number: int) -> str:
    return 'not set' if number == ParameterType.PARAMETER_NOT_SET else Parameter.Type(number).name.lower()
