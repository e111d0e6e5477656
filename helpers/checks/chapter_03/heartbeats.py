"""Heartbeats that start at different times: for exercise 3.3."""

from std_msgs.msg import Bool, Int32

from helpers.checks.chapter_03.endpoints import check_topic, robot
from helpers.runner import expect, waiting


def check_starts(learner):
    """Two heartbeats, of which one starts a quarter of a second after the other, begin with True and with 1.

    Returns the second one.
    """
    space = robot(learner.random)
    with waiting('no-wait'):
        learner.run(learner.random.uniform(2.0, 9.0), step=10.0)
    for name in ('left', 'right'):  # the LED of somebody who looks at the clock is True for one of them only
        led, uptime = (
            learner.listen(f'{space}{name}/{topic}', kind) for topic, kind in (('led', Bool), ('uptime', Int32))
        )
        begin = learner.now / 1e9
        with waiting('no-wait'):
            node = learner.start('Heartbeat', remap={'__ns': f'{space}{name}'})
            learner.run(1.25, step=0.5)
        if not led.data and not uptime.data:  # who says nothing has not begun rightly
            check_topic(learner, 'publisher', f'{space}{name}', 'led', 'topics')
            expect(False, f'A heartbeat that starts at {begin:.2f} s of its clock says nothing in 1.25 s.', 'uptime')
        expect(
            not led.data or led.data[0],
            f'A heartbeat that starts at {begin:.2f} s of its clock begins with False on led. It begins with True, '
            'whenever it starts: keep the state in an attribute, and do not compute it from the time.',
            'led',
        )
        expect(
            not uptime.data or uptime.data[0] == 1,
            f'A heartbeat that starts at {begin:.2f} s of its clock begins with {uptime.data[:1]} on uptime, '
            'expected 1.',
            'uptime',
        )
    return node


def check_unheard(learner, node=None) -> None:
    """A heartbeat that nobody hears blinks and counts all the same: who begins to listen hears that.

    Other tests look at the rhythm; here only what one says who begins anew with its first listener.

    :param node: a heartbeat in whose program this one is made.
    """
    space, seconds = '/unheard', learner.random.randint(3, 6)
    with waiting('no-wait'):
        learner.start('Heartbeat', beside=node, remap={'__ns': space})
        learner.run(seconds + 0.35, step=0.5)  # the next message on led says False
    led, uptime = (learner.listen(f'{space}/{topic}', kind) for topic, kind in (('led', Bool), ('uptime', Int32)))
    learner.settle()
    with waiting('no-wait'):
        learner.run(0.5)
        blinked = led.data
        learner.run(0.5)
    words = f'Who begins to listen when a heartbeat has run for {seconds + 0.35} s hears '
    expect(
        blinked != [True, False],
        f'{words}True, False on led, expected False, True: the LED changes every 0.25 s, also if nobody listens.',
        'led',
    )
    expect(
        uptime.data != [1],
        f'{words}1 on uptime, expected {seconds + 1}: the seconds are counted also if nobody listens.',
        'uptime',
    )
