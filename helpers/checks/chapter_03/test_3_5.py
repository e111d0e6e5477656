"""Visible tests of exercise 3.5, why is there no data?"""

import pytest
from std_msgs.msg import Bool

from helpers.checks.chapter_03 import stops
from helpers.checks.chapter_03.connections import check_pairs, mixed_pairs, single_pairs
from helpers.checks.chapter_03.endpoints import robot
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.5'), pytest.mark.wiring(type='rest', qos='stop', namespace='rest')]


@pytest.mark.rules('list', 'all', 'order', 'names', 'reliability', 'durability', 'deadline', 'no-deadline', 'depth')
def test_why_no_data(learner):
    """why_no_data names all keys that prevent a connection, in the order of the specification.

    Go through the keys one after the other, and collect those that do not fit.
    """
    with about('list'):
        check_pairs(learner, single_pairs(learner.random))
        check_pairs(learner, mixed_pairs(learner.random, 5))


@pytest.mark.rules('scan', 'stop', 'rest')
def test_safety_stop(learner):
    """SafetyStop answers each scan of the lidar, and a driver that starts later gets the last command.

    Compare the QoS of both topics with what lidar and driver use; they need two different profiles.
    """
    random, space = learner.random, robot(learner.random)
    stop, lidar, node = stops.start(learner, space)
    near = random.choice([[True, False, True, True, False, True], [False, True, True, False, True, True]])
    for scan in stops.scans(random, near):
        lidar.send(scan)
        with about('rest'):
            learner.run(0.1)
    expect(stop.messages, 'Scans were published and SafetyStop said nothing on stop.', 'scan')
    expect(len(stop) == len(near), f'{len(near)} scans gave {len(stop)} commands on stop; each scan gives one.', 'scan')
    expect(
        stop.data == near,
        f'Scans of which {near} have an object nearer than 0.5 m gave {stop.data} on stop. The '
        'callback was right: repair only the QoS.',
        'rest',
    )
    late = learner.late_listener(f'{space}/stop', Bool)
    expect(
        late.data == near[-1:],
        f'A driver that starts later gets {late.data}, expected only the last command, {near[-1:]}.',
        'stop',
    )
    stops.check_again(learner, lidar, stop, scan, near[-1])
    stops.check_silence(learner, stop)
    stops.check_unheard(learner, node, stop)
    stops.check_own_topic(learner, lidar, stop)
