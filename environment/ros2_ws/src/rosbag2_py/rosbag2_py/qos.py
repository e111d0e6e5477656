"""Quality of service in rclpy's form and in that of the library rosbags."""

from enum import Enum
from typing import Any

from rclpy.duration import Duration
from rclpy.qos import (
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSPolicyEnum,
    QoSProfile,
    QoSReliabilityPolicy,
)
from rosbags.interfaces import Qos, QosDurability, QosHistory, QosLiveliness, QosReliability, QosTime

_SECOND = 1_000_000_000


def to_rosbags(profile: QoSProfile) -> Qos:
    """Convert to rosbags."""
    return Qos(
        _policy(QosHistory, profile.history),
        profile.depth,
        _policy(QosReliability, profile.reliability),
        _policy(QosDurability, profile.durability),
        _time(profile.deadline),
        _time(profile.lifespan),
        _policy(QosLiveliness, profile.liveliness),
        _time(profile.liveliness_lease_duration),
        profile.avoid_ros_namespace_conventions,
    )


def to_rclpy(qos: Qos) -> QoSProfile:
    """Convert to rclpy."""
    return QoSProfile(
        history=_policy(QoSHistoryPolicy, qos.history),
        depth=qos.depth,
        reliability=_policy(QoSReliabilityPolicy, qos.reliability),
        durability=_policy(QoSDurabilityPolicy, qos.durability),
        deadline=_duration(qos.deadline),
        lifespan=_duration(qos.lifespan),
        liveliness=_policy(QoSLivelinessPolicy, qos.liveliness),
        liveliness_lease_duration=_duration(qos.liveliness_lease_duration),
        avoid_ros_namespace_conventions=qos.avoid_ros_namespace_conventions,
    )


def _policy(kind: type[Enum] | type[QoSPolicyEnum], policy: Any) -> Any:
    """Return the policy with the same name; rmw's numbers and names are those of both."""
    return getattr(kind, policy.name, kind.UNKNOWN)


def _time(duration: Duration) -> QosTime:
    return QosTime(*divmod(duration.nanoseconds, _SECOND))


def _duration(time: QosTime) -> Duration:
    return Duration(nanoseconds=min(time.sec * _SECOND + time.nsec, 2**63 - 1))


def to_hear(offered: list[QoSProfile]) -> QoSProfile:
    """Return the strictest profile that hears every one of these publishers."""
    profile = QoSProfile(depth=max([10, *(each.depth for each in offered)]))
    if any(each.reliability != QoSReliabilityPolicy.RELIABLE for each in offered):
        profile.reliability = QoSReliabilityPolicy.BEST_EFFORT
    if offered and all(each.durability == QoSDurabilityPolicy.TRANSIENT_LOCAL for each in offered):
        profile.durability = QoSDurabilityPolicy.TRANSIENT_LOCAL
    return profile


def to_publish(recorded: list[QoSProfile]) -> QoSProfile:
    """Return the profile to publish with: what all recorded publishers had in common, otherwise the default."""
    profile = QoSProfile(depth=max([10, *(each.depth for each in recorded)]))
    for name, unknown in (('reliability', QoSReliabilityPolicy.UNKNOWN), ('durability', QoSDurabilityPolicy.UNKNOWN)):
        policies = {getattr(each, name) for each in recorded}
        if len(policies) == 1 and unknown not in policies:
            setattr(profile, name, policies.pop())
    return profile
