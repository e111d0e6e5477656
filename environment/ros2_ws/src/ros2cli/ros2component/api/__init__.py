"""Containers, what they hold, and the calls to them; the names are upstream's."""

import time
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Collection, Iterable, Iterator
from typing import Any, NamedTuple

COMPONENTS_RESOURCE_TYPE = 'rclcpp_components'
TIMEOUT = 10.0  # seconds that a container has to answer
_NO_INTERFACES = (
    "the package 'composition_interfaces' is not installed: put it into a workspace, build and source "
    'it, then try again'
)
_SERVICES = {'list_nodes': 'ListNodes', 'load_node': 'LoadNode', 'unload_node': 'UnloadNode'}  # of each container


class ComponentInfo(NamedTuple):
    """A component that is loaded: its number in the container, and the full name of its node."""

    uid: int
    name: str


class _NoAnswer(RuntimeError):
    """A container has not answered in time."""


def get_package_names_with_component_types() -> list[str]:
    """Return the packages that have components."""
    from ament_index_python import get_resources

    return list(get_resources(COMPONENTS_RESOURCE_TYPE))


def get_package_component_types(*, package_name: str | None = None) -> list[str]:
    """Return the components of a package; none if it is not installed."""
    from ament_index_python import get_resource, has_resource

    if not has_resource(COMPONENTS_RESOURCE_TYPE, package_name):
        return []
    lines = get_resource(COMPONENTS_RESOURCE_TYPE, package_name)[0].splitlines()
    return [line.partition(';')[0] for line in lines]


def get_registered_component_types() -> list[tuple[str, list[str]]]:
    """Return all components by package."""
    return [(name, get_package_component_types(package_name=name)) for name in get_package_names_with_component_types()]


def find_container_node_names(*, node: Any, node_names: Iterable[Any]) -> list[Any]:
    """
    Return those nodes that are containers: they offer all services of one.

    :param node_names: as `ros2node.api.get_node_names` returns them.
    """
    known = {(name, kind) for name, types in node.get_service_names_and_types() for kind in types}
    return [
        each
        for each in node_names
        if all(
            (f'{each.full_name}/_container/{verb}', f'composition_interfaces/srv/{kind}') in known
            for verb, kind in _SERVICES.items()
        )
    ]


def get_components_in_container(
    *, node: Any, remote_container_node_name: str
) -> tuple[bool, list[ComponentInfo] | str]:
    """Return True and the components of a container, or False and why it did not tell them."""
    return get_components_in_containers(node=node, remote_containers_node_names=[remote_container_node_name])[
        remote_container_node_name
    ]


def get_components_in_containers(
    *, node: Any, remote_containers_node_names: Iterable[str]
) -> dict[str, tuple[bool, list[ComponentInfo] | str]]:
    """Return the same for several containers, by their names."""
    found: dict[str, tuple[bool, list[ComponentInfo] | str]] = {}
    for container in remote_containers_node_names:
        try:
            answer = _call(node, container, 'list_nodes')
        except _NoAnswer as error:
            found[container] = False, str(error)
        else:
            pairs = zip(answer.unique_ids, answer.full_node_names, strict=True)
            found[container] = True, [ComponentInfo(uid, name) for uid, name in pairs]
    return found


def load_component_into_container(
    *,
    node: Any,
    remote_container_node_name: str,
    package_name: str,
    plugin_name: str,
    node_name: str | None = None,
    node_namespace: str | None = None,
    log_level: int | None = None,
    remap_rules: Collection[str] | None = None,
    parameters: Collection[str] | None = None,
    extra_arguments: Collection[str] | None = None,
) -> tuple[int, str]:
    """
    Load a component; return its number in the container, and the full name of its node.

    :param remap_rules: each from:=to.
    :param parameters: each name:=value, as `extra_arguments`, which are for the container.
    :raises RuntimeError: if it cannot be loaded.
    """
    answer = _call(
        node,
        remote_container_node_name,
        'load_node',
        package_name=package_name,
        plugin_name=plugin_name,
        node_name=node_name or '',
        node_namespace=node_namespace or '',
        log_level=int(log_level or 0),
        remap_rules=list(remap_rules or ()),
        parameters=_parameters(parameters or ()),
        extra_arguments=_parameters(extra_arguments or ()),
    )
    if not answer.success:
        raise RuntimeError(f'Failed to load component: {answer.error_message.capitalize()}')
    return answer.unique_id, answer.full_node_name


def unload_component_from_container(
    *, node: Any, remote_container_node_name: str, component_uids: Iterable[int]
) -> Iterator[tuple[int, bool, str]]:
    """Unload components, one at each step; yield the number, whether that failed, and why."""
    for uid in component_uids:
        answer = _call(node, remote_container_node_name, 'unload_node', unique_id=uid)
        yield uid, not answer.success, answer.error_message


def _call(node: Any, container: str, verb: str, **fields: Any) -> Any:
    """Call a service; RuntimeError if the interfaces are not installed, _NoAnswer if there is no answer."""
    try:
        import composition_interfaces.srv
    except ModuleNotFoundError:
        raise RuntimeError(_NO_INTERFACES) from None
    service = getattr(composition_interfaces.srv, _SERVICES[verb])
    client = node.create_client(service, f'{container}/_container/{verb}')
    try:
        if not _spin(node, client.service_is_ready):
            raise _NoAnswer(f"No '{verb}' service found for '{container}' container")
        future = client.call_async(service.Request(**fields))
        if not _spin(node, future.done):
            raise _NoAnswer(f"No '{verb}' service response of '{container}' container")
        return future.result()
    finally:
        node.destroy_client(client)


def _spin(node: Any, until: Callable[[], bool]) -> bool:
    """Run callbacks until the condition holds, at most TIMEOUT seconds; of a command's node, or one of rclpy."""
    import rclpy
    from ros2cli.node.direct import DirectNode

    if isinstance(node, DirectNode):
        return node.spin(until=until, timeout=TIMEOUT)
    end = time.monotonic() + TIMEOUT
    while not until():
        if time.monotonic() >= end:
            return False
        rclpy.spin_once(node, executor=node.executor, timeout_sec=0.1)
    return True


def _parameters(texts: Iterable[str]) -> list[Any]:
    from rcl_interfaces.msg import Parameter
    from rclpy.parameter import get_parameter_value

    pairs = [text.partition(':=') for text in texts]
    return [Parameter(name=name, value=get_parameter_value(value)) for name, _, value in pairs]


def package_with_components_name_completer(**_: Any) -> list[str]:
    """Complete a package that has components."""
    return get_package_names_with_component_types()


def container_node_name_completer(parsed_args: Namespace, **_: Any) -> list[str]:
    """Complete a container that runs."""
    from ros2cli.node.strategy import NodeStrategy
    from ros2node.api import get_node_names

    with NodeStrategy(parsed_args) as node:
        names = find_container_node_names(node=node, node_names=get_node_names(node=node))
    return [each.full_name for each in names]


class ComponentTypeNameCompleter:
    """Completes a component of the package that the command line names."""

    def __init__(self, *, package_name_key: str) -> None:
        """Remember which argument names the package."""
        self.package_name_key = package_name_key

    def __call__(self, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the components."""
        return get_package_component_types(package_name=getattr(parsed_args, self.package_name_key))


def add_component_arguments(parser: ArgumentParser) -> None:
    """Add the arguments about the component and its node."""
    add: Any = parser.add_argument
    argument = add('package_name', help='Package of the component')
    argument.completer = package_with_components_name_completer
    argument = add('plugin_name', help='Name of the component, as `ros2 component types` prints it')
    argument.completer = ComponentTypeNameCompleter(package_name_key='package_name')
    add('-n', '--node-name', default='', help='Name of the node')
    add('--node-namespace', default='', help='Namespace of the node')
    add('--log-level', type=int, default=0, help='Level of the log of the node, as a number')
    add('-r', '--remap-rule', action='append', default=[], dest='remap_rules', help='Remapping')
    add('-p', '--parameter', action='append', default=[], dest='parameters', help='Parameter, name:=value')
    add(
        '-e',
        '--extra-argument',
        action='append',
        default=[],
        dest='extra_arguments',
        help='Argument for the container, name:=value',
    )
