"""Hidden tests of exercise 3.5, why is there no data?"""

from itertools import product

import pytest
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.5')

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
RELIABILITY, DURABILITY = ('BEST_EFFORT', 'RELIABLE'), ('VOLATILE', 'TRANSIENT_LOCAL')  # weak, strong


def endpoint(**changes):
    return {'topic': '/scan', 'type': 'sensor_msgs/msg/LaserScan', 'reliability': 'RELIABLE', 'durability': 'VOLATILE',
            'deadline': 0.0, 'depth': 5, **changes}


def ask(learner, offered, requested):
    got = learner.call('why_no_data', endpoint(**offered), endpoint(**requested))
    expect(isinstance(got, list), f'why_no_data returned {got!r}, expected a list, also when all fits.')
    return got


def described(offered, requested):
    first, second = endpoint(**offered), endpoint(**requested)
    return ', '.join(f'{key} {first[key]} → {second[key]}' for key in {**offered, **requested})


@pytest.mark.weight(2)
def test_all_pairs(learner):
    """Reliability and durability: all sixteen pairs of an offer and a request.

    Only a weak offer for a strong request is a reason.
    """
    for r1, d1, r2, d2 in product(range(2), repeat=4):
        offered = {'reliability': RELIABILITY[r1], 'durability': DURABILITY[d1]}
        requested = {'reliability': RELIABILITY[r2], 'durability': DURABILITY[d2]}
        wanted = [name for name, bad in (('reliability', r1 < r2), ('durability', d1 < d2)) if bad]
        got = ask(learner, offered, requested)
        expect(wanted or not got,
               f'{described(offered, requested)}: you name {got}, but an offer that is stronger than the '
               'request fits. Different is not incompatible.')
        expect(got == wanted, f'{described(offered, requested)}: you name {got}, expected {wanted}. '
                              'An offer must be at least as strong as the request.')


def test_deadline(learner):
    """The offered deadline period must not be longer than the requested one; 0.0 is endless.

    Replace 0.0 by infinity on both sides before you compare.
    """
    a, b = sorted(learner.random.sample([n / 20 for n in range(1, 40)], 2))
    for offered, requested, wanted in ((a, b, []), (b, a, ['deadline']), (a, a, []), (0.0, 0.0, [])):
        got = ask(learner, {'deadline': offered}, {'deadline': requested})
        expect(got == wanted,
               f'deadline {offered:g} s offered, {requested:g} s requested: you name {got}, expected {wanted}. '
               'The offered period must not be longer.')
    got = ask(learner, {'deadline': 0.0}, {'deadline': a})
    expect(got == ['deadline'],
           f'No deadline offered (0.0), {a:g} s requested: you name {got}. 0.0 is an endless period.')
    got = ask(learner, {'deadline': a}, {'deadline': 0.0})
    expect(got == [], f'{a:g} s offered, no deadline requested (0.0): you name {got}. Who asks for nothing is content.')


def test_names_and_types(learner):
    """Another topic or another type is a reason, by its exact text.

    '/Scan' and '/scan' are two topics.
    """
    for key, other in (('topic', '/Scan'), ('topic', '/front/scan'), ('type', 'sensor_msgs/msg/Range')):
        got = ask(learner, {key: other}, {})
        expect(got == [key], f'{key} {other} offered, {endpoint()[key]} requested: you name {got}, expected {[key]}.')


def test_depth_is_no_reason(learner):
    """Depth never prevents a connection.

    Each side keeps its own queue.
    """
    for depths in ((1, 100), (100, 1)):
        got = ask(learner, {'depth': depths[0]}, {'depth': depths[1]})
        expect(got == [],
               f'depth {depths[0]} offered, {depths[1]} requested: you name {got}. Depth is a private matter.')


def test_all_reasons(learner):
    """All reasons are named, in the order topic, type, reliability, durability, deadline.

    Do not stop at the first one.
    """
    offered = {'topic': '/a', 'type': 'std_msgs/msg/Bool', 'reliability': 'BEST_EFFORT', 'deadline': 2.0}
    requested = {'topic': '/b', 'durability': 'TRANSIENT_LOCAL', 'deadline': 1.0, 'depth': 1}
    wanted = ['topic', 'type', 'reliability', 'durability', 'deadline']
    got = ask(learner, offered, requested)
    expect(len(got) == 5, f'All five things differ for the worse; you name only {got}.')
    expect(got == wanted, f'You name {got}, expected the order {wanted}.')


@pytest.mark.weight(2)
def test_safety_stop(learner):
    """Every scan of a best-effort lidar is answered: True for an object nearer than 0.5 m.

    Ask on scan for no more than a lidar offers.
    """
    stop = learner.listen('/stop', Bool, LATCHED)
    lidar = learner.talk('/scan', LaserScan, qos_profile_sensor_data)
    learner.start('SafetyStop')
    wanted = [True, True, True, False, False, False]
    learner.random.shuffle(wanted)
    for near in wanted:
        ranges = [learner.random.uniform(0.6, 9.0) for _ in range(5)]
        if near:
            ranges.append(learner.random.uniform(0.05, 0.45))
        lidar.send(LaserScan(ranges=ranges))
        learner.run(0.1)
    expect(stop.messages, 'Scans were published and nothing came on /stop.')
    expect(stop.data == wanted, f'The answers to six scans are {stop.data}, expected {wanted}. The callback was right: '
                                'repair only the QoS.')


def test_late_driver(learner):
    """A motor driver that starts later gets the last command, and only that.

    RELIABLE, TRANSIENT_LOCAL, depth 1 on stop.
    """
    lidar = learner.talk('/scan', LaserScan, qos_profile_sensor_data)
    node = learner.start('SafetyStop')
    expect(node.name == '/safety_stop', f'The node is called {node.name}, expected /safety_stop.')
    for distance in (0.2, 3.0, 0.1):
        lidar.send(LaserScan(ranges=[distance]))
        learner.run(0.1)
    late = learner.late_listener('/stop', Bool)
    expect(late.messages, 'A driver that starts later knows nothing: the last command is not kept.')
    expect(late.data == [True], f'A driver that starts later gets {late.data}, expected only the last command, [True].')
