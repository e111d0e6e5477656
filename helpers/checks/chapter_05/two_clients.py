"""Two objects of exercise 5.2's client in one program, in two namespaces: each has a goal and an end of its own."""

from dataclasses import dataclass

from example_interfaces.action import Fibonacci
from std_msgs.msg import String

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.runner import about, expect

_OWN = 'Keep it in the object (self.… =): what is kept in the class, or outside of it, belongs to the one made last.'


@dataclass(frozen=True)
class _Seen:
    """What one client did: the orders of its goals, when it asked to cancel (s after its goal came), its outcomes."""

    orders: list[int]
    cancels: list[float]
    outcomes: list[str]


class _Side:
    """A namespace of its own: the server and the outcomes of a client, which is made by `start`."""

    def __init__(self, learner, space: str, order: int, patience: float, value: int, **server):
        self.learner, self.space, self.order, self.patience = learner, space, order, patience
        self._before = 0  # so many goals are of earlier clients
        feedback, ended = Fibonacci.Feedback(sequence=[-value]), Fibonacci.Result(sequence=[value])
        plan = [(server.pop('delay'), feedback), (60.0, Fibonacci.Result())]
        self.server = learner.action_server(f'{space}/fibonacci', Fibonacci, plan, partial=ended, **server)
        self.outcomes = learner.listen(f'{space}/outcome', String)

    @property
    def called(self) -> str:
        """How the client is made, for a message."""
        return f'PatientClient({self.order}, {self.patience})'

    def start(self, beside):
        """Make a client, and forget what an earlier one has done; returns its node."""
        self._before = len(self.server.goals)
        self.server.cancel_stamps.clear()
        self.outcomes.clear()
        return self.learner.start('PatientClient', self.order, self.patience, beside=beside, remap={'__ns': self.space})

    @property
    def seen(self) -> _Seen:
        """What its client has done."""
        goals, stamps = self.server.goals[self._before :], self.server.cancel_stamps
        begin = goals[0].arrived if goals else 0.0
        return _Seen(
            [goal.request.order for goal in goals], [round(stamp - begin, 1) for stamp in stamps], self.outcomes.data
        )


def check_two_clients(learner, beside=None) -> None:
    """A client does the same alone and when another one, with another order and patience, is made after it.

    The server of the first one gives feedback and answers the cancel request too late; that of the second one, whose
    feedback comes later, ends its goal. What the first client does alone is judged by other tests.

    :param beside: a node in whose process they are made, if there is one.
    """
    draw = learner.random
    orders, (long, short) = draw.sample(range(3, 30), 2), draw.choice([(1.5, 0.7), (1.8, 0.8)])
    values = draw.sample(range(3, 99), 2)
    first = _Side(learner, '/first', orders[0], long, values[0], delay=0.3, cancel='ignore')
    first.server.late = {'cancel': 1.6}
    node = first.start(beside)
    with about('once'):
        learner.run(long + 2.5, step=1.0)
    alone = first.seen
    second = _Side(learner, OTHER, orders[1], short, values[1], delay=0.4, cancel='accept')
    first.start(beside or node)
    second.start(beside or node)
    with about('once'):
        learner.run(long + 2.5, step=1.0)
    _judge_first(first, second, alone)


def _judge_first(first: _Side, second: _Side, alone: _Seen) -> None:
    seen, both = first.seen, ('Each looks for its server', 'Both goals ended')
    if not alone.orders or not alone.outcomes:  # why there is none, other tests say
        return
    check_own('PatientClient', both[0], len(seen.orders), len(second.seen.orders), 'fibonacci', 'action client', 'send')
    words = f'{first.called} is in one program with {second.called}, made after it in another namespace. The first one '
    expect(
        seen.orders == alone.orders,
        f'{words}sent goals of the orders {seen.orders}, expected {alone.orders}, as when it is alone. {_OWN}',
        'send',
    )
    expect(
        seen.cancels == alone.cancels,
        f'{words}asked to cancel its goal {_after(seen.cancels)}, expected {_after(alone.cancels)}, as when it is '
        f'alone. {_OWN}',
        'deadline',
    )
    check_own('PatientClient', both[1], len(seen.outcomes), len(second.seen.outcomes), 'outcome', 'publisher', 'once')
    expect(
        len(seen.outcomes) == len(alone.outcomes),
        f'{words}said {seen.outcomes} on /outcome, expected {alone.outcomes}, as when it is alone. {_OWN}',
        'once',
    )
    expect(
        seen.outcomes == alone.outcomes,
        f'{words}said {seen.outcomes} on /outcome, expected {alone.outcomes}, as when it is alone: its numbers are not '
        f'those of the goal of the other one. {_OWN}',
        'numbers',
    )


def _after(cancels: list[float]) -> str:
    return f'{" and ".join(map(str, cancels))} s after it was accepted' if cancels else 'never'
