"""Hidden tests of exercise 4.1, a patient client."""

import time

import pytest
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool

from helpers.checks.chapter_04.gripping import check_before_commands, check_script
from helpers.checks.chapter_04.test_4_1 import (
    check_bursts,
    check_constructor,
    check_late_server,
    test_one_try,  # noqa: F401 - they draw other inputs here
)
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('4.1'), pytest.mark.wiring(type='request', qos='request', namespace='names')]


def gripper(learner, answer, *args, delay=0.0, **options):
    states, close = learner.listen('/gripper_state', String), learner.talk('/close', Bool)
    server = learner.serve('/set_gripper', SetBool, answer, delay)
    learner.start('GripperClient', *args, **options)
    return states, close, server


@pytest.mark.weight(2)
@pytest.mark.rules('late', 'request')
@about('late')
def test_late_answers(learner):
    """An answer that comes after its timeout is ignored.

    In the done-callback, compare the future with the current one.
    """
    delays = iter([1.5, 0.3])
    states, close, server = gripper(
        learner, {'success': True, 'message': 'refused'}, delay=lambda request: next(delays, 9.0)
    )
    learner.run(0.2)
    close.send(Bool(data=True))
    learner.run(5.0)
    expect(
        server.stamps == pytest.approx([0.2, 1.2]),
        f'The first answer came after 1.5 s, the second in time; requests came at {server.stamps} s, expected at '
        '0.2 and 1.2 s.',
    )
    expect(
        states.data != ['ok', 'ok'],
        'One command is reported twice: the answer to the first request came after its '
        'timeout, and was reported as well.',
    )
    expect(states.data == ['ok'], f'gripper_state says {states.data}, expected one ok.')
    expect(
        states.stamps == pytest.approx([1.5]),
        f'ok came at {states.stamps} s, expected at 1.5 s, with the answer to the second request.',
    )


@pytest.mark.rules('request', 'answer', 'once', 'timeout', 'tries', 'refusal', 'late', 'newest')
@about('request')
def test_many_commands(learner):
    """Whenever commands and answers come, the rules say what is sent and what is reported."""
    check_script(learner, 18)


@pytest.mark.rules('late')
def test_only_late_answers(learner):
    """If every answer is late, the command has failed, once.

    After the last timeout there is no current future any more.
    """
    states, close, server = gripper(learner, {'success': True}, delay=1.7)
    close.send(Bool(data=False))
    learner.run(8.0)
    expect(states.data and states.data[0] != 'ok', 'An answer that came 0.7 s after its timeout was reported as ok.')
    expect(
        states.data == ['failed'],
        f'All answers were late; gripper_state says {states.data}, expected one failed: '
        'what comes after it is ignored.',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('request', 'timeout', 'tries', 'once')
@about('request')
def test_timeout_and_tries(learner):
    """timeout and tries are arguments.

    The last request has its full timeout, too, before the report is failed.
    """
    draw = learner.random
    timeout, tries, data = draw.choice([0.11, 0.25, 0.43]), draw.choice([2, 5, 6]), draw.choice([False, True])
    states, close, server = gripper(learner, None, timeout, tries)
    before = learner.slept  # by the constructor, which another test judges
    learner.run(0.7)
    words = f'GripperClient({timeout}, {tries}), a silent server, a command at 0.7 s: '
    check_before_commands(words, list(zip(states.stamps, states.data, strict=True)))
    close.send(Bool(data=data))
    with about('request'):
        learner.settle()
    expect(learner.slept <= before, 'A callback sleeps, and the whole node stands still meanwhile.', 'timeout')
    expect(server.stamps, 'A command made no request at once.', 'request')
    with about('timeout'):
        learner.run(timeout * (tries + 1) + 1.0)
    expect(
        all(request.data is data for request in server.requests),
        f'close said {data}, a request says {not data}.',
        'request',
    )
    wanted = [round(0.7 + n * timeout, 3) for n in range(tries)]
    seen = [round(stamp, 3) for stamp in server.stamps]
    expect(len(seen) > 1, f'{words}no second request came. When the timeout is over, send the next one.', 'timeout')
    expect(seen[:tries] == wanted[: len(seen)], f'{words}requests at {seen} s, expected at {wanted} s.', 'timeout')
    expect(
        len(seen) == tries,
        f'{words}{len(seen)} requests. tries counts all requests, not only the repetitions.',
        'tries',
    )
    expect(
        states.data == ['failed'] and states.stamps == pytest.approx([0.7 + tries * timeout]),
        f'{words}{states.data} at {states.stamps} s, expected failed at {0.7 + tries * timeout:g} s.',
        'tries',
    )


@pytest.mark.rules('refusal', 'answer')
@about('answer')
def test_a_refusal_is_an_answer(learner):
    """A refusal is reported at once, and not tried again.

    Only silence is a reason to try again.
    """
    states, close, server = gripper(learner, {'success': False, 'message': 'ok'}, delay=0.5)
    close.send(Bool(data=True))
    learner.run(4.0)
    expect(
        len(server.requests) == 1,
        f'The server refused, and was asked {len(server.requests)} times: a refusal is an answer, do not try again.',
        'refusal',
    )
    expect(
        states.data == ['refused'] and states.stamps == [0.5],
        f'A refusal at 0.5 s gave {states.data} at {states.stamps} s.',
        'answer',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('newest', 'request')
@about('newest')
def test_the_newest_command_wins(learner):
    """A new command drops the old one, without a report, and begins with all its tries.

    The new request becomes the current future; the timer and the counter start anew.
    """
    states, close, server = gripper(learner, lambda request: {'success': not request.data}, delay=0.8)
    learner.run(0.2)
    close.send(Bool(data=True))
    learner.run(0.5)
    close.send(Bool(data=False))
    learner.run(3.0)
    if [round(stamp, 3) for stamp in server.stamps] == [0.2, 0.7]:
        data = [request.data for request in server.requests]
        expect(data == [True, False], f'close said True, then False; the requests say {data}.', 'request')
    asked = [(round(stamp, 3), request.data) for stamp, request in zip(server.stamps, server.requests, strict=True)]
    expect(
        asked[:2] == [(0.2, True), (0.7, False)],
        f'Commands True at 0.2 s and False at 0.7 s made the requests {asked}: send a new command at once, also if '
        'an old one is open.',
    )
    expect('refused' not in states.data, 'A new command had come; then the answer to the old one was reported.')
    expect(
        states.data == ['ok'] and states.stamps == pytest.approx([1.5]),
        f'gripper_state says {states.data} at {states.stamps} s, expected ok at 1.5 s, for the new command only.',
    )
    server.answer = None
    for later, before in ((1.5, [0, 1]), (2.5, [0, 1, 2])):  # in the middle of the tries of the first, in the last one
        _two_for_a_silent_server(learner, states, close, server, later, before)
    server.answer = {'success': False}
    states.clear()
    begin = 0.0
    for pause in (0.6, 3.0):  # the same command twice
        close.send(Bool(data=True))
        learner.run(pause)
        begin = begin or server.stamps[-1]
    expect(
        states.data == ['refused'] and states.stamps == pytest.approx([begin + 1.4]),
        'The same command came twice, 0.6 s apart, and each request was answered after 0.8 s; the reports '
        f'{states.data} came {[round(stamp - begin, 3) for stamp in states.stamps]} s after the first command, '
        'expected one, after 1.4 s: an answer to the old command does not count for the new one.',
    )


def _two_for_a_silent_server(learner, states, close, server, later, before):
    """The same command twice, the second one `later`, when these requests (s) of the first one had gone out."""
    states.clear()
    server.stamps.clear()
    for _ in range(2):
        close.send(Bool(data=True))
        learner.run(later)
    learner.run(4.0)
    begin = server.stamps[0]
    expect(
        server.stamps == pytest.approx([begin + time for time in (*before, later, later + 1, later + 2)]),
        f'The second command came {later} s after the first; then requests went out '
        f'{[round(stamp - begin, 3) for stamp in server.stamps]} s after the first one. A new command has all its '
        'tries, and its timer starts anew.',
    )
    expect(
        states.data == ['failed'],
        f'Two commands, one after the other, to a silent server gave {states.data}, '
        'expected one failed, for the second.',
    )


@pytest.mark.rules('no-server')
def test_server_comes_later(learner):
    """The node starts without a server, and finds one that comes between two tries.

    Do not wait for the service in the constructor: a request to nobody is like one without an answer.
    """
    states, close = learner.listen('/gripper_state', String), learner.talk('/close', Bool)
    node = learner.start('GripperClient', 1.0, 3)
    check_constructor(learner)
    server = learner.serve('/set_gripper', SetBool, {'success': True})
    server.stop()
    before = learner.slept
    learner.run(0.5)
    close.send(Bool(data=True))
    learner.run(0.6)
    server.start()
    learner.run(3.0)
    expect(
        states.data == ['ok'] and states.stamps == pytest.approx([1.5]),
        f'A command at 0.5 s, a server from 1.1 s on: {states.data} at {states.stamps} s, expected ok at 1.5 s.',
    )
    server.stop()
    states.clear()
    begin = learner.now / 1e9
    close.send(Bool(data=False))
    learner.run(4.5)
    expect(
        states.data == ['failed'],
        f'Without a server, a command gave {states.data}, expected one failed: nobody answers three requests.',
    )
    expect(
        states.stamps == pytest.approx([begin + 3.0]),
        f'Without a server, failed came {states.stamps[0] - begin:g} s after the command, expected after 3 s, as with '
        'a silent server.',
    )
    expect(learner.slept <= before, 'Without a server, a callback waits for it, and the whole node stands still.')
    seconds = []
    while len(seconds) < 4 and min(seconds, default=1) >= 0.35:
        begin = time.monotonic()
        learner.start('GripperClient', beside=node)
        seconds.append(time.monotonic() - begin)
    expect(min(seconds) < 0.35, 'Without a server, the constructor takes long: it must not wait for the service.')


@pytest.mark.rules('no-server', 'tries')
@about('no-server')
def test_server_comes_at_last(learner):
    """With many tries, a server that comes before the last request gets it.

    Count the requests down from `tries`, whatever its number is.
    """
    states, close = learner.listen('/gripper_state', String), learner.talk('/close', Bool)
    begin, tries = learner.random.choice([0.3, 0.8]), learner.random.randint(34, 36)
    learner.start('GripperClient', 1.0, tries)
    learner.run(begin)
    close.send(Bool(data=True))
    learner.run(0.4)
    server = check_late_server(learner, states, begin, tries, '')
    expect(states.data or '/set_gripper' in server.theirs(), 'Your node has no client for /set_gripper.', 'names')


@pytest.mark.rules('queue', 'request', 'answer')
@about('queue')
def test_burst(learner):
    """Ten commands that come at one moment are kept, again and again.

    The depth of the subscription.
    """
    states, close, server = gripper(learner, None)
    check_bursts(learner, close, server, states)


@pytest.mark.rules('answer', 'once', 'request')
@about('answer')
def test_one_command_after_the_other(learner):
    """Every command is reported once, also after a failure.

    After a report nothing is left over: no timer that fires, no counter that is used up.
    """
    told = [learner.random.random() < 0.5 for _ in range(4)]
    # Whatever the message says, `success` counts.
    answers = [{'success': success, 'message': 'refused' if success else 'ok'} for success in told]
    states, close, server = gripper(learner, {})
    said = []
    for number, answer in enumerate(answers):
        server.answer = answer if number else None
        before = len(server.requests)
        close.send(Bool(data=number < 2))  # the same twice, then the other one twice
        learner.run(3.5)
        expect(len(server.requests) > before, f'Command {number + 1} made no request.', 'request')
        said.append('failed' if not number else 'ok' if answer['success'] else 'refused')
        wanted = said[-1]
        got = states.data[len(said) - 1 :]
        if number:
            expect(got and got[0] == wanted, f'Command {number + 1} gave {got}, expected [{wanted!r}].', 'answer')
        expect(len(got) == 1, f'Command {number + 1} gave {got}, expected one report.', 'once')
    expect(
        not any(answer['success'] for answer in answers[1:]) or len(server.requests) == 6,
        f'{len(server.requests)} requests were sent, expected 6.',
        'once',
    )


@pytest.mark.rules('names')
def test_names(learner):
    """The node is called gripper_client, and in a namespace all its names move with it.

    Relative names have no leading slash.
    """
    states, close = learner.listen('/left/gripper_state', String), learner.talk('/left/close', Bool)
    server = learner.serve('/left/set_gripper', SetBool, {'success': True})
    node = learner.start('GripperClient', remap={'__ns': '/left'})
    expect(node.name == '/left/gripper_client', f'Your node is called {node.name}, expected /left/gripper_client.')
    close.send(Bool(data=True))
    learner.run(0.2)
    expect(server.requests, 'In the namespace /left no request came to /left/set_gripper: leave out the leading slash.')
    expect(states.data == ['ok'], f'In the namespace /left, gripper_state says {states.data}, expected one ok.')
