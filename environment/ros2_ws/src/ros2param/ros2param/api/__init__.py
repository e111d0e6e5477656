"""Parameters of other nodes: values, types, and the calls to read and write them."""

import sys
from argparse import Namespace
from typing import Any

from rclpy.parameter import get_parameter_value as get_parameter_value  # upstream's API has it, too
from ros2node.api import get_absolute_node_name, get_node_names

# Seconds that a node has to answer.
TIMEOUT = 5.0

# For each type of rcl_interfaces/ParameterType, by its number: its field, its name, and how `get` announces a value.
_TYPES = (
    ('', 'not set', 'Parameter not set.'),
    ('bool_value', 'boolean', 'Boolean value is:'),
    ('integer_value', 'integer', 'Integer value is:'),
    ('double_value', 'double', 'Double value is:'),
    ('string_value', 'string', 'String value is:'),
    ('byte_array_value', 'byte array', 'Byte values are:'),
    ('bool_array_value', 'boolean array', 'Boolean values are:'),
    ('integer_array_value', 'integer array', 'Integer values are:'),
    ('double_array_value', 'double array', 'Double values are:'),
    ('string_array_value', 'string array', 'String values are:'),
)


def get_value(*, parameter_value: Any) -> Any:
    """Return the value in a rcl_interfaces/ParameterValue as a plain Python value; None if it is not set."""
    field = _TYPES[parameter_value.type][0]
    if not field:
        return None
    value = getattr(parameter_value, field)
    return list(value) if field.endswith('_array_value') else value


def get_raw_value(parameter_value: Any) -> Any:
    """Return the value as the message holds it; None if it is not set."""
    field = _TYPES[parameter_value.type][0]
    return getattr(parameter_value, field) if field else None


def get_parameter_type_string(parameter_type: int) -> str:
    """Return the name of a type."""
    return _TYPES[parameter_type][1]


def get_label(parameter_type: int) -> str:
    """Return the words before a value of the type."""
    return _TYPES[parameter_type][2]


def node_is_there(node: Any, node_name: str, include_hidden_nodes: bool, timeout: float) -> bool:
    """Wait for a node for at most `timeout` seconds; `node` is a ros2cli DirectNode."""

    def found() -> bool:
        names = get_node_names(node=node, include_hidden_nodes=include_hidden_nodes)
        return node_name in {name.full_name for name in names}

    return node.spin(until=found, timeout=timeout)


def _call(node: Any, service_class: Any, node_name: str, service: str, **fields: Any) -> Any:
    client = node.create_client(service_class, f'{node_name}/{service}')
    try:
        if not node.spin(until=client.service_is_ready, timeout=TIMEOUT):
            raise RuntimeError('Wait for service timed out')
        return node.wait_for(client.call_async(service_class.Request(**fields)), timeout=TIMEOUT)
    except TimeoutError as e:
        raise RuntimeError(f"Exception while calling service of node '{node_name}': {e}") from None
    finally:
        node.destroy_client(client)


def call_list_parameters(*, node: Any, node_name: str, prefixes: list[str] | None = None) -> list[str]:
    """Return the names of the parameters of a node in alphabetical order (RuntimeError)."""
    from rcl_interfaces.srv import ListParameters

    return sorted(_call(node, ListParameters, node_name, 'list_parameters', prefixes=prefixes or []).result.names)


def call_get_parameters(*, node: Any, node_name: str, parameter_names: list[str]) -> Any:
    """Return the response with the values (RuntimeError)."""
    from rcl_interfaces.srv import GetParameters

    return _call(node, GetParameters, node_name, 'get_parameters', names=parameter_names)


def call_describe_parameters(*, node: Any, node_name: str, parameter_names: list[str]) -> Any:
    """Return the response with the descriptors (RuntimeError)."""
    from rcl_interfaces.srv import DescribeParameters

    return _call(node, DescribeParameters, node_name, 'describe_parameters', names=parameter_names)


def call_set_parameters(*, node: Any, node_name: str, parameters: list[Any]) -> Any:
    """Return the response with a result for each parameter (RuntimeError)."""
    from rcl_interfaces.srv import SetParameters

    return _call(node, SetParameters, node_name, 'set_parameters', parameters=parameters)


def load_parameter_file(*, node: Any, node_name: str, parameter_file: str, use_wildcard: bool) -> None:
    """
    Set every parameter of a file, and print for each whether the node took it (RuntimeError).

    :param use_wildcard: also those of the name `/**`.
    """
    parameters = _read(parameter_file, node_name, use_wildcard)
    response = call_set_parameters(node=node, node_name=node_name, parameters=parameters)
    for parameter, result in zip(parameters, response.results, strict=True):
        reason = f': {result.reason}' if result.reason else ''
        if result.successful:
            print(f'Set parameter {parameter.name} successful{reason}')
        else:
            print(f'Set parameter {parameter.name} failed{reason}', file=sys.stderr)


def _read(path: str, node_name: str, use_wildcard: bool) -> list[Any]:
    import yaml
    from rclpy.parameter import parameter_dict_from_yaml_file

    try:
        with open(path, encoding='utf-8') as file:
            content = yaml.safe_load(file)
    except OSError as e:
        raise RuntimeError(f"Cannot read parameter file '{path}': {e.strerror}") from None
    except yaml.YAMLError as e:
        raise RuntimeError(f"Parameter file '{path}' is not valid YAML: {getattr(e, 'problem', e)}") from None
    if not isinstance(content, dict):
        raise RuntimeError(f"'{path}' is not a valid ROS parameter file")
    # The wildcard alone will do; rclpy insists on the node if it is named.
    targets = [key for key in (node_name, node_name.lstrip('/')) if key in content][:1]
    if not targets:
        if not (use_wildcard and '/**' in content):
            raise RuntimeError(
                f'Param file does not contain parameters for {node_name}, only for nodes: {list(content)}'
            )
        targets = ['/**']
    try:
        return list(parameter_dict_from_yaml_file(path, use_wildcard, targets).values())
    except (AssertionError, AttributeError, TypeError, ValueError) as e:
        raise RuntimeError(f"'{path}' is not a valid ROS parameter file: {e}") from None


def add_node_arguments(parser: Any, *, timeout: bool = True) -> None:
    """Add the name of a node and the options about finding it."""
    from ros2node.api import NodeNameCompleter

    argument = parser.add_argument('node_name', help='Name of the node')
    argument.completer = NodeNameCompleter(include_hidden_nodes_key='include_hidden_nodes')
    parser.add_argument('--include-hidden-nodes', action='store_true', help='Consider hidden nodes as well')
    if timeout:
        parser.add_argument(
            '--timeout', metavar='N', type=int, default=1, help='Wait for the node for N seconds (default: %(default)s)'
        )


class ParameterNameCompleter:
    """Completes the names of the parameters of the node that the command line names."""

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the names."""
        from ros2cli.node.direct import DirectNode

        with DirectNode(parsed_args) as node:
            return call_list_parameters(node=node, node_name=get_absolute_node_name(parsed_args.node_name) or '')
