"""What stock's turtlesim has because its nodes are C++, and what nodes of rclpy lack or say in other words."""

import copy

from rcl_interfaces.msg import ParameterEvent, ParameterType, SetParametersResult
from rclpy.exceptions import InvalidParameterValueException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.qos import QoSPolicyKind, qos_profile_parameter_events
from rclpy.qos_overriding_options import QoSOverridingOptions

_TOPIC = '/parameter_events'
_POLICIES = (QoSPolicyKind.DEPTH, QoSPolicyKind.DURABILITY, QoSPolicyKind.HISTORY, QoSPolicyKind.RELIABILITY)
_RANGES = {ParameterType.PARAMETER_INTEGER: 'integer', ParameterType.PARAMETER_DOUBLE: 'floating point'}


class _Announcements:
    """What a node says of its changed parameters: kept until there is a publisher, whose parameters come first."""

    def __init__(self):
        self._publisher: Publisher | None = None
        self._waiting: list[ParameterEvent] = []

    def publish(self, event: ParameterEvent) -> None:
        if self._publisher is None:
            self._waiting.append(event)
        else:
            self._publisher.publish(event)

    def begin(self, publisher: Publisher) -> None:
        """Send what has waited, and from now on everything at once, by this publisher."""
        self._publisher = publisher
        while self._waiting:
            publisher.publish(self._waiting.pop(0))


class TurtlesimNode(Node):
    """
    A node that the command line shows as it shows a node of C++.

    It hears of changed parameters, the quality of service of its own announcements of them is a parameter, which only
    the command line that starts the node can set, and it refuses values in the words of C++.
    """

    def __init__(self, name: str):
        self._announcements = _Announcements()
        super().__init__(name)
        self._announcements.begin(self._create_announcing_publisher())
        self.create_subscription(ParameterEvent, _TOPIC, lambda event: None, qos_profile_parameter_events)

    def create_publisher(self, msg_type, topic, qos_profile, **options):
        """Create a publisher; rclpy's own one of announcements, which it creates first, waits for ours."""
        if topic == _TOPIC and not options:
            return self._announcements
        return super().create_publisher(msg_type, topic, qos_profile, **options)

    def _create_announcing_publisher(self) -> Publisher:
        """
        Create the publisher of changed parameters, with the quality of service that the command line sets.

        :raises InvalidParameterValueException: if there is no such quality of service
        """
        try:
            return self.create_publisher(
                ParameterEvent,
                _TOPIC,
                copy.copy(qos_profile_parameter_events),  # rclpy writes the values of the parameters into it
                qos_overriding_options=QoSOverridingOptions(_POLICIES),
            )
        except RuntimeError as error:
            prefix = f'qos_overrides.{_TOPIC}.publisher'
            given = self.get_parameters_by_prefix(prefix)
            values = ', '.join(f'{name}: {parameter.value}' for name, parameter in given.items())
            raise InvalidParameterValueException(prefix, values, str(error)) from None

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
