"""Visible tests of exercise 4.1, a patient client."""

import time

import pytest
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool

from helpers.checks.chapter_04.gripping import check_before_commands, check_own_state, check_script
from helpers.checks.chapter_04.names import check_names
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('4.1'), pytest.mark.wiring(type='request', qos='request', namespace='names')]


SLEEPS = (
    'A callback sleeps, and the whole node stands still meanwhile: no answer can come in. The waiting is done by a '
    'timer.'
)


class Gripper:
    """The learner's client, with its `server`, what the tests `close` it by, and the `states` that it reports."""

    def __init__(self, learner, answer, *args, delay=0.0):
        self.learner = learner
        self.states, self.close = learner.listen('/gripper_state', String), learner.talk('/close', Bool, 100)
        self.server = learner.serve('/set_gripper', SetBool, answer, delay)
        self.commands = 0  # so many have been given by `command`
        self.node = learner.start('GripperClient', *args)
        self._before = learner.slept  # by the constructor, which another test judges

    def judge_sleep(self):
        """No callback may sleep."""
        expect(self.learner.slept <= self._before, SLEEPS, 'timeout')

    def command(self, data, seconds, rule):
        """Send a command, and let this time pass; returns how many requests it made, at least one."""
        self.states.clear()
        self.server.stamps.clear()
        self.close.send(Bool(data=data))
        with about(rule):
            self.learner.run(seconds, step=max(1.0, seconds / 40))
        self.judge_sleep()
        expect(
            self.server.stamps,
            f'After {self.commands} commands the next one made no request.'
            if self.commands
            else 'A command came on /close, and no request came to the service set_gripper.',
            'request',
            hint=True,
        )
        expect(
            self.server.requests[-1].data is data,
            f'close said {data}, the request says {not data}: send the same data.',
            'request',
        )
        self.commands += 1
        return len(self.server.stamps)


@pytest.mark.rules('request', 'timeout', 'tries', 'once')
@about('request')
def test_silent_server(learner):
    """A silent server is asked `tries` times, `timeout` seconds apart, and then the report is failed.

    A timer with the period `timeout` tells when an answer is overdue.
    """
    draw = learner.random
    timeout, tries, begin = draw.choice([0.12, 0.34, 0.45]), draw.choice([4, 5]), draw.choice([0.7, 1.3, 2.2])
    data = draw.choice([False, True])
    gripper = Gripper(learner, None, timeout, tries)
    states, server = gripper.states, gripper.server
    learner.run(begin)
    words = f'GripperClient({timeout}, {tries}), a silent server, a command at {begin} s: '
    check_before_commands(words, list(zip(states.stamps, states.data, strict=True)))
    gripper.close.send(Bool(data=data))
    with about('request'):
        learner.settle()
    gripper.judge_sleep()
    expect(
        server.stamps,
        'A command came on /close, and no request came to the service set_gripper at once.',
        'request',
        hint=True,
    )
    expect(
        server.requests[0].data is data,
        f'close said {data}, but the request says {not data}: send the same data.',
        'request',
    )
    expect(
        len(server.stamps) == 1,
        f'{words}{len(server.stamps)} requests at once. The next one comes after the timeout of the first.',
        'timeout',
    )
    expect(not states.messages, f'{words}{states.data} was reported at once: a request has {timeout} s.', 'tries')
    with about('timeout'):
        learner.run(timeout * (tries + 2) + 1.0, step=1.0)  # longer than most periods that somebody writes down
    expect(
        len(server.stamps) > 1,
        f'{words}no second request came. When the timeout is over, send the next one. It is '
        "in seconds of the node's clock.",
        'timeout',
    )
    wanted = [round(begin + n * timeout, 3) for n in range(tries)]
    seen = [round(stamp, 3) for stamp in server.stamps]
    expect(seen[:tries] == wanted[: len(seen)], f'{words}requests at {seen} s, expected at {wanted} s.', 'timeout')
    expect(
        len(seen) == tries,
        f'{words}{len(seen)} requests. `tries` is the number of all requests, the first one included.',
        'tries',
    )
    end = round(begin + tries * timeout, 3)
    expect(set(states.data) == {'failed'}, f"{words}gripper_state says {states.data}, expected ['failed'].", 'tries')
    expect(
        [round(stamp, 3) for stamp in states.stamps] == [end],
        f'{words}failed came at {[round(stamp, 3) for stamp in states.stamps]} s, expected once, at {end} s: the '
        f'last request has its {timeout} s, too.',
        'tries',
    )


@pytest.mark.rules('tries', 'timeout', 'request', 'answer')
@about('tries')
def test_one_try(learner):
    """With tries=1 there is one request, and after its timeout the report.

    Also the first request counts.
    """
    check_two_clients(check_one_try(learner))
    check_own_state(learner)


def check_one_try(learner) -> Gripper:
    """A silent server, asked by a client with one try; returns it."""
    timeout = learner.random.choice([70.5, 92.5, 215.5])  # a long one is a number like any other
    gripper = Gripper(learner, None, timeout, 1)
    count = gripper.command(True, 3 * timeout + 1.0, 'request')
    words = f'GripperClient({timeout}, 1), a silent server, one command: '
    expect(count == 1, f'{words}{count} requests came, expected one. `tries` is the number of all requests.', 'tries')
    states, took = gripper.states.data, [stamp - gripper.server.stamps[0] for stamp in gripper.states.stamps]
    expect(states == ['failed'], f"{words}gripper_state says {states}, expected ['failed'].", 'tries')
    expect(
        took == pytest.approx([timeout]),
        f'{words}failed came {took[0]:g} s after the request, expected after {timeout} s.',
        'timeout',
    )
    return gripper


def check_two_clients(gripper) -> None:
    """Two clients in one program hear one command: each of them sends its request, and reports its answer."""
    learner, server, data = gripper.learner, gripper.server, gripper.learner.random.choice([False, True])
    learner.start('GripperClient', beside=gripper.node)
    server.answer, server.delay = {'success': True}, 0.2
    count = gripper.command(data, 0.35, 'answer')
    expect(
        'failed' not in gripper.states.data,
        'One client has one try, the other one three, and the server said yes to both after 0.2 s. gripper_state says '
        f'{gripper.states.data}: failed comes only when the timeout of the last request is over.',
        'tries',
    )
    expect(
        gripper.states.data or count != 2,
        'Two objects of your class in one program heard the same command, the server said yes to both requests, and '
        'nothing came on gripper_state. Is the answer looked at: has the future of each request a done-callback '
        '(add_done_callback), or an await?',
        'answer',
    )
    expect(
        (count, gripper.states.data) == (2, ['ok', 'ok']),
        f'Two objects of your class in one program heard the same command, and the server said yes to both. {count} '
        f'requests came, expected 2; gripper_state says {gripper.states.data}, expected ok twice. Keep what belongs to '
        'one object in self, and in no variable of the class or of the module.',
        'answer',
    )


@pytest.mark.rules('request', 'answer', 'once', 'refusal', 'late', 'timeout')
@about('request')
def test_answers(learner):
    """Each command is reported once, with what the answer says; refusals are not tried again, late answers ignored.

    Report in a done-callback of the future. There, compare the future with the current one.
    """
    draw = learner.random
    delay = draw.choice([0.2, 0.5, 0.75])
    gripper = Gripper(learner, None)
    learner.run(draw.choice([0.4, 1.1]), step=1.0)
    _without_arguments(gripper, draw.choice([False, True]))
    # Whatever the message says, `success` counts.
    gripper.server.answer = lambda request: {'success': True, 'message': 'refused' if request.data else ''}
    gripper.server.delay = delay
    _in_time(gripper, delay)
    _refused(gripper, 'ok')
    _late(gripper, draw.choice([1.1, 1.4]))


def _without_arguments(gripper, data):
    """The client was made without arguments: a silent server is asked three times, one second apart."""
    gripper.command(data, 5.2, 'request')
    stamps = gripper.server.stamps
    seen = [round(stamp - stamps[0], 3) for stamp in stamps]
    words = f'GripperClient() was made without arguments, and the server is silent: requests at {seen} s from the first'
    expect(
        seen == [float(number) for number in range(len(seen))],
        f'{words}, expected at [0.0, 1.0, 2.0] s: without an argument `timeout` is 1.0.',
        'timeout',
    )
    expect(len(seen) == 3, f'{words}, expected three of them: without an argument `tries` is 3.', 'tries')


def _in_time(gripper, delay):
    """Two commands, each of which the server answers after `delay`."""
    states, server = gripper.states, gripper.server
    for data in (False, True):
        count = gripper.command(data, 0.9, 'answer')
        expect(
            states.data,
            f'The server answered with success=True after {delay} s; nothing came on gripper_state.',
            'answer',
            hint=True,
        )
        expect(
            states.data[0] == 'ok',
            f'The server answered with success=True and the message {"refused" if data else ""!r}; gripper_state says '
            f"{states.data}, expected ['ok'].",
            'answer',
        )
        gripper.learner.run(3.5, step=1.0)
        expect(
            states.data == ['ok'] and len(server.stamps) == count == 1,
            f'One command was answered after {delay} s. It made {len(server.stamps)} requests and the reports '
            f'{states.data}, expected one of each: stop the timer when the answer has come.',
            'once',
        )


def _refused(gripper, message):
    """A command that the server refuses with this message."""
    states = gripper.states
    gripper.server.answer = {'success': False, 'message': message}
    count = gripper.command(True, 4.5, 'refusal')
    expect(
        count == 1,
        f'The server refused, and was asked {count} times: a refusal is an answer, do not try again.',
        'refusal',
    )
    expect(
        states.data == ['refused'],
        f'The server answered with success=False and the message {message!r}; gripper_state says {states.data}, '
        "expected ['refused'].",
        'answer',
    )


def _late(gripper, late):
    """A command whose first answer takes `late` seconds, one whose answers all come late, and one after these."""
    states, server = gripper.states, gripper.server
    server.answer, delays = iter([{'success': True}, {'success': False}]), iter([late, 0.8])
    server.delay = lambda request: next(delays, 0.0)
    count = gripper.command(False, 4.5, 'late')
    expect(
        count <= 2 or 'refused' in states.data or 'ok' in states.data,
        f'The answer to the first request came after {late} s, too late, and the second request was refused in time; '
        f'{count} requests came, and gripper_state says {states.data}, expected 2 requests and refused: a refusal is '
        'an answer, also that of a second request.',
        'refusal',
    )
    expect(
        count <= 2 or states.data[:1] != ['refused'],
        f'The second request was answered in time, and {count} requests came: after the report nothing more is sent. '
        'Stop the timer.',
        'once',
    )
    expect(
        states.data == ['refused'],
        f'With the timeout 1 s, the first answer (success=True) came after {late} s, the second (success=False) in '
        f"time; gripper_state says {states.data}, expected ['refused']: what comes after its timeout is ignored.",
        'late',
    )
    server.answer, server.delay = {'success': True}, 3.4
    gripper.command(True, 7.0, 'late')
    expect(
        states.data == ['failed'],
        f'All answers came 3.4 s after their requests; gripper_state says {states.data}, '
        "expected ['failed']: what comes after its timeout is ignored.",
        'late',
    )
    server.delay = 0.0
    gripper.command(True, 0.5, 'request')
    expect(
        states.data == ['ok'],
        f"A command that came after a failed one was answered; gripper_state says {states.data}, expected ['ok'].",
        'answer',
    )


@pytest.mark.rules('request', 'answer', 'once', 'timeout', 'tries', 'refusal', 'late', 'newest')
@about('request')
def test_many_commands(learner):
    """Whenever commands and answers come, the rules say what is sent and what is reported."""
    check_script(learner, 10)


@pytest.mark.rules('newest', 'queue')
@about('newest')
def test_new_command(learner):
    """A new command drops the old one, without a report, and begins with all its tries.

    The new request becomes the current future; timer and counter start anew.
    """
    draw = learner.random
    first, pause, delay = draw.choice([False, True]), draw.choice([0.3, 0.5]), draw.choice([0.65, 0.8])
    gripper = Gripper(learner, lambda request: {'success': request.data}, delay=delay)
    _while_a_request_is_open(gripper, first, pause)
    _while_a_server_is_silent(gripper, first, pause)
    _the_same_command_again(gripper, first, pause)
    check_bursts(learner, gripper.close, gripper.server, states=gripper.states)


def _while_a_request_is_open(gripper, first, pause):
    """Two commands, the second one `pause` after the first, whose answer comes later than that."""
    learner, states, close, server = gripper.learner, gripper.states, gripper.close, gripper.server
    delay = server.delay
    close.send(Bool(data=first))
    learner.run(pause)
    close.send(Bool(data=not first))
    learner.settle()
    asked = [request.data for request in server.requests]
    words = f'Commands {first} at 0 s and {not first} at {pause} s, answers after {delay} s: '
    expect(
        asked == [first, not first],
        f'{words}the requests by then are {asked}. Send a new command at once, also if an old one is open.',
        'newest',
    )
    learner.run(5.0, step=1.0)
    told = list(zip(states.data, (round(stamp, 3) for stamp in states.stamps), strict=True))
    wanted = [('refused' if first else 'ok', round(pause + delay, 3))]
    expect(
        [text for text, _ in told] != [wanted[0][0]] or told == wanted,
        f'{words}gripper_state says {told}, expected {wanted}. A new request has its whole timeout: start the timer '
        'anew.',
        'newest',
    )
    expect(
        told == wanted,
        f'{words}gripper_state says {told}, expected {wanted}: nothing is reported for the old command.',
        'newest',
    )


def _the_same_command_again(gripper, data, pause):
    """The same command twice, the second one before the first is answered: the two answers look alike."""
    learner, states, server = gripper.learner, gripper.states, gripper.server
    server.answer = {'success': data}
    states.clear()
    begin = None
    for _ in range(2):
        gripper.close.send(Bool(data=data))
        learner.run(pause)
        begin = begin or server.stamps[-1]
    learner.run(5.0, step=1.0)
    told = list(zip(states.data, (round(stamp - begin, 3) for stamp in states.stamps), strict=True))
    wanted = [('ok' if data else 'refused', round(pause + server.delay, 3))]
    expect(
        told == wanted,
        f'The command {data} came twice, at 0 s and at {pause} s, and each request was answered after '
        f'{server.delay} s; gripper_state says {told}, expected {wanted}: the answer to a request of the old command '
        'does not count for the new one, also if both have the same data.',
        'newest',
    )


def _while_a_server_is_silent(gripper, first, pause):
    """Two commands without an answer, the second one in the middle of the tries of the first; then in its last try."""
    gripper.server.answer = None
    for tries in (2, 3):
        _while_silent(gripper, first, tries, round(tries - 1 + pause, 3))


def _while_silent(gripper, first, tries, begin):
    """Two commands with the same data, the second one at `begin`, when so many requests of the first have gone out."""
    learner, states, server = gripper.learner, gripper.states, gripper.server
    states.clear()
    server.stamps.clear()
    for _ in range(2):
        gripper.close.send(Bool(data=first))
        learner.run(begin, step=1.0)
    learner.run(5.0, step=1.0)
    seen = [round(stamp - server.stamps[0], 3) for stamp in server.stamps]
    expect(
        seen == [float(number) for number in range(tries)] + [begin, begin + 1.0, begin + 2.0],
        f'A silent server, two commands {begin} s apart: requests went out {seen} s after the first. A new command '
        'has all its tries, and its timer starts anew.',
        'newest',
    )
    expect(
        states.data == ['failed'],
        f'Two commands, one {begin} s after the other, to a silent server gave '
        f'{states.data}, expected one failed, for the second.',
        'newest',
    )


def check_bursts(learner, close, server, states) -> None:
    """No command is lost, of which ten come before the node can look, five times over, and then thirty one by one.

    Of ten at one moment the last one is reported, of the others each one.
    """
    server.answer, server.delay = {'success': True}, 0.0
    for number in range(5):
        server.stamps.clear()
        states.clear()
        close.send(*[Bool(data=learner.random.random() < 0.5) for _ in range(10)])
        learner.run(0.5)
        count = len(server.stamps)
        expect(
            count == 10 or number,
            f'10 commands came at one moment, before your node could look; {count} of them became requests, expected '
            '10: the depth of a subscription says how many it keeps.',
            'queue',
        )
        words = f'After more than {10 * number} commands 10 more came, each of which the server answered. '
        expect(
            count == 10,
            f'{words}{count} of them became requests, expected 10: a command makes a request, however many there were '
            'before.',
            'request',
        )
        expect(
            states.data[-1:] == ['ok'],
            f'{words}gripper_state says {states.data}, expected ok at the end: the last one of them is reported.',
            'answer',
        )
    states.clear()
    for _ in range(30):
        close.send(Bool(data=True))
        learner.run(0.1)
    expect(
        states.data == ['ok'] * 30,
        f'After more than 50 commands 30 more came, one after the other, and each was answered with success=True; '
        f'gripper_state says ok {states.data.count("ok")} times, and something else '
        f'{len(states) - states.data.count("ok")} times, expected 30 ok: each command is reported.',
        'answer',
    )


@pytest.mark.rules('names', 'no-server', 'tries')
@about('names')
def test_no_server(learner):
    """In a namespace all names move; the node starts without a server, and finds one that comes before its last try.

    A request to nobody is like one without an answer: do not wait for the service.
    """
    space, begin = learner.random.choice(['/left', '/arm_2', '/cell/north']), learner.random.choice([0.2, 0.6])
    tries = learner.random.randint(31, 33)
    states, close = learner.listen(f'{space}/gripper_state', String), learner.talk(f'{space}/close', Bool)
    with about('no-server'):
        node = learner.start('GripperClient', 1.0, tries, remap={'__ns': space})
    check_constructor(learner)
    expect(
        node.name == f'{space}/gripper_client',
        f'In the namespace {space} your node is called {node.name}, expected {space}/gripper_client.',
        'names',
    )
    check_names(learner, space, publisher='gripper_state', subscription='close')
    before = learner.slept
    learner.run(begin)
    close.send(Bool(data=True))
    with about('no-server'):
        learner.run(0.4)
        check_awake(learner, before)
        expect(
            not states.messages,
            f'No server is there; 0.4 s after a command gripper_state says {states.data}. The '
            'request has its timeout all the same.',
        )
    server = check_late_server(learner, states, begin, tries, space)
    check_names(learner, space, server)
    server.stop()
    check_nobody(learner, states, close, tries)
    with about('no-server'):
        expect(
            any(_seconds(lambda: learner.start('GripperClient', beside=node)) < 0.35 for _ in range(4)),
            'Without a server, your constructor takes a long time: it must not wait for the service.',
        )


def check_constructor(learner) -> None:
    """Expect that the constructor of the client that has just been started has not waited, not even shortly."""
    expect(
        learner.slept == 0.0,
        f'Without a server, your constructor waits ({learner.slept:.2g} s): it must not wait for the service. The '
        'first command makes a request all the same.',
        'no-server',
    )


def check_awake(learner, before: float) -> None:
    """Expect that no callback has slept since `learner.slept` was this: also not for a service that is not there."""
    expect(
        learner.slept <= before,
        'No server is there, and a callback waits for it: the whole node stands still meanwhile. Send the request all '
        'the same, and let the timer do the waiting.',
        'no-server',
    )


def check_late_server(learner, states, begin: float, tries: int, space: str):
    """A server that comes 0.6 s before the last request of a command gets this request, and the command is ok.

    The client has the timeout 1 s and so many `tries`; the command came at `begin`, 0.4 s ago. Returns the server.
    """
    with about('no-server'):
        learner.run(tries - 2.0, step=1.0)
        words = f'GripperClient(1.0, {tries}), no server, a command at {begin} s: '
        expect(
            not states.messages,
            f'{words}gripper_state says {states.data} at {states.stamps} s, which is too soon: there are {tries} '
            'requests, and `tries` may be any number.',
            'tries',
        )
        server = learner.serve(f'{space}/set_gripper', SetBool, {'success': True})
        learner.run(2.1, step=1.0)
    last = begin + tries - 1
    expect(
        f'{space}/set_gripper' not in server.theirs()
        or states.data == ['ok']
        and states.stamps == pytest.approx([last]),
        f'{words}a server came at {last - 0.6:.1f} s. gripper_state says {states.data} at {states.stamps} s, expected '
        f'ok at {last:.1f} s, with the last of the {tries} requests.',
        'no-server',
    )
    return server


def check_nobody(learner, states, close, tries: int) -> None:
    """Expect that a command to a server that never comes ends as one to a silent server does."""
    states.clear()
    before, begin = learner.slept, learner.now / 1e9
    close.send(Bool(data=False))
    with about('no-server'):
        learner.run(tries + 1.5, step=1.0)
    check_awake(learner, before)
    expect(
        states.data == ['failed'],
        f'No server is there; {tries + 1.5} s after a command gripper_state says {states.data}, expected one failed: a '
        'request to nobody counts as one without an answer.',
        'no-server',
    )
    took = states.stamps[0] - begin
    expect(
        took == pytest.approx(tries),
        f'No server is there; GripperClient(1.0, {tries}) reported failed {took:g} s after a command, expected after '
        f'{tries} s: a request to nobody counts as one without an answer, the first one, too.',
        'no-server',
    )


def _seconds(function) -> float:
    """The wall time that a call takes."""
    begin = time.monotonic()
    function()
    return time.monotonic() - begin
