"""The surroundings of the node SafetyStop: for exercise 3.5."""

import math

from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.checks.chapter_03.endpoints import check_lifespan, check_name, check_topic
from helpers.runner import expect

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def start(learner, space: str):
    """Lidar, SafetyStop and driver, in the namespace: what the driver hears, the lidar's publisher, and the node.

    :raises ExpectationFailed: they cannot be connected, or the node is another one than was given.
    """
    stop = learner.listen(f'{space}/stop', Bool, LATCHED, strict=False)
    node = learner.start('SafetyStop', remap={'__ns': space} if space else None)
    check_name(node, 'safety_stop', 'rest')
    check_topic(learner, 'publisher', space, 'stop', 'rest')
    check_topic(learner, 'subscription', space, 'scan', 'rest')
    theirs = learner.endpoints(f'{space}/scan').subscriptions[0]
    expect(
        not theirs.reliable,
        'Your subscription to scan requests RELIABLE, and the lidar offers BEST_EFFORT: no scan arrives. Ask for no '
        'more than is offered. (BEST_AVAILABLE asks for RELIABLE, too, if the lidar starts after your node.)',
        'scan',
    )
    expect(
        not theirs.latched,
        'Your subscription to scan requests TRANSIENT_LOCAL, and the lidar offers VOLATILE: no '
        'scan arrives. Ask for no more than is offered.',
        'scan',
    )
    limits = ', '.join(f'{policy} {value}' for policy, value in theirs.limits.items())
    expect(
        not limits,
        f'Your subscription to scan requests the policy {limits}, which the lidar does not offer: no scan arrives. Ask '
        'for no more than is offered.',
        'scan',
    )
    # Only now: a lidar may start later, and then it finds the request as it is.
    lidar = learner.talk(f'{space}/scan', LaserScan, qos_profile_sensor_data, strict=False)
    ours = learner.endpoints(f'{space}/stop').publishers[0]
    expect(
        ours.reliable,
        'Your publisher on stop offers BEST_EFFORT, and the driver requests RELIABLE: no command arrives.',
        'stop',
    )
    expect(
        ours.latched,
        'Your publisher on stop offers VOLATILE, and the driver requests TRANSIENT_LOCAL: no command arrives.',
        'stop',
    )
    check_lifespan(ours, 'stop')
    for kind, topic, depth in (('publisher', 'stop', 1), ('subscription', 'scan', 5)):
        found = learner.depths(kind, f'{space}/{topic}')
        expect(
            found == [depth],
            f'The depth of {topic} was {depth} and has become {", ".join(map(str, found))}: the depths were right.',
            'rest',
        )
    return stop, lidar, node


def scans(random, near: list[bool]) -> list[LaserScan]:
    """A scan for each entry, with an object nearer than 0.5 m or without; the limit itself is not near.

    The given callback has no special case: not for what is nearer than range_min, nor for an empty scan.
    """
    far = [0.505, *(random.uniform(0.6, 9.0) for _ in range(random.randint(700, 1500)))]  # as many as a real lidar has
    odd = {
        True: [[0.3, *far], [*far, 0.495], [-0.25, 2.0], [0.0, 3.0, math.nan]],
        False: [[], [0.5, math.nan, math.inf]],
    }
    made = []
    for is_near in near:
        ranges = [random.uniform(0.505, 9.0) for _ in range(random.randint(1, 6))]
        ranges.insert(random.randint(0, len(ranges)), random.uniform(0.15, 0.49) if is_near else 0.5)
        ranges = odd[is_near].pop() if odd[is_near] else ranges
        made.append(LaserScan(ranges=ranges, range_min=0.125, range_max=12.0))
    return made


def check_again(learner, lidar, stop, scan: LaserScan, is_near: bool) -> None:
    """The last scan comes again and again, as that of a robot that stands still: each time it is answered."""
    count = len(stop)
    lidar.send(scan)
    learner.run(0.1)
    expect(
        stop.data[count:] == [is_near],
        f'A scan came that is equal to the one before, and {stop.data[count:]} on stop, expected [{is_near}]. Each '
        'scan is answered. The callback was right: repair only the QoS.',
        'rest',
    )
    for _ in range(60):
        lidar.send(scan)
        learner.settle()
    more = len(stop) - count
    expect(
        more == 61,
        f'61 equal scans came after the others, and {more} commands on stop: each scan is answered, however many there '
        'were before. The callback was right: repair only the QoS.',
        'rest',
    )


def check_silence(learner, stop) -> None:
    """Nothing comes on stop without a scan, for a minute."""
    count = len(stop)
    learner.run(61.0, step=10.0)
    expect(
        len(stop) == count,
        f'No scan came for a minute, and {len(stop) - count} commands came on stop. The callback was right: repair '
        'only the QoS.',
        'rest',
    )


def check_unheard(learner, node, stop) -> None:
    """What a scan gave while nobody listened reaches a driver that starts later, of a stop in the namespace OTHER.

    :param node: the first stop, in whose program this one is made. :param stop: what the first one has said.
    """
    near, count = learner.random.choice([True, False]), len(stop)
    learner.start('SafetyStop', beside=node, remap={'__ns': OTHER})
    lidar = learner.talk(f'{OTHER}/scan', LaserScan, qos_profile_sensor_data, strict=False)
    learner.settle()
    lidar.send(LaserScan(ranges=[0.25 if near else 2.5]))
    learner.run(0.1)
    late = learner.late_listener(f'{OTHER}/stop', Bool, LATCHED)
    expect(
        late.data == [near] or len(stop) > count,  # who speaks on the topic of the first one is told so elsewhere
        f'A scan came when no driver listened yet; one that starts later gets {late.data}, expected [{near}]. Each '
        'scan is answered, also if nobody listens. The callback was right: repair only the QoS.',
        'stop',
    )


def check_own_topic(learner, lidar, stop) -> None:
    """A stop answers on its own topic, which is `stop`, when another one has been made in the namespace OTHER."""
    others = learner.listen(f'{OTHER}/stop', Bool, LATCHED, strict=False)
    learner.settle()
    for recorded in (stop, others):
        recorded.clear()
    lidar.send(LaserScan(ranges=[learner.random.uniform(1.0, 9.0)]))
    learner.run(0.1)
    check_own('SafetyStop', 'A scan came to the first one', len(stop), len(others), 'stop', 'publisher', 'rest')
