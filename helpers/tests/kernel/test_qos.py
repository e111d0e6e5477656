"""What a profile says, for pictures and for tests of exercises alike."""

import pytest
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

from helpers.kernel.qos import is_latched, is_reliable
from helpers.runner.wiring import Endpoint
from helpers.show.graph.links import Link


@pytest.mark.parametrize(
    ('policy', 'reliable'),
    [(ReliabilityPolicy.RELIABLE, True), (ReliabilityPolicy.BEST_EFFORT, False), (ReliabilityPolicy.UNKNOWN, False)],
)
def test_only_what_is_known_to_be_reliable_is(policy, reliable):
    qos = QoSProfile(depth=1, reliability=policy)
    assert is_reliable(qos) is reliable
    assert Link('/n', 'publisher', '/t', 'std_msgs/msg/String', qos).reliable is reliable
    assert Endpoint('publisher', '/t', '/n', 'std_msgs/msg/String', qos).reliable is reliable


def test_latched():
    assert is_latched(QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
    assert not is_latched(QoSProfile(depth=1))


def test_services_have_no_profile_and_lose_nothing():
    link = Link('/n', 'client', '/s', 'std_srvs/srv/Trigger')
    assert link.reliable and not link.latched
