"""Quality of service on the command line, and the profile that hears all publishers of a topic."""

from argparse import ArgumentParser, Namespace
from typing import Any

from rclpy.duration import Duration
from rclpy.qos import (
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    QoSReliabilityPolicy,
)


def add_qos_arguments(parser: ArgumentParser, verb: str, default_profile: str = 'default', matched: str = '') -> None:
    """
    Add the options `--qos-…`.

    :param verb: `subscribe` or `publish`, for the help.
    :param default_profile: short name of the preset used without an option.
    :param matched: what reliability and durability are by default, if not those of the preset.
    """
    profile = QoSPresetProfiles.get_from_short_key(default_profile)

    def default(value: str) -> str:
        return f'instead of that of --qos-profile (default: {value})'

    parser.add_argument(
        '--qos-profile',
        choices=QoSPresetProfiles.short_keys(),
        default=default_profile,
        help=f'Preset quality of service to {verb} with (default: {default_profile})',
    )
    parser.add_argument(
        '--qos-depth', metavar='N', type=int, help=f'Queue length to {verb} with, {default(str(profile.depth))}'
    )
    parser.add_argument(
        '--qos-history',
        choices=QoSHistoryPolicy.short_keys(),
        help=f'Which samples to keep, {default(profile.history.short_key)}',
    )
    parser.add_argument(
        '--qos-reliability',
        choices=QoSReliabilityPolicy.short_keys(),
        help=f'Reliability to {verb} with, {default(matched or profile.reliability.short_key)}',
    )
    parser.add_argument(
        '--qos-durability',
        choices=QoSDurabilityPolicy.short_keys(),
        help=f'Durability to {verb} with, {default(matched or profile.durability.short_key)}',
    )
    parser.add_argument(
        '--qos-liveliness',
        choices=QoSLivelinessPolicy.short_keys(),
        help=f'Liveliness to {verb} with, {default(profile.liveliness.short_key)}',
    )
    parser.add_argument(
        '--qos-liveliness-lease-duration-seconds',
        type=float,
        help=f'Liveliness lease to {verb} with, in seconds, {default(str(profile.liveliness_lease_duration))}',
    )


def qos_profile_from_short_keys(
    preset_profile: str,
    reliability: str | None = None,
    durability: str | None = None,
    depth: int | None = None,
    history: str | None = None,
    liveliness: str | None = None,
    liveliness_lease_duration_s: float | None = None,
) -> QoSProfile:
    """Return a preset with some of its policies replaced."""
    profile = QoSPresetProfiles.get_from_short_key(preset_profile)
    profile_configure_short_keys(
        profile, reliability, durability, depth, history, liveliness, liveliness_lease_duration_s
    )
    return profile


def profile_configure_short_keys(
    profile: QoSProfile,
    reliability: str | None = None,
    durability: str | None = None,
    depth: int | None = None,
    history: str | None = None,
    liveliness: str | None = None,
    liveliness_lease_duration_s: float | None = None,
) -> None:
    """Replace some policies of a profile."""
    if history:
        profile.history = QoSHistoryPolicy.get_from_short_key(history)
    if durability:
        profile.durability = QoSDurabilityPolicy.get_from_short_key(durability)
    if reliability:
        profile.reliability = QoSReliabilityPolicy.get_from_short_key(reliability)
    if liveliness:
        profile.liveliness = QoSLivelinessPolicy.get_from_short_key(liveliness)
    if liveliness_lease_duration_s and liveliness_lease_duration_s >= 0:
        profile.liveliness_lease_duration = Duration(seconds=liveliness_lease_duration_s)
    if depth and depth >= 0:
        profile.depth = depth
    elif profile.durability == QoSDurabilityPolicy.TRANSIENT_LOCAL and profile.depth == 0:
        profile.depth = 1  # with none kept there is nothing for late joiners


def qos_profile_from_arguments(args: Namespace) -> QoSProfile:
    """Return the profile that the options `--qos-…` describe."""
    return qos_profile_from_short_keys(
        args.qos_profile,
        args.qos_reliability,
        args.qos_durability,
        args.qos_depth,
        args.qos_history,
        args.qos_liveliness,
        args.qos_liveliness_lease_duration_seconds,
    )


def choose_qos(node: Any, topic_name: str, args: Namespace) -> QoSProfile:
    """Return the profile of the options, or, without any, the strictest that still hears every publisher."""
    overrides = (
        args.qos_reliability,
        args.qos_durability,
        args.qos_depth,
        args.qos_history,
        args.qos_liveliness,
        args.qos_liveliness_lease_duration_seconds,
    )
    if any(value is not None for value in overrides):
        return qos_profile_from_arguments(args)
    profile = QoSPresetProfiles.get_from_short_key(args.qos_profile)
    offered = [info.qos_profile for info in node.get_publishers_info_by_topic(topic_name)]
    if not offered:
        return profile
    profile.reliability = _common(
        [qos.reliability for qos in offered], QoSReliabilityPolicy.RELIABLE, QoSReliabilityPolicy.BEST_EFFORT
    )
    profile.durability = _common(
        [qos.durability for qos in offered], QoSDurabilityPolicy.TRANSIENT_LOCAL, QoSDurabilityPolicy.VOLATILE
    )
    return profile


def _common(offered: Any, strict: Any, loose: Any) -> Any:
    if all(policy == strict for policy in offered):
        return strict
    if strict in offered:
        name = type(strict).__name__
        print(
            f'Some, but not all, publishers are offering {name}.{strict.name}. '
            f'Falling back to {name}.{loose.name} as it will connect to all publishers'
        )
    return loose
