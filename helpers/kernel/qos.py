"""QoS as the graph shows it: do two endpoints fit, and if not, which policies are in the way."""

from rclpy.duration import Duration
from rclpy.duration import Infinite as INFINITE
from rclpy.qos import (
    DurabilityPolicy,
    LivelinessPolicy,
    QoSCompatibility,
    QoSProfile,
    ReliabilityPolicy,
    qos_check_compatible,
)

_SILENT = ('UNKNOWN', 'SYSTEM_DEFAULT', 'BEST_AVAILABLE', 'AUTOMATIC')  # values that do not say what the endpoint does


def plain(qos: QoSProfile) -> QoSProfile:
    """The profile with "no limit" as an endpoint's maker writes it (0), not as the graph does (infinity)."""

    def limit(duration: Duration) -> Duration:
        return Duration() if duration.nanoseconds >= INFINITE.nanoseconds else duration

    return QoSProfile(
        history=qos.history,
        depth=qos.depth,
        reliability=qos.reliability,
        durability=qos.durability,
        liveliness=qos.liveliness,
        deadline=limit(qos.deadline),
        lifespan=limit(qos.lifespan),
        liveliness_lease_duration=limit(qos.liveliness_lease_duration),
    )


def fit(offered: QoSProfile, requested: QoSProfile) -> bool:
    """Whether rclpy sees a reason why nothing would flow from a publisher to a subscription with these profiles."""
    return qos_check_compatible(plain(offered), plain(requested))[0] != QoSCompatibility.ERROR


def mismatches(offered: QoSProfile, requested: QoSProfile) -> list[tuple[str, str, str]]:
    """The policies that are in the way: (policy, what the publisher offers, what the subscription asks for).

    Policies and their order of strength: "Quality of Service settings" in ROS 2's documentation.
    """
    offered, requested = plain(offered), plain(requested)
    found = [
        (policy, weak.name, strong.name)
        for policy, weak, strong in (
            ('reliability', ReliabilityPolicy.BEST_EFFORT, ReliabilityPolicy.RELIABLE),
            ('durability', DurabilityPolicy.VOLATILE, DurabilityPolicy.TRANSIENT_LOCAL),
            ('liveliness', LivelinessPolicy.AUTOMATIC, LivelinessPolicy.MANUAL_BY_TOPIC),
        )
        if (getattr(offered, policy), getattr(requested, policy)) == (weak, strong)
    ]
    for policy in ('deadline', 'liveliness_lease_duration'):
        offers, asks = getattr(offered, policy).nanoseconds, getattr(requested, policy).nanoseconds
        if asks and (not offers or offers > asks):
            found.append((policy.replace('_', ' '), seconds(offers), seconds(asks)))
    return found


def seconds(nanoseconds: int) -> str:
    """``'0.5 s'``; 0 and infinity are ``'no limit'``."""
    return f'{nanoseconds / 1e9:g} s' if 0 < nanoseconds < INFINITE.nanoseconds else 'no limit'


def is_reliable(qos: QoSProfile) -> bool:
    """Whether an endpoint is known to be RELIABLE; False while the graph does not know its policy."""
    return qos.reliability == ReliabilityPolicy.RELIABLE


def is_latched(qos: QoSProfile) -> bool:
    """Whether late joiners get the last messages: TRANSIENT_LOCAL durability."""
    return qos.durability == DurabilityPolicy.TRANSIENT_LOCAL


def words(qos: QoSProfile) -> list[str]:
    """What an endpoint's profile says, policy by policy; the graph does not know history and depth."""
    said = [
        f'{policy} {value.name}'
        for policy in ('reliability', 'durability')
        if (value := getattr(qos, policy)).name not in _SILENT
    ]
    return said + [f'{policy} {value}' for policy, value in limits(qos).items()]


def limits(qos: QoSProfile) -> dict[str, str]:
    """The policies on time that an endpoint has set, with their values: ``{'lifespan': '1 s'}``."""
    found = {'liveliness': qos.liveliness.name} if qos.liveliness.name not in _SILENT else {}
    for policy in ('deadline', 'lifespan', 'liveliness_lease_duration'):
        limit = seconds(getattr(qos, policy).nanoseconds)
        if limit != 'no limit':
            found[policy.replace('_', ' ')] = limit
    return found
