"""The command `ros2 component`: what containers hold. Containers are programs of C++, on this machine or another."""

from ros2component.api import (
    add_component_arguments,
    container_node_name_completer,
    find_container_node_names,
    get_components_in_container,
    get_package_component_types,
    get_registered_component_types,
    load_component_into_container,
    package_with_components_name_completer,
    unload_component_from_container,
)

from ros2cli.command import CommandWithVerbs
from ros2cli.node.arguments import add_arguments
from ros2cli.verb import VerbExtension


class ComponentCommand(CommandWithVerbs):
    """Various component related sub-commands."""

    VERB_GROUP = 'ros2component.verb'


def _containers(node):
    """Return the full names of the containers, in order."""
    from ros2node.api import get_node_names

    names = get_node_names(node=node, include_hidden_nodes=True)
    return sorted(each.full_name for each in find_container_node_names(node=node, node_names=names))


def _add_container(parser, **kwargs):
    """Add the argument that names a container."""
    argument = parser.add_argument('container_node_name', **kwargs)
    argument.completer = container_node_name_completer


class ListVerb(VerbExtension):
    """Output a list of running containers and components."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        _add_container(parser, nargs='?', help='Name of one container; without it, of all')
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
                if args.containers_only:
                    continue
                known, found = get_components_in_container(node=node, remote_container_node_name=container)
                if not known:
                    return found
                for component in found:
                    print(f'{"" if one else "  "}{component.uid}  {component.name}')


class TypesVerb(VerbExtension):
    """Output a list of components registered in the ament index."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        argument = parser.add_argument('package_name', nargs='?', help='List only the components of this package')
        argument.completer = package_with_components_name_completer

    def main(self, *, args):
        """Print them by package."""
        from ament_index_python import get_resources

        if args.package_name is not None:
            if args.package_name not in get_resources('packages'):
                return f"Unable to find package '{args.package_name}'"
            print(*get_package_component_types(package_name=args.package_name), sep='\n')
            return None
        for package, names in get_registered_component_types():
            print(package)
            print(*(f'  {name}' for name in names), sep='\n')


class LoadVerb(VerbExtension):
    """Load a component into a container node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        _add_container(parser, help='Name of the container')
        add_component_arguments(parser)
        parser.add_argument('-q', '--quiet', action='store_true', help='Print only the number and the name that it got')

    def main(self, *, args):
        """Load it, and print the name and the number that it got."""
        from ros2cli.node.strategy import NodeStrategy

        container = args.container_node_name
        with NodeStrategy(args) as node:
            if container not in _containers(node):
                return f"Unable to find container node '{container}'"
            uid, name = load_component_into_container(
                node=node,
                remote_container_node_name=container,
                package_name=args.package_name,
                plugin_name=args.plugin_name,
                node_name=args.node_name,
                node_namespace=args.node_namespace,
                log_level=args.log_level,
                remap_rules=args.remap_rules,
                parameters=args.parameters,
                extra_arguments=args.extra_arguments,
            )
        if args.quiet:
            print(f'{uid}  {name}')
        else:
            print(f"Loaded component {uid} into '{container}' container node as '{name}'")


class UnloadVerb(VerbExtension):
    """Unload a component from a container node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        _add_container(parser, help='Name of the container')
        parser.add_argument('component_uid', type=int, nargs='+', help='Number of the component in the container')
        parser.add_argument('-q', '--quiet', action='store_true', help='Print only the numbers')

    def main(self, *, args):
        """Unload them, up to the first that cannot be."""
        from ros2cli.node.strategy import NodeStrategy

        container = args.container_node_name
        with NodeStrategy(args) as node:
            if container not in _containers(node):
                return f"Unable to find container node '{container}'"
            for uid, failed, reason in unload_component_from_container(
                node=node, remote_container_node_name=container, component_uids=args.component_uid
            ):
                told = f"component {uid} from '{container}' container node"
                if failed:
                    return f'Failed to unload {told}\n    {reason.capitalize()}'
                print(uid if args.quiet else f'Unloaded {told}')


class StandaloneVerb(VerbExtension):
    """Run a component into its own standalone container node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        add_component_arguments(parser)
        parser.add_argument('-c', '--container-node-name', help='Name of the container')

    def main(self, *, args):
        """Say that there is no container of C++ here, as stock does without its package."""
        return "Package 'rclcpp_components' not found"
