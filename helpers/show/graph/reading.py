"""Asking rclpy for the graph, as one node sees it."""

from rclpy.action.graph import get_action_client_names_and_types_by_node, get_action_server_names_and_types_by_node
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

from helpers.show.graph.links import Link
from helpers.show.graph.model import Graph

# What rclpy gives every node, or every node in simulated time.
_TOPICS = ('/rosout', '/parameter_events', '/clock')
_SERVICES = (
    'describe_parameters',
    'get_parameter_types',
    'get_parameters',
    'list_parameters',
    'set_parameters',
    'set_parameters_atomically',
    'get_type_description',
    'get_logger_levels',
    'set_logger_levels',
)


def read(node, namespace: str = '/', parameters: bool = False, hidden: bool = False) -> Graph:
    """Return the graph that `node` sees.

    :param node: a living node; it asks, and is left out itself if its name is hidden.
    :param namespace: only what stands in it, and what that is connected with.
    :param parameters: also what every node has: the services for parameters and the topics /rosout,
        /parameter_events and /clock.
    :param hidden: also names with a part that begins with an underscore, such as the parts of an action.
    """

    def shown(name: str) -> bool:
        usual = name in _TOPICS or name.rpartition('/')[2] in _SERVICES
        return (hidden or not topic_or_service_is_hidden(name)) and (parameters or not usual)

    names = [_join(space, name) for name, space in node.get_node_names_and_namespaces()]
    names = [name for name in names if hidden or not topic_or_service_is_hidden(name)]
    links = [*_topics(node, shown), *_others(node, set(names), shown)]
    links = [link for link in links if link.node in names]
    prefix = f'/{namespace.strip("/")}/'.replace('//', '/')
    links = [link for link in links if link.node.startswith(prefix) or link.name.startswith(prefix)]
    there = {link.node for link in links}
    names = [name for name in names if name.startswith(prefix) or name in there]
    unique = {link.key: link for link in links}
    return Graph(
        node.context.get_domain_id(),
        tuple(sorted(names)),
        tuple(unique[key] for key in sorted(unique)),
        prefix.rstrip('/') or '/',
    )


def _topics(node, shown):
    """The publishers and subscriptions: only topics tell the QoS."""
    for name, _ in node.get_topic_names_and_types():
        if not shown(name):
            continue
        for role, infos in (
            ('publisher', node.get_publishers_info_by_topic(name)),
            ('subscription', node.get_subscriptions_info_by_topic(name)),
        ):
            for info in infos:
                yield Link(_join(info.node_namespace, info.node_name), role, name, info.topic_type, info.qos_profile)


def _others(node, names: set[str], shown):
    """The servers and clients of services and actions."""
    for full in sorted(names):
        space, _, name = full.rpartition('/')
        space = space or '/'
        try:
            found = {
                'server': node.get_service_names_and_types_by_node(name, space),
                'client': node.get_client_names_and_types_by_node(name, space),
                'action server': get_action_server_names_and_types_by_node(node, name, space),
                'action client': get_action_client_names_and_types_by_node(node, name, space),
            }
        except RuntimeError:  # rclpy's RCLError: the node has just gone
            continue
        for role, pairs in found.items():
            for service, types in pairs:
                if shown(service):
                    yield from (Link(full, role, service, one) for one in types)


def _join(namespace: str, name: str) -> str:
    return f'{namespace.rstrip("/")}/{name}'
