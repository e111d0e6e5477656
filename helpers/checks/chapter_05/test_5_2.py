"""Visible tests of exercise 5.2, a client with a deadline."""

import time

import pytest
from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from unique_identifier_msgs.msg import UUID

from helpers.checks.chapter_05.two_clients import check_two_clients
from helpers.runner import about, action_peers, expect, waiting

pytestmark = [pytest.mark.exercise('5.2'), pytest.mark.wiring(type='names', qos='once', namespace='names')]
NEAR = 0.011  # s
SHORT = 0.35  # s, for a constructor that does not wait
WORDS = 'rejected', 'succeeded', 'canceled', 'aborted', 'lost'


def result_of(order):
    """Numbers in no order, other ones than those of the feedback: large, negative, one twice, and zero."""
    return [(2_000_000_011, -40, -40, 0, 57)[n % 5] for n in range(order)]


def plan(goal):
    """One number every 0.5 s."""
    steps = [(0.5, Fibonacci.Feedback(sequence=range(n + 1))) for n in range(goal.order)]
    return [*steps, (0.0, Fibonacci.Result(sequence=result_of(goal.order)))]


def uneven(goal):
    """Feedback every 0.5 s: after a long list comes a short one."""
    steps = [(0.5, Fibonacci.Feedback(sequence=_uneven(n))) for n in range(goal.order)]
    return [*steps, (0.0, Fibonacci.Result(sequence=result_of(goal.order)))]


def _uneven(n: int) -> list[int]:
    return [0, n, n, n] if n % 2 else [0, *[n] * 14]


def check_no_wait(learner):
    """Neither the constructor nor a callback has slept, or waited for the server: rule `at-once`."""
    expect(
        not learner.slept,
        'Your client sleeps, or waits in `wait_for_server`, and the whole node stands still meanwhile. It must not '
        'wait for the server: ask `server_is_ready()` in the callback of a timer.',
        'at-once',
    )


def check_no_early_look(waits: list[float]) -> None:
    """No goal came between the start of a client and its first look, after 0.1 s: rule `send`. `waits`: in s."""
    early = [wait for wait in waits if NEAR < wait < 0.1 - NEAR]
    expect(
        not early,
        'A client began when the server was there, and its goal came after '
        f'{min(early, default=0.0):.2f} s: look every 0.1 s, not more often.',
        'send',
    )


_ONE_OUTCOME = 'There is one outcome, at the end: what goes out in the constructor, hardly anybody can hear.'


def check_first(outcome, story: str = '') -> None:
    """What came first on /outcome is the first that its publisher has sent: rule `once`."""
    first = outcome.data[0] if outcome.data else ''
    expect(
        outcome.numbers[:1] in ([], [1]),
        f'{story}/outcome said {first!r}, and something else went out before. {_ONE_OUTCOME}',
        'once',
    )


def check_silence(learner, outcome, story: str = '') -> None:
    """Nothing has come on /outcome yet: rule `once`. On a busy machine, what the constructor publishes is heard."""
    learner.settle()
    said = outcome.data
    expect(said in ([], ['rejected []']), f'{story}the constructor said {shown(said)}. {_ONE_OUTCOME}', 'once')


def shown(outcomes: list[str]) -> str:
    """All of them; of many the first ones, and how many there are."""
    return str(outcomes) if len(outcomes) <= 3 else f'{outcomes[:3]} and so on, {len(outcomes)} times in all'


class Rounds:
    """One client after the other in one process, each with a server that behaves in another way."""

    def __init__(self, learner):
        self.learner, self.node, self.before = learner, None, 0
        self.outcome = learner.listen('/outcome', String)
        self.server = learner.action_server('/fibonacci', Fibonacci, plan)
        hidden = '/fibonacci/_action/feedback'
        self.other = learner.talk(hidden, Fibonacci.Impl.FeedbackMessage, strict=False)
        self.waits: list[float] = []  # s, from the start of each client until its goal came

    def begin(self, order, patience, story):
        """Start a client, and wait for its goal."""
        self.outcome.clear()
        self.story = f'PatientClient({order}, {patience}), {story}: '
        self.before = len(self.server.goals)
        self.server.cancel_stamps.clear()
        started = self.learner.now / 1e9
        with waiting('at-once'):
            self.node = self.learner.start('PatientClient', order, patience, beside=self.node)
        check_silence(self.learner, self.outcome, self.story)
        self.learner.run(0.3)
        check_no_wait(self.learner)
        goals = self.server.goals[self.before :]
        expect(
            goals or self.server.late,
            f'{self.story}no goal came within 0.3 s. Look in a timer whether the server '
            'is ready, and send the goal then.',
            'send',
        )
        if goals:
            self.waits.append(goals[0].arrived - started)
        return goals[0] if goals else None

    def expect(self, wanted, rule, hint=''):
        """Expect exactly this outcome so far."""
        said, words = self.outcome.data, [text.partition(' ')[0] for text in self.outcome.data]
        told = f'{self.story}/outcome said {shown(said)}, expected {wanted!r}.'
        expect(words, f'{self.story}nothing came on /outcome, expected {wanted!r}. {hint}', rule)
        expect(words[0] in WORDS, f'{told} `{words[0]}` is none of the words: {", ".join(WORDS)}.', 'word')
        expect(words[0] == wanted.split()[0], f'{told} {hint}', rule)
        numbers = said[0].startswith(f'{words[0]} [')
        hint = hint if numbers else 'After the word come a space and a plain list: list(sequence) makes one.'
        expect(said[0] == wanted, f'{told} {hint}', 'numbers' if numbers else 'word')
        check_first(self.outcome, self.story)
        expect(len(said) == 1, f'{told} One outcome is enough, whatever comes after it.', 'once')
        sent, end = len(self.server.goals) - self.before, words[0]
        why = 'was rejected is not sent again' if end == 'rejected' else f'has the outcome {end} is not sent again'
        expect(sent == 1, f'{self.story}it sent {sent} goals, expected one: a goal that {why}.', 'send')

    def expect_looks(self):
        """The server was there: one client at least found it at its first look, and none sooner (rule `send`)."""
        check_no_early_look(self.waits)
        least = min(self.waits)
        expect(
            least < 0.1 + NEAR,
            f'{len(self.waits)} clients began when the server was there; their goals came after {least:.2f} s at the '
            'earliest, expected after 0.1 s: look every 0.1 s.',
            'send',
        )


@pytest.mark.rules('send', 'deadline', 'result', 'lost', 'once', 'word', 'numbers')
@about('send')
def test_outcomes(learner):
    """Each end of a goal has its one outcome.

    Every wait is a timer or a done-callback. Look at accepted before you ask for a result.
    """
    draw, rounds = learner.random, Rounds(learner)
    server, order = rounds.server, draw.randint(2, 4)
    rounds.begin(order, 3.3, 'a server that does it in time')
    learner.run(5.5, step=1.0)
    orders = [goal.request.order for goal in server.goals]
    expect(orders == [order], f'{rounds.story}goals of the orders {orders} came, expected one of {order}.', 'send')
    rounds.expect(f'succeeded {result_of(order)}', 'word', "It is in the future's result: .result().result.")
    expect(
        not server.cancel_stamps, f'{rounds.story}a cancel request came for a goal that had ended in time.', 'deadline'
    )
    _rejects(learner, rounds)
    value = draw.randint(3, 99)
    _ends_in_time(learner, rounds, order, value)
    _stops_late(learner, rounds, draw.choice([71.34, 122.16]), value)
    for server.cancel, does in (('reject', 'refuses the cancel request'), ('ignore', 'accepts the cancel request')):
        rounds.begin(5, 1.2, f'a server that {does}, goes on, and succeeds 1.3 s later')
        learner.run(3.5, step=1.0)
        rounds.expect(f'succeeded {result_of(5)}', 'result', 'A cancel request is only a request.')
        _asked_once(rounds)
    _answers_late(learner, rounds)
    _tells_early(learner, rounds)
    rounds.expect_looks()


def _rejects(learner, rounds):
    """A server rejects goals, whatever their order is."""
    draw, server = learner.random, rounds.server
    server.accept = False
    for odd in (0, -draw.randint(1, 99), draw.randint(1000, 2**31 - 1)):
        rejected = rounds.begin(odd, 1.0, 'a server that rejects the goal')
        learner.run(2.5, step=1.0)
        expect(
            rejected.request.order == odd,
            f'{rounds.story}a goal of the order {rejected.request.order} came. Send the order that was given; whether '
            'it can be done is for the server to say.',
            'send',
        )
        rounds.expect('rejected []', 'word', 'Look at accepted first.')
    server.accept = True


def _ends_in_time(learner, rounds, order, value):
    """A server aborts a goal before the deadline, or somebody else has cancelled it."""
    draw, server = learner.random, rounds.server
    heard, many = Fibonacci.Feedback(sequence=[value]), [value + n for n in range(draw.randint(31, 47))]
    aborts, cancels = 'aborts the goal', 'was asked by somebody else to cancel the goal'
    for does, plan_, wanted in (
        (aborts, [(0.6, action_peers.Aborted(Fibonacci.Result(sequence=many)))], f'aborted {many}'),
        (aborts, [(0.6, action_peers.Aborted(Fibonacci.Result(sequence=[value])))], f'aborted [{value}]'),
        # not what the feedback said
        (aborts, [(0.3, heard), (0.3, action_peers.Aborted(Fibonacci.Result()))], 'aborted []'),
        (
            cancels,
            [(0.3, heard), (0.3, action_peers.Canceled(Fibonacci.Result(sequence=[-value])))],
            f'canceled [{-value}]',
        ),
    ):
        server.plan = plan_
        rounds.begin(order, 1.5, f'a server that {does}')
        learner.run(3.5, step=1.0)
        rounds.expect(wanted, 'word', 'The status stands beside the result; the numbers are in the result.')
        expect(
            not server.cancel_stamps,
            f'{rounds.story}it ended before the deadline, and a cancel request came for it: stop the timer of the '
            'deadline when the result has come, whatever it says.',
            'deadline',
        )
    server.plan = plan


def _stops_late(learner, rounds, patience, value):
    """A server accepts the cancel request, and ends the goal much later."""
    server, delay = rounds.server, learner.random.choice([62.6, 91.8])
    server.cancel_delay, server.partial = delay, Fibonacci.Result(sequence=[value])
    server.plan = [(1000.0, Fibonacci.Result())]
    goal = rounds.begin(30, patience, f'a server that is slow, and stops {delay} s after the cancel request')
    learner.run(patience + 0.5, step=5.0)
    expect(
        goal.cancelled is not None,
        f'{rounds.story}no cancel request came. To stop waiting is not enough: the robot would go on.',
        'deadline',
    )
    expect(
        goal.cancelled - goal.arrived == pytest.approx(patience, abs=NEAR),
        f'{rounds.story}the cancel request came {goal.cancelled - goal.arrived:.2f} s after the goal was accepted.',
        'deadline',
    )
    learner.run(0.8)
    learner.run(delay - 1.9, step=5.0)
    expect(
        not rounds.outcome.data,
        f'{rounds.story}/outcome said {shown(rounds.outcome.data)} before the result was there: '
        'wait for the result, which also a cancelled goal has.',
        'result',
    )
    learner.run(1.5, step=1.0)
    rounds.expect(f'canceled [{value}]', 'result', 'The result also comes for a cancelled goal.')
    _asked_once(rounds)
    server.plan = plan


def _asked_once(rounds):
    """One cancel request came."""
    asked = len(rounds.server.cancel_stamps)
    expect(asked == 1, f'{rounds.story}{asked} cancel requests came, expected one.', 'deadline')


def _answers_late(learner, rounds):
    """A server answers the cancel request later than 1 s, and then another one is gone."""
    draw, server = learner.random, rounds.server
    server.cancel, server.late = 'ignore', {'cancel': 1.5}
    server.cancel_delay = 0.0
    patience = draw.choice([24.2, 26.7])  # about fifty times feedback
    seen, value = _uneven(int(patience / 0.5 + 1)), draw.randint(10, 99)
    server.plan = uneven
    foreign = Fibonacci.Impl.FeedbackMessage(
        goal_id=UUID(uuid=[value] * 16), feedback=Fibonacci.Feedback(sequence=[value])
    )
    order = int(patience / 0.5) + 4  # it ends when the client has said that it is lost
    goal = rounds.begin(order, patience, 'a server that needs 1.5 s to answer the cancel request, and then succeeds')
    learner.run(patience + 0.65, step=1.0)
    rounds.other.send(foreign)
    learner.run(0.3)
    expect(
        rounds.outcome.data != [f'lost [{value}]'],
        f'{rounds.story}/outcome said {shown(rounds.outcome.data)}, expected {f"lost {seen}"!r}: another client has a '
        f'goal with the same server, and [{value}] was feedback for that goal. Give your feedback callback to '
        '`send_goal_async`: then it hears only of its own goal.',
        'numbers',
    )
    rounds.expect(
        f'lost {seen}',
        'lost',
        'The cancel request was not answered within 1 s. The numbers are those of the last feedback, also if there '
        'was a longer one before.',
    )
    took = rounds.outcome.stamps[0] - goal.arrived
    expect(
        took == pytest.approx(patience + 1.0, abs=2 * NEAR),
        f'{rounds.story}lost came {took:.2f} s after the goal was accepted, expected {patience + 1.0:g} s.',
        'lost',
    )
    learner.run(2.0, step=1.0)
    rounds.expect(f'lost {seen}', 'once')
    _asked_once(rounds)
    _answers_in_time(learner, rounds)
    server.late = {'cancel': 1.5}
    server.plan = [(1.4, action_peers.Aborted(Fibonacci.Result(sequence=[value])))]
    rounds.begin(30, 0.2, 'a server that aborts the goal 1.2 s after the cancel request, and has not answered that')
    learner.run(1.5, step=1.0)
    rounds.expect('lost []', 'lost', 'The cancel request was not answered within 1 s.')
    server.late, server.plan = {}, uneven
    _is_gone(learner, rounds)


def _answers_in_time(learner, rounds):
    """A server answers the cancel request 0.8 s after it, or at once."""
    draw, server = learner.random, rounds.server
    server.cancel, server.late, patience = 'accept', {'cancel': 0.8}, draw.choice([1.2, 1.7])
    rounds.begin(30, patience, 'a server that needs 0.8 s to answer the cancel request')
    learner.run(patience + 3.0, step=1.0)
    rounds.expect(f'canceled {list(server.partial.sequence)}', 'lost', 'The answer came in time.')
    server.late = {}
    rounds.begin(30, 0.0, 'a server that accepts the cancel request, and stops')
    learner.run(0.5)
    rounds.expect(
        f'canceled {list(server.partial.sequence)}', 'deadline', 'With a patience of 0 s it asks to cancel at once.'
    )


def _is_gone(learner, rounds):
    """A server ends before it could answer the cancel request."""
    goal = rounds.begin(30, 1.0, 'a server that ends after its first feedback')
    learner.run(0.4)
    rounds.server.stop()
    learner.run(3.0, step=1.0)
    rounds.expect(f'lost {_uneven(0)}', 'lost', 'Nobody answers the cancel request: the client must not wait for ever.')
    took = rounds.outcome.stamps[0] - goal.arrived
    expect(
        took == pytest.approx(2.0, abs=2 * NEAR),
        f'{rounds.story}lost came {took:.2f} s after the goal was accepted, expected 2 s: 1 s of patience, and 1 s '
        'without an answer to the cancel request.',
        'lost',
    )


def _tells_early(learner, rounds):
    """A server gives feedback before it answers the goal, and then nothing more: that was the last feedback."""
    server, value = rounds.server, learner.random.randint(3, 99)
    server.start()
    server.late, server.plan = {'goal': 0.6, 'cancel': 9.0}, [(60.0, Fibonacci.Result())]
    rounds.begin(30, 0.7, f'a server whose feedback [{-value}] comes before its answer to the goal, and no other one')
    learner.run(0.1)
    server.tell_early(Fibonacci.Feedback(sequence=[-value]))
    learner.run(0.1)
    expect(
        not rounds.outcome.data,
        f'{rounds.story}/outcome said {shown(rounds.outcome.data)} when this feedback came. There is one outcome, when '
        'the goal has ended or is lost.',
        'once',
    )
    learner.run(2.6, step=1.0)
    rounds.expect(
        f'lost [{-value}]', 'numbers', 'All feedback for this goal counts, also what comes before it is accepted.'
    )


@pytest.mark.rules('names', 'at-once', 'send', 'deadline', 'numbers', 'once', 'word')
@about('send')
def test_server_comes_late(learner):
    """The client starts before the server; the deadline begins when the goal is accepted.

    Look for the server in a timer; make the timer of the deadline when the answer to the goal has come.
    """
    draw = learner.random
    space, order = draw.choice(['/left', '/robot_2']), draw.randint(2, 3)
    outcome = learner.listen(f'{space}/outcome', String)
    with waiting('at-once'):
        node = learner.start('PatientClient', order, 0.5 * order + 0.5, remap={'__ns': space})
    check_silence(learner, outcome)
    _check_own_names(learner, node, space)
    away = draw.choice([31.3, 32.2])
    learner.run(away, step=1.0)
    check_no_wait(learner)
    expect(not outcome.data, f'There is no server, and /outcome said {shown(outcome.data)}.', 'send')
    server = learner.action_server(f'{space}/fibonacci', Fibonacci, plan)
    late = draw.choice([62.2, 81.2])  # no answer is no rejection
    server.late = {'goal': late}
    learner.settle()
    expect(
        server.name in server.theirs(),
        f'In the namespace {space} your node has no action client for '
        f'{server.name}: write the name without a leading slash.',
        'names',
    )
    begin = learner.now / 1e9
    learner.run(late + 3.8, step=1.0)
    expect(
        server.goals,
        f'A server came {away} s after the client, and no goal came in the {late + 3.8:g} s after that. Look for the '
        'server every 0.1 s until it is there, however long that takes.',
        'send',
    )
    expect(
        len(server.goals) == 1,
        f'The server needs {late} s to accept; in the meantime {len(server.goals)} goals came, '
        'expected one: stop looking for the server when the goal is sent.',
        'send',
    )
    waited = server.goals[0].arrived - late - begin
    expect(waited < 0.21, f'The goal came {waited:.2f} s after the server: look for it every 0.1 s.', 'send')
    _check_no_end_before(outcome, begin + late, late)
    expect(
        outcome.data and outcome.data[0].startswith('succeeded'),
        f'The server accepted the goal {late} s after it was sent, and needed {0.5 * order} s; with the patience '
        f'{0.5 * order + 0.5} s, /outcome said {shown(outcome.data)}. The deadline begins when the goal is accepted.',
        'deadline',
    )
    server.stop()
    check_two_clients(learner, beside=node)
    check_constructor(learner, node, server)


def _check_own_names(learner, node, space):
    """The names of the node and of its topic in a namespace."""
    expect(
        node.name == f'{space}/patient_client',
        f'In the namespace {space} your node is called {node.name}, expected {space}/patient_client.',
        'names',
    )
    expect(
        learner.endpoints(f'{space}/outcome').publishers,
        f'In the namespace {space} your node has no publisher on {space}/outcome: write the name without a leading '
        'slash.',
        'names',
    )


def _check_no_end_before(outcome, end, late):
    """The server, which needed `late` s to answer the goal, until `end` (s), has not been said to reject it."""
    early = [text for text, stamp in zip(outcome.data, outcome.stamps, strict=True) if stamp < end]
    expect(
        early[:1] != ['rejected []'],
        f'The server needed {late} s to answer the goal, and /outcome said {shown(early)} before. A server that has '
        'not answered yet has not rejected the goal: the client has no deadline for this answer.',
        'word',
    )


def check_constructor(learner, node, server) -> None:
    """Without a server the constructor returns as soon as with one: rule `at-once`. The server of the test is stopped.

    The two are compared with each other: on a busy machine both take long.
    """
    learner.settle()
    without = _shortest(learner, node)
    if without < SHORT:
        return
    server.start()
    learner.settle()
    expect(
        without < SHORT + 2 * _shortest(learner, node),
        'Without a server, your constructor takes a long time: it must not wait for the server.',
        'at-once',
    )


def _shortest(learner, node) -> float:
    """The wall time (s) that a client takes to start, the shortest of several if it is not short."""
    times: list[float] = []
    while len(times) < 4 and min(times, default=SHORT) >= SHORT:
        begin = time.monotonic()
        learner.start('PatientClient', 1, 1.0, beside=node)
        times.append(time.monotonic() - begin)
    return min(times)
