"""Hidden tests of exercise 4.3, one question, two sources."""

import pytest
from std_srvs.srv import Trigger

from helpers.checks.chapter_04.test_4_3 import check_own_parts
from helpers.runner import about, expect, waiting

pytestmark = [pytest.mark.exercise('4.3'), pytest.mark.wiring(type='same-time', namespace='names')]

NEVER = 'status was never answered.'

SAID = {'battery': ' Is  für  東 °', 'lidar': ''}  # what the parts say, whatever it is
WANTED = f'battery: {SAID["battery"]}; lidar: {SAID["lidar"]}'


def panel(learner, battery_delay=0.0, lidar_delay=0.0, success=(True, True), namespace=''):
    parts = [
        learner.serve(f'{namespace}/{name}/check', Trigger, {'success': good, 'message': SAID[name]}, delay)
        for name, delay, good in zip(('battery', 'lidar'), (battery_delay, lidar_delay), success, strict=True)
    ]
    node = learner.start('StatusPanel', remap={'__ns': namespace} if namespace else None)
    return *parts, learner.client(f'{namespace}/status', Trigger), node


@pytest.mark.weight(3)
@pytest.mark.rules('same-time', 'fresh', 'message', 'one-thread')
@about('message')
@waiting('one-thread')
def test_both_at_the_same_time(learner):
    """The two parts are asked at the same time, so the slower one decides.

    First send both requests, then await both futures.
    """
    draw = learner.random
    battery, lidar, status, _ = panel(learner)
    learner.run(0.5)
    for delays in (draw.choice([(0.6, 0.4), (0.4, 0.6), (0.9, 0.2)]), draw.choice([(74.1, 62.6), (62.6, 74.1)])):
        battery.delay, lidar.delay = delays
        begin, words = learner.now / 1e9, f'The parts needed {delays[0]} and {delays[1]} s, '
        call = status.send()
        learner.run(max(delays) + 2.0, step=10.0)
        expect(call.done, NEVER, 'one-thread')
        asked = [
            round(stamp - begin, 3) for part in (battery, lidar) for stamp in part.stamps[-1:] if stamp > begin - 0.001
        ]
        expect(
            len(asked) == 2 or begin < 1.0,
            'status was called once more, and not both parts were asked again. Ask both each time.',
            'fresh',
        )
        expect(
            asked == [0.0, 0.0],
            f'The parts were asked {asked} s after the call of status, expected both at once. Ask both at the same '
            'time: first two call_async, then two await.',
            'same-time',
        )
        took = call.received - begin
        expect(
            call.response.message == WANTED,
            f'{words}the status came after {took:g} s with the message {call.response.message!r}, expected {WANTED!r} '
            f'after {max(delays)} s.',
            'message',
        )
        expect(
            took == pytest.approx(max(delays)), f'{words}the status {took:g} s, expected {max(delays)} s.', 'same-time'
        )


@pytest.mark.weight(2)
@pytest.mark.rules('message', 'one-thread')
@about('message')
@waiting('one-thread')
def test_order_of_the_message(learner):
    """The battery comes first in the message, whoever answers first.

    Put the message together after both answers are there.
    """
    for delays in ((0.5, 0.1), (0.1, 0.5)):
        battery, lidar, status, node = panel(learner, *delays)
        call = status.send()
        learner.run(1.0)
        expect(call.done, NEVER, 'one-thread')
        expect(
            call.response.message == WANTED,
            f'The answers came after {delays[0]} and {delays[1]} s; the message is {call.response.message!r}, '
            f'expected {WANTED!r}.',
            'message',
        )
        for peer in (battery, lidar, status):
            peer.close()
        node.stop()


@pytest.mark.rules('success', 'message', 'one-thread')
@about('message')
@waiting('one-thread')
@pytest.mark.parametrize('success', [(True, False), (False, True), (False, False), (True, True)], ids=str)
def test_success(learner, success):
    """success is True only if both parts have it.

    Use and, and the field success of both answers.
    """
    *_, status, _ = panel(learner, success=success)
    call = status.send()
    learner.run(0.5)
    expect(call.done, NEVER, 'one-thread')
    expect(
        call.response.success is all(success),
        f'The parts say {success[0]} and {success[1]}, the status says {call.response.success}.',
        'success',
    )
    expect(
        call.response.message == WANTED,
        f'The parts say {success[0]} and {success[1]}; the message of the status is {call.response.message!r}, '
        f'expected {WANTED!r}.',
        'message',
    )


@pytest.mark.rules('fresh', 'one-thread')
@about('message')
@waiting('one-thread')
def test_fresh_answers(learner):
    """Every call of status asks both parts anew, once.

    Keep no answer in the object.
    """
    battery, lidar, status, _ = panel(learner, 0.2, 0.1, success=(True, False))  # a refusal is an answer, too
    charge = learner.random.sample(range(100), 14)
    battery.answer = iter([{'success': True, 'message': f'{value} %'} for value in charge])
    for number, value in enumerate(charge, 1):
        call = status.send()
        learner.run(0.5)
        expect(call.done, NEVER, 'one-thread')
        expect(
            f'{value} %' in call.response.message,
            f'The battery says {value} % now, but the status says {call.response.message!r}: every caller gets '
            'fresh answers.',
            'fresh',
        )
        expect(
            len(battery.requests) == len(lidar.requests) == number,
            f'After {number} calls of status the battery was asked {len(battery.requests)} times, the lidar '
            f'{len(lidar.requests)} times.',
            'fresh',
        )


@pytest.mark.weight(2)
@pytest.mark.rules('callers', 'one-thread')
@about('message')
@waiting('one-thread')
def test_two_callers(learner):
    """Two callers at the same time get an answer each, from two requests to each part.

    What belongs to one call stays in local variables.
    """
    battery, lidar, status, _ = panel(learner, *learner.random.choice([(0.2, 0.4), (0.1, 0.5)]))
    said = [{'success': True, 'message': 'first'}, *[{'success': False, 'message': 'second'}] * 5]
    battery.answer = iter(said)  # more than there are callers: who asks again is answered
    lidar.answer = iter([{'success': True, 'message': word} for word in ('one', 'two', *['more'] * 4)])
    other, third = (learner.client('/status', Trigger) for _ in range(2))
    calls = [status.send(), other.send()]
    learner.run(2.0)
    expect(all(call.done for call in calls), NEVER, 'one-thread')
    expect(
        len(battery.requests) == len(lidar.requests) == 2,
        'Two callers: battery and lidar were asked '
        f'{len(battery.requests)} and {len(lidar.requests)} times, expected 2.',
        'callers',
    )
    told = sorted((call.response.message, call.response.success) for call in calls)
    expect(
        told == [('battery: first; lidar: one', True), ('battery: second; lidar: two', False)],
        f'The battery said first (success) and second (no success); two callers at the same time were told {told}: '
        'two calls share what belongs to one of them.',
        'callers',
    )
    _one_comes_later(learner, (battery, lidar), (status, other, third))


def _one_comes_later(learner, parts, clients):
    """Three callers, the third one while the requests of the others are open."""
    for part in parts:
        part.requests.clear()
        part.answer = iter([{'success': True, 'message': f'no. {number}'} for number in range(1, 7)])
    calls = [client.send() for client in clients[:2]]
    learner.run(0.05)
    calls.append(clients[2].send())
    learner.run(3.0)
    expect(all(call.done for call in calls), NEVER, 'one-thread')
    told = sorted(call.response.message for call in calls)
    expect(
        told == [f'battery: no. {number}; lidar: no. {number}' for number in (1, 2, 3)],
        f'Three callers asked, one of them 0.05 s later; the parts answered no. 1, no. 2 and no. 3; the callers were '
        f'told {told}: each request asks each part, also while another one is open.',
        'callers',
    )


@pytest.mark.rules('names', 'one-thread')
@about('message')
@waiting('one-thread')
def test_namespace(learner):
    """In a namespace all names move with the node, which is called status_panel.

    Relative names have no leading slash.
    """
    battery, lidar, status, node = panel(learner, namespace='/robot_3')
    expect(
        node.name == '/robot_3/status_panel',
        f'Your node is called {node.name}, expected /robot_3/status_panel.',
        'names',
    )
    call = status.send()
    learner.run(0.5)
    expect(
        battery.requests and lidar.requests,
        'In the namespace /robot_3 the parts in it were not asked: leave out the leading slash.',
        'names',
    )
    expect(call.done, NEVER, 'one-thread')
    check_own_parts(learner, node, status, (battery, lidar))
