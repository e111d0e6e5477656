"""Hidden tests of exercise 3.5, why is there no data?"""

import pytest
from std_msgs.msg import Bool

from helpers.checks.chapter_03 import stops
from helpers.checks.chapter_03.connections import check_pairs, mixed_pairs, single_pairs
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.5'), pytest.mark.wiring(type='rest', qos='stop', namespace='rest')]


@pytest.mark.weight(3)
@pytest.mark.rules('list', 'names', 'reliability', 'durability', 'deadline', 'no-deadline', 'depth')
def test_single_reasons(learner):
    """Pairs that differ in one key, from several beginnings.

    Only a weak offer for a strong request is a reason; 0.0 is an endless period; depth never matters.
    """
    with about('list'):
        for _ in range(4):
            check_pairs(learner, single_pairs(learner.random))


@pytest.mark.weight(2)
@pytest.mark.rules('all', 'order')
def test_all_reasons(learner):
    """All reasons are named, in the order topic, type, reliability, durability, deadline.

    Do not stop at the first one.
    """
    with about('list'):
        check_pairs(learner, single_pairs(learner.random))
        check_pairs(learner, mixed_pairs(learner.random, 20))


@pytest.mark.weight(2)
@pytest.mark.rules('scan', 'rest')
def test_safety_stop(learner):
    """Every scan of a best-effort lidar is answered: True for an object nearer than 0.5 m.

    Ask on scan for no more than a lidar offers.
    """
    stop, lidar, node = stops.start(learner, f'/base{learner.random.randint(2, 9)}')
    wanted = 4 * [True] + 4 * [False]
    learner.random.shuffle(wanted)
    for scan in stops.scans(learner.random, wanted):
        lidar.send(scan)
        with about('rest'):
            learner.run(0.1)
    expect(stop.messages, 'Scans were published and nothing came on stop.', 'scan')
    expect(len(stop) == len(wanted), f'{len(wanted)} scans gave {len(stop)} commands.', 'scan')
    expect(
        stop.data == wanted,
        f'The answers to eight scans are {stop.data}, expected {wanted}. The callback was right: repair only the QoS.',
        'rest',
    )
    stops.check_again(learner, lidar, stop, scan, wanted[-1])
    stops.check_silence(learner, stop)
    stops.check_unheard(learner, node, stop)
    stops.check_own_topic(learner, lidar, stop)


@pytest.mark.rules('stop')
def test_late_driver(learner):
    """A motor driver that starts later gets the last command, and only that.

    RELIABLE, TRANSIENT_LOCAL, depth 1 on stop.
    """
    _, lidar, _ = stops.start(learner, '')
    near = [learner.random.random() < 0.5 for _ in range(3)]
    for scan in stops.scans(learner.random, near):
        lidar.send(scan)
        with about('rest'):
            learner.run(0.1)
    late = learner.late_listener('/stop', Bool)
    expect(late.messages, 'A driver that starts later knows nothing: the last command is not kept.', 'stop')
    expect(len(late) == 1, f'A driver that starts later gets {late.data}, expected only the last command.', 'stop')
    expect(late.data == near[-1:], f'A driver that starts later gets {late.data}, expected {near[-1:]}.', 'rest')
