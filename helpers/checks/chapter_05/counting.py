"""Exercise 5.3: how goals that come, replace each other and are cancelled at drawn times must end."""

import math
from dataclasses import dataclass, field
from itertools import pairwise

from example_interfaces.action import Fibonacci

from helpers.checks.chapter_05.kept_results import check_kept
from helpers.runner import expect

STEP = 0.5  # seconds: one number
NEVER = math.inf
SAME = 1e-6


def up_to(count: int) -> list[int]:
    return list(range(1, count + 1))


@dataclass
class Count:
    """One goal of a story: when it is sent and cancelled, in seconds from the beginning; what came of it is in `goal`.

    `replaced`: when the next goal was accepted.
    """

    name: str
    at: float
    order: int
    cancel_at: float = NEVER
    replaced: float = NEVER
    goal: object = None

    @property
    def stopped(self) -> float:
        """From when on it adds no number any more, if it is not complete before."""
        return min(self.cancel_at, self.replaced)

    @property
    def complete(self) -> bool:
        return self.at + STEP * self.order < self.stopped

    @property
    def due(self) -> list[float]:
        """When its numbers come."""
        return [time for n in up_to(self.order) if (time := self.at + STEP * n) < self.stopped]


@dataclass
class Story:
    """Goals and cancel requests for one server, in the order of their times."""

    counts: list[Count] = field(default_factory=list)

    def told(self, count: Count) -> str:
        """What happens until this goal has ended, for a message."""
        parts = []
        for one in self.counts:
            if one.at > count.at + STEP * count.order or one.at > count.stopped + STEP:
                break
            refused = ', rejected' if one.order < 1 else ''
            cancelled = f', cancelled at {one.cancel_at:g} s' if one.cancel_at < NEVER else ''
            parts.append(f'{one.name}: order {one.order}, at {one.at:g} s{refused}{cancelled}')
        return f'These goals came ({"; ".join(parts[-6:])}). Goal {count.name} '


def drawn(draw, count: int) -> Story:
    """A story of `count` goals: some replace others, some come together, some are rejected or cancelled.

    The first one is cancelled when the second one has just taken its place, which is not disturbed by that.
    """
    time, counts = 0.0, []
    offsets = [n / 50 for n in range(1, 24)]  # no goal comes, and none is cancelled, just when a number is due
    draw.shuffle(offsets)
    for number in range(count):
        if number > 2 and draw.random() < 0.3:  # together with the one before it
            time = counts[-1].at
        else:
            steps = 1 if number == 1 else draw.choice([1, 1, 2, 3, 5])
            time = (math.floor(time / STEP) + steps) * STEP + offsets[number % 12]
        order = 0 if number % 7 == 3 else draw.choice([3, 4]) if number < 2 else draw.choice([1, 2, 3, 5])
        counts.append(Count(chr(ord('A') + number), round(time, 3), order))
    good = [one for one in counts if one.order >= 1]
    for one, following in pairwise(good):
        one.replaced = following.at
    for number, one in enumerate(good):
        if draw.random() < 0.45:
            later = draw.choice([0, 0, 1, 2]) * STEP + offsets[12 + number % 11]
            ends = min(one.at + STEP * one.order, one.replaced + STEP)
            one.cancel_at = round(min(one.at + later, NEVER), 3)
            if draw.random() < 0.3 and one.replaced < NEVER:  # after another one has taken its place
                one.cancel_at = round(one.replaced + 0.01, 3)
            if one.cancel_at > ends - 0.005:
                one.cancel_at = NEVER
    counts[0].cancel_at, counts[1].cancel_at = round(counts[1].at + 0.01, 3), NEVER
    return Story(counts)


def check_script(learner, count: int) -> None:
    """Expect that `count` goals of a server end as the card says, whenever they come."""
    client = learner.action_client('/count', Fibonacci)
    learner.start('NewestWins', threads=True)
    story = drawn(learner.random, count)
    learner.run(learner.random.choice([0.3, 1.1]), step=STEP)
    begin = learner.now / 1e9
    _happen(learner, client, story)
    for one in sorted(story.counts, key=lambda one: one.order >= 1):  # first those that had to be rejected
        _judge(story, one, begin)


def check_own_results(learner, client) -> None:
    """Expect that each goal of this client that was aborted has a result of its own: rule `aborted`.

    The last goals were to end with other numbers.
    """
    check_kept(
        learner,
        [goal for goal in client.goals if goal.status != 'canceled'],
        lambda goal: f'the goal of order {goal.request.order} ({goal.status})',
        lambda result: list(result.sequence),
        'aborted',
    )


def _happen(learner, client, story: Story) -> None:
    moments = [(one.at, number, 'send', one) for number, one in enumerate(story.counts)]
    moments += [(one.cancel_at, 0, 'cancel', one) for one in story.counts if one.cancel_at < NEVER]
    last = 0.0
    for at, _, kind, one in sorted(moments, key=lambda moment: moment[:2]):
        if at > last:  # goals of one moment are sent together
            learner.run(at - last, step=STEP)
            last = at
        if kind == 'send':
            one.goal = client.send(order=one.order)
        else:
            one.goal.cancel()
    learner.run(max(one.at + STEP * one.order for one in story.counts) - last + 0.3, step=STEP)


def _judge(story: Story, one: Count, begin: float) -> None:
    goal, told = one.goal, story.told(one)
    if one.order < 1:
        expect(goal.accepted is False, f'{told}was accepted: there is no such number to count to.', 'orders')
        return
    expect(goal.accepted, f'{told}{goal.answer}, expected accepted.', 'newest')
    stamps = [round(stamp - begin, 3) for stamp in goal.stamps]
    ended = None if goal.finished is None else round(goal.finished - begin, 3)
    numbers = list(goal.result.sequence) if goal.result else None
    if one.complete:
        _judge_complete(one, told, stamps, ended, numbers)
    else:
        _judge_stopped(one, told, stamps, ended, numbers)


def _judge_complete(one: Count, told: str, stamps, ended, numbers) -> None:
    rule = 'newest'
    expect(
        one.goal.status == 'succeeded',
        f'{told}ended as {one.goal.status or "nothing yet"}, with {numbers}, expected succeeded at '
        f'{one.at + STEP * one.order:g} s, with {up_to(one.order)}: nobody had cancelled it, and no newer goal had '
        'come.',
        rule,
    )
    expect(numbers == up_to(one.order), f'{told}has the result {numbers}, expected {up_to(one.order)}.', 'count')
    expect(
        len(stamps) == len(one.due) and all(abs(a - b) < 0.002 for a, b in zip(stamps, one.due, strict=True)),
        f'{told}sent feedback at {_seconds(stamps)}, expected at {_seconds(one.due)}.',
        rule,
    )
    expect(abs(ended - one.due[-1]) < 0.002, f'{told}ended at {ended:g} s, expected at {one.due[-1]:g} s.', 'count')


def _judge_stopped(one: Count, told: str, stamps, ended, numbers) -> None:
    cancelled = one.cancel_at < one.replaced
    why = f'{"was cancelled" if cancelled else "got a successor"} at {one.stopped:g} s'
    rule, words = ('cancel', {'canceled'}) if cancelled else ('aborted', {'aborted'})
    if max(one.cancel_at, one.replaced) < one.stopped + STEP or one.cancel_at == one.replaced:
        words = {'aborted', 'canceled'}  # both happened before its next step: either word is right
    expect(
        ended is not None and ended <= one.stopped + STEP + SAME,
        f'{told}{why}, and {"went on" if ended is None else f"ended at {ended:g} s"}, expected its end within '
        f'{STEP} s.',
        rule,
    )
    expect(
        one.goal.status in words, f'{told}{why}, and ended as {one.goal.status}, expected {" or ".join(words)}.', rule
    )
    have = up_to(len(one.due))
    expect(
        ended >= one.stopped - SAME,
        f'{told}{why}, but it had ended before, at {ended:g} s, as {one.goal.status}.',
        'newest',
    )
    expect(
        len(stamps) <= len(have) and numbers is not None and len(numbers) <= len(have),
        f'{told}{why}; it had {have}, and then went on to {numbers}, with {len(stamps)} feedback messages.',
        'cancel' if cancelled else 'stops',
    )
    expect(numbers == have, f'{told}{why}; it had {have}, and its result is {numbers}.', rule)
    expect(
        len(stamps) == len(one.due) and all(abs(a - b) < 0.002 for a, b in zip(stamps, one.due, strict=True)),
        f'{told}{why}; it sent feedback at {_seconds(stamps)}, expected at {_seconds(one.due)}.',
        'newest',
    )


def _seconds(times) -> str:
    return f'{", ".join(f"{time:g}" for time in times)} s' if times else 'no time'
