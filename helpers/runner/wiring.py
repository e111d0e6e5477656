"""Who is connected with whom, and why not: what the graph knows, in a learner's words."""

from collections.abc import Iterable
from dataclasses import dataclass

from rclpy.qos import QoSProfile

from helpers.kernel.qos import fit, is_latched, is_reliable, limits, mismatches
from helpers.runner.values import type_name
from helpers.runner.verdicts import WiringError


@dataclass(frozen=True)
class Endpoint:
    """A publisher or subscription of the learner's, as the graph shows it."""

    kind: str  # 'publisher' or 'subscription'
    topic: str
    node: str  # fully qualified
    type: str  # as std_msgs/msg/String
    qos: QoSProfile

    @property
    def reliable(self) -> bool:
        return is_reliable(self.qos)

    @property
    def latched(self) -> bool:
        """TRANSIENT_LOCAL durability: late joiners get the last messages."""
        return is_latched(self.qos)

    @property
    def limits(self) -> dict[str, str]:
        """Its policies on time, as ``{'lifespan': '1 s'}``; empty if none is set."""
        return limits(self.qos)


@dataclass(frozen=True)
class Endpoints:
    """The learner's endpoints on one topic."""

    publishers: list[Endpoint]
    subscriptions: list[Endpoint]


def endpoints(node, topic: str, foreign) -> Endpoints:
    """The endpoints on `topic` for which `foreign(info)` is true, in a stable order."""

    def of(kind, infos):
        found = [
            Endpoint(
                kind, topic, f'{info.node_namespace.rstrip("/")}/{info.node_name}', info.topic_type, info.qos_profile
            )
            for info in infos
            if foreign(info)
        ]
        return sorted(found, key=lambda endpoint: (endpoint.node, endpoint.type))

    return Endpoints(
        of('publisher', node.get_publishers_info_by_topic(topic)),
        of('subscription', node.get_subscriptions_info_by_topic(topic)),
    )


def check(ours, kind: str, learners: list[Endpoint]) -> None:
    """Raise WiringError if nothing can flow between our endpoint and the learner's opposite ones on its topic.

    `ours` is the tests' subscription or publisher, `kind` what the learner's are: 'publisher' or 'subscription'.
    """
    expected = type_name(ours.msg_type)
    for endpoint in learners:
        if endpoint.type != expected:
            raise WiringError(
                f'{endpoint.topic} must carry {expected}; your {kind} there has the type '
                f'{endpoint.type}. Endpoints of different types are never connected.',
                'type',
            )
        offered, requested = (
            (endpoint.qos, ours.qos_profile) if kind == 'publisher' else (ours.qos_profile, endpoint.qos)
        )
        if not fit(offered, requested):
            raise WiringError(_incompatible(endpoint, kind, offered, requested), 'qos')


def check_namespaces(namespaces: Iterable[str]) -> None:
    """Raise WiringError if a node has got a namespace from its own constructor: cards name relative names only."""
    for namespace in filter(None, namespaces):
        raise WiringError(
            f'Your node gives itself the namespace {namespace[:80]!r}, so all its relative names begin with it. Leave '
            '`namespace` out of super().__init__: who starts the node chooses the namespace.',
            'namespace',
        )


def _incompatible(endpoint: Endpoint, kind: str, offered: QoSProfile, requested: QoSProfile) -> str:
    pairs = mismatches(offered, requested)
    if not pairs:
        return (
            f'The QoS of your {kind} on {endpoint.topic} is incompatible with what is asked for there (look at '
            'deadline, lifespan and liveliness): nothing is delivered.'
        )
    policy, weak, strong = pairs[0]
    if kind == 'publisher':
        return (
            f'Your publisher on {endpoint.topic} offers {policy} {weak}, the subscription asks for {strong}: '
            'they are incompatible and nothing is delivered. Offer what is asked for.'
        )
    return (
        f'Your subscription on {endpoint.topic} asks for {policy} {strong}, the publisher offers {weak}: '
        'they are incompatible and nothing is delivered. Ask for no more than is offered.'
    )


def nearby(node, topic: str, kind: str, own_nodes: list[tuple[str, str]]) -> str:
    """Which topics of this kind the learner's nodes have instead of `topic`; '' if none."""
    found = set()
    for name, namespace in own_nodes:
        ask = (
            node.get_publisher_names_and_types_by_node
            if kind == 'publisher'
            else node.get_subscriber_names_and_types_by_node
        )
        try:
            found |= {
                f'{found_topic} ({types[0]})'
                for found_topic, types in ask(name, namespace)
                if found_topic not in ('/rosout', '/parameter_events', '/clock', topic)
            }
        except Exception:  # noqa: BLE001 - the node has gone: there is nothing to tell
            continue
    return ', '.join(sorted(found))
