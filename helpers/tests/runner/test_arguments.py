"""What a call has changed of its arguments, where they are messages."""

import random

from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import LaserScan

from helpers.runner.arguments import Arguments


def function(messages):
    """Stands for a learner's."""


def transforms(draw):
    found = []
    for _ in range(5):
        transform = TransformStamped(child_frame_id='x' * draw.randint(1, 9))
        transform.header.frame_id = 'y' * draw.randint(1, 9)
        found.append(transform)
    return found


def test_messages_that_nobody_touches_have_not_changed():
    """Their bytes have gaps of up to seven bytes, which hold whatever stood there before."""
    draw = random.Random(7)
    for _ in range(300):
        arguments = Arguments(function, [transforms(draw)], {})
        assert arguments.changed('given') == []


def test_a_field_that_is_set_is_a_change():
    for touch in (
        lambda messages: setattr(messages[3].header.stamp, 'nanosec', 1),
        lambda messages: setattr(messages[0].transform.rotation, 'x', 0.5),
        lambda messages: messages.pop(),
        lambda messages: messages.append(messages[0]),
    ):
        messages = transforms(random.Random(8))
        arguments = Arguments(function, [messages], {})
        touch(messages)
        assert arguments.changed('given') == ['messages']


def test_arrays_count_and_nan_is_equal_to_itself():
    scans = {'scan': LaserScan(ranges=[1.0, float('nan')])}
    arguments = Arguments(function, [scans], {})
    assert arguments.changed('given') == []
    scans['scan'].ranges[0] = 2.0
    assert arguments.changed('given') == ['messages']


def test_a_list_that_is_put_into_itself_is_a_change():
    values = [1]
    arguments = Arguments(function, [values], {})
    values.append(values)
    assert arguments.changed('given') == ['messages']
