"""The command `ros2 component`: what containers hold. Containers are programs of C++, on this machine or another."""

from ros2cli.command import CommandWithVerbs
from ros2cli.node.arguments import add_arguments
from ros2cli.verb import VerbExtension

_NO_INTERFACES = (
    "the package 'composition_interfaces' is not installed: put it into a workspace, build and source "
    'it, then try again'
)
_SERVICES = {'list_nodes': 'ListNodes', 'load_node': 'LoadNode', 'unload_node': 'UnloadNode'}  # of each container
_SERVICE_TIMEOUT = 10.0  # seconds


class ComponentCommand(CommandWithVerbs):
    """Various component related sub-commands."""

    VERB_GROUP = 'ros2component.verb'


def _containers(node):
    """Return the full names of the containers: the nodes that offer all services of one."""
    known = {(name, kind) for name, types in node.get_service_names_and_types() for kind in types}
    ending = '/_container/list_nodes'
    nodes = sorted(name.removesuffix(ending) for name, _ in known if name.endswith(ending))
    return [
        node
        for node in nodes
        if all(
            (f'{node}/_container/{verb}', f'composition_interfaces/srv/{kind}') in known
            for verb, kind in _SERVICES.items()
        )
    ]


def _call(node, container, verb, **fields):
    """Call a service of a container; RuntimeError if it does not answer, or the interfaces are not installed."""
    try:
        import composition_interfaces.srv
    except ModuleNotFoundError:
        raise RuntimeError(_NO_INTERFACES) from None
    service = getattr(composition_interfaces.srv, _SERVICES[verb])
    client = node.create_client(service, f'{container}/_container/{verb}')
    try:
        if not node.spin(until=client.service_is_ready, timeout=_SERVICE_TIMEOUT):
            raise RuntimeError(f"No '{verb}' service found for '{container}' container")
        return node.wait_for(client.call_async(service.Request(**fields)), _SERVICE_TIMEOUT)
    except TimeoutError:
        raise RuntimeError(f"No '{verb}' service response of '{container}' container") from None
    finally:
        node.destroy_client(client)


class ListVerb(VerbExtension):
    """Output a list of running containers and components."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('container_node_name', nargs='?', help='Name of one container; without it, of all')
        parser.add_argument('--containers-only', action='store_true', help='List only the containers')

    def main(self, *, args):
        """Print them."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            containers = _containers(node)
            one = args.container_node_name
            if one is not None:
                if one not in containers:
                    return f"Unable to find container node '{one}'"
                containers = [one]
            for container in containers:
                if one is None:
                    print(container)
                if not args.containers_only:
                    answer = _call(node, container, 'list_nodes')
                    for number, name in zip(answer.unique_ids, answer.full_node_names, strict=True):
                        print(f'{"" if one else "  "}{number}  {name}')


class TypesVerb(VerbExtension):
    """Output a list of components registered in the ament index."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('package_name', nargs='?', help='List only the components of this package')

    def main(self, *, args):
        """Print them by package."""
        from ament_index_python import get_resources

        components = get_resources('rclcpp_components')
        if args.package_name is not None:
            if args.package_name not in get_resources('packages'):
                return f"Unable to find package '{args.package_name}'"
            known = args.package_name in components
            print(*(_types(args.package_name) if known else ()), sep='\n')
            return None
        for package in components:
            print(package)
            print(*(f'  {name}' for name in _types(package)), sep='\n')


def _types(package):
    from ament_index_python import get_resource

    return [line.partition(';')[0] for line in get_resource('rclcpp_components', package)[0].splitlines()]


def _add_component(parser):
    """Add the arguments about the component and its node."""
    add = parser.add_argument
    add('package_name', help='Package of the component')
    add('plugin_name', help='Name of the component, as `ros2 component types` prints it')
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


class LoadVerb(VerbExtension):
    """Load a component into a container node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('container_node_name', help='Name of the container')
        _add_component(parser)
        parser.add_argument('-q', '--quiet', action='store_true', help='Print only the number and the name that it got')

    def main(self, *, args):
        """Load it, and print the name and the number that it got."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            if args.container_node_name not in _containers(node):
                return f"Unable to find container node '{args.container_node_name}'"
            answer = _call(
                node,
                args.container_node_name,
                'load_node',
                package_name=args.package_name,
                plugin_name=args.plugin_name,
                node_name=args.node_name,
                node_namespace=args.node_namespace,
                log_level=args.log_level,
                remap_rules=args.remap_rules,
                parameters=_parameters(args.parameters),
                extra_arguments=_parameters(args.extra_arguments),
            )
        if not answer.success:
            return f'Failed to load component: {answer.error_message.capitalize()}'
        if args.quiet:
            print(f'{answer.unique_id}  {answer.full_node_name}')
        else:
            print(
                f"Loaded component {answer.unique_id} into '{args.container_node_name}' container node as "
                f"'{answer.full_node_name}'"
            )


def _parameters(texts):
    """Return the messages of parameters name:=value."""
    from rcl_interfaces.msg import Parameter
    from rclpy.parameter import get_parameter_value

    pairs = [text.partition(':=') for text in texts]
    return [Parameter(name=name, value=get_parameter_value(value)) for name, _, value in pairs]


class UnloadVerb(VerbExtension):
    """Unload a component from a container node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('container_node_name', help='Name of the container')
        parser.add_argument('component_uid', type=int, nargs='+', help='Number of the component in the container')
        parser.add_argument('-q', '--quiet', action='store_true', help='Print only the numbers')

    def main(self, *, args):
        """Unload them, up to the first that cannot be."""
        from ros2cli.node.strategy import NodeStrategy

        container = args.container_node_name
        with NodeStrategy(args) as node:
            if container not in _containers(node):
                return f"Unable to find container node '{container}'"
            for number in args.component_uid:
                answer = _call(node, container, 'unload_node', unique_id=number)
                told = f"component {number} from '{container}' container node"
                if not answer.success:
                    return f'Failed to unload {told}\n    {answer.error_message.capitalize()}'
                print(number if args.quiet else f'Unloaded {told}')


class StandaloneVerb(VerbExtension):
    """Run a component into its own standalone container node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        _add_component(parser)
        parser.add_argument('-c', '--container-node-name', help='Name of the container')

    def main(self, *, args):
        """Say that there is no container of C++ here, as stock does without its package."""
        return "Package 'rclcpp_components' not found"
