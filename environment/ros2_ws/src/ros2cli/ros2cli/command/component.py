"""The command `ros2 component`: what containers hold. Containers are programs of C++, on this machine or another."""

import sys

from ros2cli.command import CommandWithVerbs
from ros2cli.node.arguments import add_arguments
from ros2cli.verb import VerbExtension

_NO_INTERFACES = (
    "the package 'composition_interfaces' is not installed: put it into a workspace, build and source "
    'it, then try again'
)
_SERVICE = 'composition_interfaces/srv/ListNodes'
_SERVICE_TIMEOUT = 10.0  # seconds


class ComponentCommand(CommandWithVerbs):
    """Various component related sub-commands."""

    VERB_GROUP = 'ros2component.verb'


def _containers(node):
    """Return the full names of the containers: the nodes that offer the service of one."""
    ending = '/_container/list_nodes'
    return sorted(
        name.removesuffix(ending)
        for name, types in node.get_service_names_and_types()
        if name.endswith(ending) and _SERVICE in types
    )


def _call(node, container, kind, verb, **fields):
    """Call a service of a container; RuntimeError if it does not answer, or the interfaces are not installed."""
    try:
        import composition_interfaces.srv
    except ModuleNotFoundError:
        raise RuntimeError(_NO_INTERFACES) from None
    service = getattr(composition_interfaces.srv, kind)
    client = node.create_client(service, f'{container}/_container/{verb}')
    try:
        node.spin(until=client.service_is_ready, timeout=_SERVICE_TIMEOUT)
        return node.wait_for(client.call_async(service.Request(**fields)), _SERVICE_TIMEOUT)
    except TimeoutError:
        raise RuntimeError(f"The container node '{container}' does not answer") from None


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
            if args.container_node_name is not None:
                wanted = _full(args.container_node_name)
                if wanted not in containers:
                    return f"Unable to find container node '{args.container_node_name}'"
                containers = [wanted]
            for container in containers:
                if args.container_node_name is None:
                    print(container)
                if not args.containers_only:
                    answer = _call(node, container, 'ListNodes', 'list_nodes')
                    for number, name in zip(answer.unique_ids, answer.full_node_names, strict=True):
                        print(f'  {number}  {name}')


class TypesVerb(VerbExtension):
    """Output a list of components registered in the ament index."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('package_name', nargs='?', help='List only the components of this package')

    def main(self, *, args):
        """Print them by package."""
        from ament_index_python import get_resource, get_resources

        packages = get_resources('rclcpp_components')
        if args.package_name is not None and args.package_name not in packages:
            return (
                f"Package '{args.package_name}' has no components"
                if args.package_name in get_resources('packages')
                else f"Package '{args.package_name}' not found"
            )
        for package in [args.package_name] if args.package_name else sorted(packages):
            print(package)
            content, _ = get_resource('rclcpp_components', package)
            for line in content.splitlines():
                print(f'  {line.partition(";")[0]}')


class LoadVerb(VerbExtension):
    """Load a component into a container node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('container_node_name', help='Name of the container')
        parser.add_argument('package_name', help='Package of the component')
        parser.add_argument('plugin_name', help='Name of the component, as `ros2 component types` prints it')
        parser.add_argument('-n', '--node-name', default='', help='Name of the node')
        parser.add_argument('--node-namespace', default='', help='Namespace of the node')
        parser.add_argument('-r', '--remap-rule', action='append', default=[], dest='remap_rules', help='Remapping')

    def main(self, *, args):
        """Load it, and print the name and the number that it got."""
        from ros2cli.node.strategy import NodeStrategy

        container = _full(args.container_node_name)
        with NodeStrategy(args) as node:
            if container not in _containers(node):
                return f"Unable to find container node '{args.container_node_name}'"
            answer = _call(
                node,
                container,
                'LoadNode',
                'load_node',
                package_name=args.package_name,
                plugin_name=args.plugin_name,
                node_name=args.node_name,
                node_namespace=args.node_namespace,
                remap_rules=args.remap_rules,
            )
        if not answer.success:
            return f'Failed to load component: {answer.error_message}'
        print(
            f"Loaded component {answer.unique_id} into '{args.container_node_name}' container node as "
            f"'{answer.full_node_name}'"
        )


class UnloadVerb(VerbExtension):
    """Unload a component from a container node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('container_node_name', help='Name of the container')
        parser.add_argument('component_uid', type=int, nargs='+', help='Number of the component in the container')

    def main(self, *, args):
        """Unload them."""
        from ros2cli.node.strategy import NodeStrategy

        container = _full(args.container_node_name)
        with NodeStrategy(args) as node:
            if container not in _containers(node):
                return f"Unable to find container node '{args.container_node_name}'"
            failed = False
            for number in args.component_uid:
                answer = _call(node, container, 'UnloadNode', 'unload_node', unique_id=number)
                if answer.success:
                    print(f"Unloaded component {number} from '{args.container_node_name}' container node")
                else:
                    failed = True
                    print(
                        f"Failed to unload component {number} from '{args.container_node_name}' container node\n"
                        f'    {answer.error_message}',
                        file=sys.stderr,
                    )
            return int(failed)


def _full(name):
    return name if name.startswith('/') else f'/{name}'
