"""Names of nodes, and what they offer."""

import sys
from argparse import Namespace
from collections.abc import Callable
from typing import Any, NamedTuple

from ros2cli.deferred import attributes_from

HIDDEN_NODE_PREFIX = '_'

INFO_NONUNIQUE_WARNING_TEMPLATE = (
    'There are {num_nodes} nodes in the graph with the exact name "{node_name}". '
    'You are seeing information about only one of them.'
)

__getattr__ = attributes_from({'NodeStrategy': 'ros2cli.node.strategy'}, module=__name__)

# The completers look names up here, so that a test can put something else in their place, as with upstream's modules.
_this = sys.modules[__name__]


class NodeName(NamedTuple):
    """The name of a node in its three forms."""

    name: str
    namespace: str
    full_name: str


class TopicInfo(NamedTuple):
    """A topic, service or action and its types."""

    name: str
    types: list[str]


def get_absolute_node_name(node_name: str | None) -> str | None:
    """Return the name with a slash in front; None for no name."""
    if not node_name:
        return None
    return node_name if node_name.startswith('/') else f'/{node_name}'


def parse_node_name(node_name: str) -> NodeName:
    """Split a full name."""
    full_name = get_absolute_node_name(node_name) or '/'
    namespace, _, name = full_name.rpartition('/')
    return NodeName(name, namespace or '/', full_name)


def has_duplicates(values: list[Any]) -> bool:
    """Return whether some value is there twice."""
    return len(set(values)) < len(values)


def get_node_names(*, node: Any, include_hidden_nodes: bool = False) -> list[NodeName]:
    """Return the nodes of the graph, hidden ones only if asked for."""
    return [
        NodeName(name, namespace, f'{namespace.rstrip("/")}/{name}')
        for name, namespace in node.get_node_names_and_namespaces()
        if include_hidden_nodes or (name and not name.startswith(HIDDEN_NODE_PREFIX))
    ]


def get_topics(
    remote_node_name: str, func: Callable[[str, str], Any], *, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return what a function of the name and the namespace of a node knows of it, hidden ones only if asked for."""
    remote = parse_node_name(remote_node_name)
    return [
        TopicInfo(name, types)
        for name, types in func(remote.name, remote.namespace)
        if include_hidden or not any(part.startswith(HIDDEN_NODE_PREFIX) for part in name.split('/'))
    ]


def get_subscriber_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Return what a node subscribes to."""
    return get_topics(remote_node_name, node.get_subscriber_names_and_types_by_node, include_hidden=include_hidden)


def get_publisher_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Return what a node publishes."""
    return get_topics(remote_node_name, node.get_publisher_names_and_types_by_node, include_hidden=include_hidden)


def get_service_server_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Return the services a node offers."""
    return get_topics(remote_node_name, node.get_service_names_and_types_by_node, include_hidden=include_hidden)


def get_service_client_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Return the services a node may call."""
    return get_topics(remote_node_name, node.get_client_names_and_types_by_node, include_hidden=include_hidden)


def get_action_server_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Return the actions a node offers."""
    return get_topics(remote_node_name, node.get_action_server_names_and_types_by_node, include_hidden=include_hidden)


def get_action_client_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Return the actions a node may send goals to."""
    return get_topics(remote_node_name, node.get_action_client_names_and_types_by_node, include_hidden=include_hidden)


class NodeNameCompleter:
    """Completes the names of nodes."""

    def __init__(self, *, include_hidden_nodes_key: str | None = None) -> None:
        """Remember which argument says whether hidden nodes count."""
        self.include_hidden_nodes_key = include_hidden_nodes_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the full names."""
        hidden = bool(self.include_hidden_nodes_key and getattr(parsed_args, self.include_hidden_nodes_key, False))
        with _this.NodeStrategy(parsed_args) as node:
            return [name.full_name for name in get_node_names(node=node, include_hidden_nodes=hidden)]
