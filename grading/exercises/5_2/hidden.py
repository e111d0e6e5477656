"""Hidden tests of exercise 5.2, a client with a deadline."""

import pytest
from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from unique_identifier_msgs.msg import UUID

from helpers.checks.chapter_05.test_5_2 import check_constructor, check_first, check_no_early_look, check_silence
from helpers.checks.chapter_05.two_clients import check_two_clients
from helpers.runner import about, action_peers, expect, waiting

pytestmark = [pytest.mark.exercise('5.2'), pytest.mark.wiring(type='names', qos='once', namespace='names')]
NEAR = 0.011  # s


def plan(goal):
    """One number every 0.5 s."""
    steps = [(0.5, Fibonacci.Feedback(sequence=range(n + 1))) for n in range(goal.order)]
    return [*steps, (0.0, Fibonacci.Result(sequence=range(goal.order)))]


def begin(learner, order, patience, steps=plan, **server):
    outcome = learner.listen('/outcome', String)
    server = learner.action_server('/fibonacci', Fibonacci, steps, **server)
    node = learner.start('PatientClient', order, patience)
    check_silence(learner, outcome)
    return outcome, server, node


def check_one_goal(server):
    """One goal came, however it ended."""
    count = len(server.goals)
    expect(count == 1, f'{count} goals came, expected one: there is no second try, however a goal ends.', 'send')


@pytest.mark.weight(2)
@pytest.mark.rules('send', 'names', 'word', 'deadline')
@about('send')
def test_in_time(learner):
    """A goal that ends in time is not cancelled, also not afterwards, and has one outcome.

    Cancel the timer of the deadline when the result comes.
    """
    order = learner.random.randint(2, 5)
    outcome, server, node = begin(learner, order, 3.0)
    learner.run(6.0)
    expect(node.name == '/patient_client', f'Your node is called {node.name}, expected /patient_client.', 'names')
    expect(
        [goal.request.order for goal in server.goals] == [order],
        f'The orders {[goal.request.order for goal in server.goals]} came, expected one goal, {order}.',
        'send',
    )
    expect(not server.cancel_stamps, 'A cancel request came for a goal that ended in time.', 'deadline')
    expect(
        outcome.data == [f'succeeded {list(range(order))}'],
        f'/outcome said {outcome.data}, expected ["succeeded {list(range(order))}"], once.',
        'word',
    )
    waits = [server.goals[0].arrived]
    for _ in range(4):  # some parts of a server may be seen late, but not each time
        started = learner.now / 1e9
        learner.start('PatientClient', 1, 3.0, beside=node)
        learner.run(0.8)
        waits.append(server.goals[-1].arrived - started)
    expect(waits[0] < 0.35, f'The goal came {waits[0]:g} s after the start.', 'send')
    check_no_early_look(waits)
    expect(
        0 <= min(waits[1:]) < 0.1 + NEAR,
        f'The server was there, and goals came {", ".join(f"{wait:.2f}" for wait in waits[1:])} s after the start of '
        'their clients, expected after 0.1 s: look every 0.1 s.',
        'send',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('deadline', 'result', 'numbers', 'word', 'send')
@about('deadline')
def test_deadline(learner):
    """The cancel request comes `patience` seconds after the goal was accepted; then the result is waited for.

    The server may need time to stop. Its result tells what really happened.
    """
    patience, slow = learner.random.choice([62.35, 93.74, 186.17]), [(1000.0, Fibonacci.Result())]
    outcome, server, _ = begin(learner, 30, patience, slow, partial=Fibonacci.Result(sequence=[6, 5]))
    server.cancel_delay = learner.random.uniform(61, 120)
    learner.run(patience + server.cancel_delay - 0.5, step=5.0)
    expect(server.goals, 'No goal came.', 'deadline')
    goal = server.goals[0]
    expect(
        goal.cancelled is not None,
        'The deadline passed, and no cancel request came: to stop waiting does not stop the robot.',
        'deadline',
    )
    expect(
        goal.cancelled - goal.arrived == pytest.approx(patience, abs=NEAR),
        f'The cancel request came {goal.cancelled - goal.arrived:.2f} s after the goal was accepted, expected '
        f'{patience:g} s.',
        'deadline',
    )
    expect(
        not outcome.data,
        f'/outcome said {outcome.data} before the result was there. The server had accepted the '
        'cancel request and was still stopping: wait for its result.',
        'result',
    )
    learner.run(2.0)
    words = [text.partition(' ')[0] for text in outcome.data]
    expect(
        set(words) <= {'succeeded', 'canceled', 'aborted', 'rejected', 'lost'},
        f'/outcome said {outcome.data}; the word of a goal that was cancelled is `canceled`, as in ROS.',
        'word',
    )
    expect(
        outcome.data == ['canceled [6, 5]'],
        f'/outcome said {outcome.data}, expected ["canceled [6, 5]"].',
        'numbers' if outcome.data and outcome.data[0].startswith('canceled [') else 'result',
    )
    check_one_goal(server)


@pytest.mark.rules('word', 'send')
@about('word')
def test_rejected(learner):
    """A rejected goal has no result and no deadline.

    Look at accepted first.
    """
    order = -learner.random.choice([0, learner.random.randint(1, 2**31)])
    outcome, server, node = begin(learner, order, 1.0, accept=False)
    learner.run(4.0)
    expect(
        outcome.data == ['rejected []'],
        f'The goal was rejected, and /outcome said {outcome.data}. Look at accepted first.',
        'word',
    )
    came = [goal.request.order for goal in server.goals]
    expect(came == [order], f'PatientClient({order}, 1.0) sent goals of the orders {came}, expected {[order]}.', 'send')
    large = learner.random.randint(1000, 2**31 - 1)
    learner.start('PatientClient', large, 1.0, beside=node)
    learner.run(4.0)
    came = [goal.request.order for goal in server.goals[1:]]
    expect(came == [large], f'PatientClient({large}, 1.0) sent goals of the orders {came}, expected {[large]}.', 'send')


@pytest.mark.rules('word', 'numbers', 'send', 'deadline')
@about('word')
def test_aborted(learner):
    """A goal that the server gives up has the outcome "aborted"; one that somebody else has cancelled, "canceled".

    The status stands beside the result: .result().status.
    """
    draw = learner.random
    numbers = [9, 4, 9, -draw.randint(1, 99), draw.randint(10**6, 2**31 - 1), 0]
    for word, end in (('aborted', action_peers.Aborted), ('canceled', action_peers.Canceled)):
        outcome, server, node = begin(learner, 3, 3.0, [(1.0, end(Fibonacci.Result(sequence=numbers)))])
        learner.run(5.0)
        expect(
            outcome.data == [f'{word} {numbers}'],
            f'The server ended the goal as {word}, before the deadline, and /outcome said {outcome.data}, '
            f'expected ["{word} {numbers}"]. Look at the status of the result.',
            'numbers' if outcome.data and outcome.data[0].startswith(f'{word} [') else 'word',
        )
        check_one_goal(server)
        expect(
            not server.cancel_stamps,
            f'A goal ended as {word} before its deadline, and a cancel request came for it.',
            'deadline',
        )
        node.stop()
        server.stop()


@pytest.mark.rules('numbers', 'word')
@about('numbers')
def test_empty_result(learner):
    """A result without numbers is reported so, also if numbers came in the feedback.

    Only a goal that is lost has the numbers of the feedback.
    """
    number = learner.random.randint(1, 99)
    end = action_peers.Aborted(Fibonacci.Result())
    outcome, _, _ = begin(learner, 3, 3.0, [(0.5, Fibonacci.Feedback(sequence=[number])), (0.5, end)])
    learner.run(3.0)
    expect(
        outcome.data == ['aborted []'],
        f'The feedback said [{number}], the goal was aborted with an empty result, and /outcome said {outcome.data}, '
        'expected ["aborted []"].',
        'numbers' if outcome.data and outcome.data[0].startswith('aborted') else 'word',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('result', 'deadline')
@about('result')
def test_cancel_in_vain(learner):
    """A server may refuse to cancel, or end the goal all the same: the result says what happened.

    A cancel request is a request. Report the status of the result.
    """
    for cancel, patience in (('reject', 2.0), ('ignore', 0.0)):
        outcome, server, node = begin(learner, 8, patience, cancel=cancel)
        learner.run(7.0)
        expect(
            outcome.data == [f'succeeded {list(range(8))}'],
            f'The goal went on after the cancel request ({cancel}) and succeeded; /outcome said {outcome.data}. '
            'Report what the result says.',
        )
        count = len(server.cancel_stamps)
        expect(
            count == 1,
            f'The patience of {patience} s was over, and {count} cancel requests came ({cancel}), expected one.',
            'deadline',
        )
        node.stop()
        server.stop()


@pytest.mark.rules('once', 'result')
@about('once')
def test_race(learner):
    """The result may come at the moment of the deadline: there is one outcome, and it is true.

    One place that publishes, and timers that are cancelled.
    """
    outcome, server, _ = begin(learner, 4, 2.0)
    learner.run(6.0)
    check_first(outcome)
    expect(
        outcome.data in (['succeeded [0, 1, 2, 3]'], ['canceled []']),
        f'The result came at the moment of the deadline, and /outcome said {outcome.data}.',
        'once',
    )
    expect(
        outcome.data[0].split()[0] == server.goals[0].status,
        f'The goal ended as {server.goals[0].status}, and /outcome said {outcome.data}.',
        'result',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('lost', 'numbers')
@about('lost')
def test_server_is_gone(learner):
    """A server that ends in between never answers: 1 s after the cancel request the outcome is "lost".

    The numbers are those of the last feedback: message.feedback.sequence.
    """
    steps = [(0.5, Fibonacci.Feedback(sequence=range(n, 30))) for n in range(9)]  # each one is shorter
    outcome, server, _ = begin(learner, 30, 2.0, steps)
    foreign = learner.talk('/fibonacci/_action/feedback', Fibonacci.Impl.FeedbackMessage, strict=False)
    learner.run(1.5)
    server.stop()
    seen = list(range(1, 30)) if server.goals and server.goals[0].arrived < 0.4 else None
    feedback = Fibonacci.Feedback(sequence=range(40))
    foreign.send(Fibonacci.Impl.FeedbackMessage(goal_id=UUID(uuid=[7] * 16), feedback=feedback))
    learner.run(5.0)
    expect(
        outcome.data,
        'The server ended while the goal ran, and /outcome says nothing: the client waits for ever.',
        'lost',
    )
    expect(
        outcome.data != [f'lost {list(range(40))}'],
        f'/outcome said {outcome.data}: these are the numbers of a goal of another client. The feedback of your goal '
        f'was {seen} at last. Give your feedback callback to `send_goal_async`.',
        'numbers',
    )
    expect(
        outcome.data == [f'lost {seen}'],
        f'The server ended after the feedback {seen}; /outcome said {outcome.data}, expected ["lost {seen}"].',
        'numbers' if outcome.data[0].startswith('lost [') else 'lost',
    )
    arrived = server.goals[0].arrived
    expect(
        outcome.stamps[0] - arrived == pytest.approx(3.0, abs=2 * NEAR),
        f'The outcome came {outcome.stamps[0] - arrived:.2f} s after the goal, expected 3 s: the deadline after '
        '2 s, and 1 s for an answer.',
        'lost',
    )


@pytest.mark.rules('at-once', 'send', 'deadline')
@about('send')
def test_server_comes_late(learner):
    """The client may start before the server. Its constructor returns at once, and the deadline begins with the goal.

    Look for the server in a timer; never wait in a constructor.
    """
    outcome = learner.listen('/outcome', String)
    server = learner.action_server('/fibonacci', Fibonacci, plan)
    server.stop()
    with waiting('at-once'):
        node = learner.start('PatientClient', 2, 1.5)
        check_silence(learner, outcome)
        learner.run(33.0, step=1.0)
    expect(not learner.slept, 'The client sleeps, or waits for the server: it must ask in a timer instead.', 'at-once')
    expect(not outcome.data, f'There is no server, and /outcome said {outcome.data}.', 'send')
    server.start()
    learner.run(4.0)
    expect(
        len(server.goals) == 1,
        f'The server came after 33 s, and {len(server.goals)} goals came in the 4 s after that, expected one.',
        'send',
    )
    expect(
        outcome.data and outcome.data[0].startswith('succeeded'),
        f'/outcome said {outcome.data}, expected succeeded: the deadline begins when the goal is accepted.',
        'deadline',
    )
    server.stop()
    check_constructor(learner, node, server)


@pytest.mark.rules('deadline', 'once', 'send')
@about('deadline')
def test_slow_answers(learner):
    """The server accepts late, and answers the cancel request late: the deadlines count from the right moments.

    The first one from the answer to the goal, the second one from the cancel request.
    """
    result = Fibonacci.Result(sequence=[3])
    for end in (result, action_peers.Aborted(result), None):  # how it ends after it was lost; None: it is cancelled
        outcome, server, node = begin(learner, 30, 1.4, plan if end is None else [(2.6, end)], partial=result)
        server.late = {'goal': learner.random.choice([0.6, 1.1]), 'cancel': 1.3}
        learner.run(4.5)
        expect(
            len(server.goals) == 1,
            f'The server needs {server.late["goal"]} s to accept; in the meantime {len(server.goals)} goals came, '
            'expected one.',
            'send',
        )
        expect(
            outcome.data, 'The cancel request was not answered within 1 s, and nothing came on /outcome.', 'deadline'
        )
        sent = outcome.stamps[0] - 1.0 - server.goals[0].arrived
        expect(
            sent == pytest.approx(1.4, abs=2 * NEAR),
            f'The goal was accepted {server.late["goal"]} s late; the cancel request came {sent:.2f} s after that, '
            'expected 1.4 s.',
            'deadline',
        )
        learner.run(2.0)
        expect(
            len(outcome) == 1,
            f'The cancel request was answered after 1.3 s; /outcome said {outcome.data}, expected one outcome.',
            'once',
        )
        asked = len(server.cancel_stamps)
        expect(asked == 1, f'The goal is lost, and {asked} cancel requests came, expected one.', 'deadline')
        node.stop()
        server.stop()


@pytest.mark.rules('names', 'send', 'deadline', 'numbers', 'once')
@about('names')
def test_two_clients(learner):
    """In a namespace all names move with the node; two clients each have their own goal and outcome.

    Relative names, and all state in the object.
    """
    left, right = learner.listen('/left/outcome', String), learner.listen('/right/outcome', String)
    servers = [
        learner.action_server(f'/{side}/fibonacci', Fibonacci, plan, partial=Fibonacci.Result(sequence=[4]))
        for side in ('left', 'right')
    ]
    learner.start('PatientClient', 2, 2.0, remap={'__ns': '/left'})
    check_silence(learner, left)
    learner.start('PatientClient', 20, 2.0, remap={'__ns': '/right'})
    check_silence(learner, right)
    learner.run(4.0)
    counts = [len(server.goals) for server in servers]
    expect(counts == [1, 1], f'Two clients in two namespaces sent {counts} goals to the servers in theirs.')
    said = [heard.data[0].split()[0] if heard.data else '' for heard in (left, right)]
    expect(
        said == ['succeeded', 'canceled'],
        f'Two clients with a short and a long goal said {left.data} and {right.data}.',
    )
    check_two_clients(learner)


@pytest.mark.rules('numbers', 'once', 'word', 'lost')
@about('numbers')
def test_early_feedback(learner):
    """Feedback may come before the server has answered the goal, which may take long: it counts, and nothing ends.

    Keep the numbers of each feedback; report when the goal is rejected, has ended or is lost.
    """
    draw = learner.random
    late, numbers = draw.choice([65.3, 72.4]), [-draw.randint(1, 99), draw.randint(1, 99)]
    outcome, server, _ = begin(learner, 7, 0.9, [(60.0, Fibonacci.Result())])
    server.late = {'goal': late, 'cancel': 9.0}
    learner.run(0.5)
    server.tell_early(Fibonacci.Feedback(sequence=numbers))
    learner.run(0.2)
    expect(
        not outcome.data,
        f'Feedback came before the answer to the goal, and /outcome said {outcome.data}: there is one outcome, at the '
        'end.',
        'once',
    )
    learner.run(late - 0.9, step=5.0)
    expect(
        not outcome.data,
        f'The server had not answered the goal, and /outcome said {outcome.data}: no answer is no rejection.',
        'word',
    )
    learner.run(3.0, step=1.0)
    expect(
        outcome.data == [f'lost {numbers}'],
        f'The only feedback, {numbers}, came before the answer to the goal; then the cancel request was not answered. '
        f'/outcome said {outcome.data}, expected ["lost {numbers}"].',
        'numbers' if outcome.data and outcome.data[0].startswith('lost [') else 'lost',
    )


@pytest.mark.rules('lost', 'numbers')
@about('lost')
def test_lost_after_long(learner):
    """A goal that is lost after much feedback has the numbers of the last one.

    Each feedback replaces the one before, however many there were.
    """
    draw = learner.random
    patience, first = draw.choice([23.2, 28.7]), draw.randint(1, 99)
    steps = [(0.5, Fibonacci.Feedback(sequence=[first + n])) for n in range(80)]
    outcome, server, _ = begin(learner, 30, patience, steps, cancel='ignore')
    server.late = {'cancel': 4.0}
    learner.run(patience + 2.0, step=5.0)
    expect(server.goals and outcome.data, f'{patience + 1:g} s after the goal /outcome says nothing.', 'lost')
    wanted = f'lost [{first + int((patience + 1.0) / 0.5) - 1}]'
    expect(
        outcome.data == [wanted],
        f'The cancel request was not answered, after {int(patience / 0.5)} times feedback; /outcome said '
        f'{outcome.data}, expected {wanted!r}.',
        'numbers' if outcome.data[0].startswith('lost [') else 'lost',
    )
