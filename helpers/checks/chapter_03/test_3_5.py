"""Visible tests of exercise 3.5, why is there no data?"""

import pytest
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.5')

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def endpoint(**changes):
    return {'topic': '/scan', 'type': 'sensor_msgs/msg/LaserScan', 'reliability': 'RELIABLE', 'durability': 'VOLATILE',
            'deadline': 0.0, 'depth': 5, **changes}


def ask(learner, offered, requested, wanted, hint):
    got = learner.call('why_no_data', endpoint(**offered), endpoint(**requested))
    expect(got == wanted, f'An offer with {offered or "defaults"} and a request with {requested or "defaults"} gives '
                          f'{got!r}, expected {wanted!r}. {hint}')


def test_equal_endpoints_fit(learner):
    """Two equal endpoints fit: the list is empty.

    Return a list, also when there is no reason.
    """
    ask(learner, {}, {}, [], '')


def test_weak_offer(learner):
    """A best-effort, volatile offer and a reliable, transient-local request give ['reliability', 'durability'].

    An offer must be at least as strong as the request.
    """
    ask(learner, {'reliability': 'BEST_EFFORT'}, {'reliability': 'RELIABLE', 'durability': 'TRANSIENT_LOCAL'},
        ['reliability', 'durability'], 'Name every policy that does not fit, in the order of the specification.')


def test_strong_offer(learner):
    """A reliable offer fits a best-effort request.

    Different is not incompatible: compare strengths.
    """
    ask(learner, {'reliability': 'RELIABLE'}, {'reliability': 'BEST_EFFORT'}, [],
        'A stronger offer fits: the rule is not "equal".')


def test_safety_stop(learner):
    """A scan with an object at 0.3 m makes SafetyStop say True, with the lidar's and the driver's QoS.

    Compare the QoS of both topics with what lidar and driver use; they need two different profiles.
    """
    stop = learner.listen('/stop', Bool, LATCHED)
    lidar = learner.talk('/scan', LaserScan, qos_profile_sensor_data)
    learner.start('SafetyStop')
    lidar.send(LaserScan(ranges=[2.0, 0.3, 4.0]))
    learner.run(0.1)
    expect(stop.messages, 'A scan was published and SafetyStop said nothing on /stop.')
    expect(stop.data == [True], f'An object at 0.3 m gave {stop.data} on /stop, expected [True].')
