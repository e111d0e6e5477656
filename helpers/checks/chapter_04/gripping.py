"""Exercise 4.1: what a patient client sends and reports, for commands and answers that are drawn."""

from dataclasses import dataclass, field

from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.runner import about, expect

MS = 0.001  # times are counted in milliseconds
_WHOLE = 4  # so many commands of a story are not dropped


@dataclass
class GripperAnswer:
    """What the server does with one request: it answers after `delay` ms, or never (None)."""

    delay: int | None
    success: bool = True


@dataclass
class GripperStory:
    """What the card says for a client: `requests` as (ms, data), and `reports` as (ms, word, why it is so)."""

    timeout: int
    tries: int
    commands: list[tuple[int, bool]]
    answers: list[GripperAnswer]
    requests: list[tuple[int, bool]] = field(default_factory=list)
    reports: list[tuple[int, str, str]] = field(default_factory=list)

    def __post_init__(self):
        ends = [time for time, _ in self.commands[1:]] + [None]
        for (begin, data), end in zip(self.commands, ends, strict=True):
            self._follow(begin, data, end)

    def _follow(self, begin: int, data: bool, end: int | None) -> None:
        """One command, which the next one drops at `end`."""
        for number in range(self.tries):
            time = begin + number * self.timeout
            if end is not None and time >= end:
                return
            answer = self.answers[len(self.requests) % len(self.answers)]
            self.requests.append((time, data))
            if answer.delay is not None and answer.delay < self.timeout:
                if end is None or time + answer.delay < end:
                    rule = 'answer' if answer.success else 'refusal'
                    self.reports.append((time + answer.delay, 'ok' if answer.success else 'refused', rule))
                return
        time = begin + self.tries * self.timeout
        if end is None or time < end:
            self.reports.append((time, 'failed', 'tries'))

    def is_definite(self) -> bool:
        """Whether no two of its commands, requests, answers and last timeouts come in the same millisecond.

        For those the card leaves open which comes first.
        """
        moments = [time for time, _ in self.commands]
        asked = [time for time, _ in self.requests if time not in moments]  # a command makes its first request
        delays = (self.answers[number % len(self.answers)].delay for number in range(len(self.requests)))
        came = [time + delay for (time, _), delay in zip(self.requests, delays, strict=True) if delay is not None]
        given_up = [time for time, word, _ in self.reports if word == 'failed']
        moments += asked + came + given_up
        return len(set(moments)) == len(moments)


def drawn(draw, count: int) -> GripperStory:
    """A story of `count` commands, in which nothing depends on what comes first at one moment."""
    while True:
        story = _drawn(draw, count)
        if story.is_definite():
            return story


def _drawn(draw, count: int) -> GripperStory:
    timeout, tries = draw.choice([400, 700, 1100]), draw.choice([3, 3, 4, 5])
    commands, time = [], 0
    for number in range(count):
        # Off the raster of the timeouts, so that no command comes just when a request is sent.
        pause = 4 * tries + 2 if 1 <= number <= _WHOLE else draw.randrange(2, 4 * tries + 3)
        time += pause * (timeout // 4) + draw.randrange(7, timeout // 9)
        commands.append((time, draw.choice([False, True])))
    answers = [GripperAnswer(_delay(draw, timeout), draw.random() < 0.5) for _ in range(draw.randint(5, 9))]
    yes = draw.choice([False, True])
    late = [(yes, not yes), (not yes, yes)]  # what a late answer says, and what then the one to the second request says
    first = [
        answer
        for one, other in late
        for answer in (
            GripperAnswer(timeout + draw.randrange(11, timeout // 2), one),
            GripperAnswer(draw.randrange(timeout // 2, timeout - 10), other),
        )
    ]
    nothing = [GripperAnswer(None)] * (2 * tries)  # two commands fail, one after the other
    return GripperStory(timeout, tries, commands, [*first, *nothing, *answers])


def _delay(draw, timeout: int) -> int | None:
    """In time, too late, or never."""
    in_time, late = draw.randrange(3, timeout - 10), draw.randrange(timeout + 11, 3 * timeout)
    return draw.choice([in_time, in_time, late, None])


def check_script(learner, count: int) -> None:
    """Expect that a client sends and reports what the card says, while `count` commands come."""
    story = drawn(learner.random, count)
    states, close = learner.listen('/gripper_state', String), learner.talk('/close', Bool)
    answers = iter(story.answers * (8 * count))
    now: list[GripperAnswer] = []

    def answer(_):
        return {'success': now[-1].success} if now[-1].delay is not None else None

    def delay(_):
        now.append(next(answers))
        return (now[-1].delay or 0) * MS

    server = learner.serve('/set_gripper', SetBool, answer, delay)
    learner.start('GripperClient', story.timeout * MS, story.tries)
    before, time = learner.slept, 0
    with about('request'):
        for at, data in story.commands:
            learner.run((at - time) * MS, step=1.0)
            close.send(Bool(data=data))
            learner.settle()
            time = at
        learner.run((story.tries + 1) * story.timeout * MS, step=1.0)
    expect(learner.slept <= before, 'A callback sleeps, and the whole node stands still meanwhile.', 'timeout')
    requests = [(round(at / MS), request.data) for at, request in zip(server.stamps, server.requests, strict=True)]
    reports = [(round(at / MS), word) for at, word in zip(states.stamps, states.data, strict=True)]
    _compare(story, requests, reports)


def _compare(story: GripperStory, requests, reports) -> None:
    """Say what was the first thing that was not as the card says."""
    wanted = [(at, word) for at, word, _ in story.reports]
    seen = _first_difference(requests, story.requests)
    told = _first_difference(reports, wanted)
    if seen is None and told is None:
        return
    at = min(time for time in (seen, told) if time is not None)
    first = story.commands[0][0]
    check_before_commands(
        f'GripperClient({story.timeout * MS:g}, {story.tries}), the first command at {first * MS:.3f} s: ',
        [(time * MS, word) for time, word in reports if time < first],
    )
    begin, data = max((command for command in story.commands if command[0] <= at), default=story.commands[0])
    words = (
        f'GripperClient({story.timeout * MS:g}, {story.tries}), the command {data} at {begin * MS:.3f} s'
        f'{_before(story, begin)}; {_answers(story, begin)}. '
    )
    end = min((time for time, _ in story.commands if time > begin), default=10**9)
    sent, due = _between(requests, begin, end), _between(story.requests, begin, end)
    if seen == at:
        expect(
            False,
            f'{words}Until the next command requests came {_listed(sent)}, expected {_listed(due)}.',
            _rule_of_requests(story, sent, due, _between(reports, begin, end)),
        )
    said, right = _between(reports, begin, end), _between(wanted, begin, end)
    rule = next((rule for time, _, rule in story.reports if time == at), _rule_of_report(story, at, begin))
    expect(False, f'{words}Until the next command gripper_state said {_listed(said)}, expected {_listed(right)}.', rule)


def _rule_of_report(story: GripperStory, at: int, begin: int) -> str:
    """Which rule is broken by a report at this time that should not be; `begin`: of the command that was the newest."""
    for number, (time, _) in enumerate(story.requests):
        delay = story.answers[number % len(story.answers)].delay
        if delay is not None and time + delay == at:  # the answer to this request came just then
            return 'newest' if time < begin else 'late'
    return 'once'


def _first_difference(one: list, other: list) -> int | None:
    """The time of the first entry that is not in both lists."""
    return min((entry[0] for entry in set(one) ^ set(other)), default=None)


def _before(story: GripperStory, begin: int) -> str:
    earlier = [time for time, _ in story.commands if time < begin]
    if not earlier:
        return ''
    last = max(earlier)
    ended = any(last <= time < begin for time, _, _ in story.reports)
    return f' (the one before it, at {last * MS:.3f} s, {"had been reported" if ended else "was open still"})'


def _answers(story: GripperStory, begin: int) -> str:
    """What the server does with the requests of a command, as far as the card lets them come."""
    end = min((time for time, _ in story.commands if time > begin), default=10**9)
    numbers = [number for number, (time, _) in enumerate(story.requests) if begin <= time < end]
    told = []
    for number in numbers:
        answer = story.answers[number % len(story.answers)]
        yes = f'{"yes" if answer.success else "no"} after {(answer.delay or 0) * MS:.3f} s'
        told.append('nothing' if answer.delay is None else yes)
    return f'the server says to its requests: {", then ".join(told)}'


def _between(entries, begin: int, end: int) -> list:
    return [entry for entry in entries if begin <= entry[0] < end]


def _listed(entries) -> str:
    return ', '.join(f'{what} at {time * MS:.3f} s' for time, what in entries) or 'nothing'


def _rule_of_requests(story, sent, due, reports) -> str:
    """Which rule is broken by these requests of one command; `reports`: what was reported of it."""
    if not sent or sent[0] != due[0]:
        return 'request'
    if any(data is not due[0][1] for _, data in sent):
        return 'request'
    if story.tries >= len(sent) > len(due):  # one more after the answer, which is reported or not
        return 'once' if any(time <= sent[len(due)][0] for time, _ in reports) else 'refusal'
    return 'tries' if len(sent) != len(due) else 'timeout'


def check_before_commands(words: str, reports: list[tuple[float, str]]) -> None:
    """Nothing was reported before the first command; `reports` are what was, each with its time in seconds."""
    time, word = reports[0] if reports else (0.0, '')
    expect(
        not reports,
        f'{words}gripper_state says {word} at {time:g} s, before any command. Does a timer run from the start? With '
        'autostart=False it begins with reset().',
        'once',
    )


_OWN = 'Keep it in the object (self.… =): what is kept in the class, or outside of it, belongs to the one made last.'


class _Side:
    """A client of the learner's in a namespace of its own, with its server, which is silent until it has an answer."""

    def __init__(self, learner, space: str, timeout: float, tries: int, beside=None):
        self.learner, self.timeout, self.tries = learner, timeout, tries
        self.called = f'GripperClient({timeout}, {tries})'
        self.server = learner.serve(f'{space}/set_gripper', SetBool, None)
        self.states = learner.listen(f'{space}/gripper_state', String)
        self.close = learner.talk(f'{space}/close', Bool)
        self.node = learner.start('GripperClient', timeout, tries, beside=beside, remap={'__ns': space})
        learner.settle()

    def command(self, data: bool, answer=None) -> None:
        """Send a command, and forget what came before it; the server gives this answer after 0.2 s, or none."""
        self.server.requests.clear()
        self.server.stamps.clear()
        self.states.clear()
        self.server.answer, self.server.delay = answer, 0.2
        self.close.send(Bool(data=data))
        with about('request'):
            self.learner.settle()

    @property
    def asked(self) -> list[float]:
        """When its requests came, in seconds from the first of them."""
        return [round(stamp - self.server.stamps[0], 3) for stamp in self.server.stamps]

    @property
    def seen(self) -> tuple[list[float], list[bool], list[str]]:
        """When its requests came, their data, and what it has reported."""
        return self.asked, [request.data for request in self.server.requests], self.states.data


def check_own_state(learner) -> None:
    """A client does the same alone and when another one has been made, in one program and another namespace.

    First their servers are silent, then each gives an answer of its own. What the first client does alone is judged by
    other tests.
    """
    draw = learner.random
    tries, timeouts, data = draw.sample([2, 4, 5], 2), draw.sample([0.3, 0.5, 0.8], 2), draw.choice([False, True])
    first = _Side(learner, '/first', timeouts[0], tries[0])
    first.command(data)
    with about('request'):
        learner.run(5.0, step=1.0)
    alone = first.seen
    first.command(True, {'success': True})
    learner.run(0.6)
    answered = first.seen
    second = _Side(learner, OTHER, timeouts[1], tries[1], beside=first.node)
    first.command(data)
    second.command(not data)
    with about('request'):
        learner.run(5.0, step=1.0)
    story = 'Each heard a command, and its server is silent'
    # Where the second one has sent what it should, the first one may be silent for another reason.
    asked, more = len(first.server.requests), max(0, len(second.server.requests) - second.tries)
    check_own('GripperClient', story, asked, more, 'set_gripper', 'client', 'request')
    expect(
        asked or not second.server.requests,
        f'{first.called} heard the commands {data}, True and {data}, each long after the one before it, and the third '
        'one made no request: for each command it calls the service, whatever came before.',
        'request',
    )
    both = f'{first.called} is in one program with {second.called}, made after it. '
    _judge_silent(first, second, alone, f'{both}{story}. The first one sent requests')
    # Where the second one has said what both should say, the first one may be silent for another reason.
    counts = len(first.states), max(0, len(second.states) - 1)
    check_own('GripperClient', story, *counts, 'gripper_state', 'publisher', 'answer')
    said = first.states.data
    expect(
        said == alone[2],
        f'{both}{story}. The first one reported {said}, expected {alone[2]}, as when it is alone. {_OWN}',
        'tries',
    )
    first.command(True, {'success': True})
    learner.run(0.1)
    second.command(True, {'success': False})
    learner.run(0.5)
    expect(
        first.seen == answered,
        f'{both}Each heard a command, the second one 0.1 s after the first, and each server answered after 0.2 s: that '
        f'of the first client yes, that of the second one no. The first one sent requests at {first.asked} s from the '
        f'first of them, and reported {first.states.data}, expected {answered[0]} and {answered[2]}, as when it is '
        f'alone. {_OWN}',
        'answer',
    )


def _judge_silent(first: _Side, second: _Side, alone, words: str) -> None:
    """The requests of the first of two clients, whose server is silent: it has its own timeout, tries and command."""
    if not first.server.stamps:  # why there is none, other tests say
        return
    seen, data, _ = first.seen
    words = f'{words} at {seen} s from the first of them'
    expect(len(seen) != second.tries, f'{words}: as many as the `tries` of the other one. {_OWN}', 'tries')
    expect(seen[1:2] != [second.timeout], f'{words}: with the `timeout` of the other one. {_OWN}', 'timeout')
    expect(
        seen == alone[0],
        f'{words}, expected at {alone[0]} s, as when it is alone. {_OWN}',
        'timeout' if len(seen) == len(alone[0]) else 'tries',
    )
    # A number of tries in the class may be right for the first one by chance.
    sent = len(second.asked)
    expect(
        len(seen) != first.tries or sent in (second.tries, len(seen)),
        f'{second.called} is in one program with {first.called}, which was made before it. Each heard a command, and '
        f'its server is silent. The second one sent {sent} requests, expected {second.tries}. {_OWN}',
        'tries',
    )
    expect(
        data == alone[1],
        f'{words}, with the data {data}, expected {alone[1]}: the other one had the command {not alone[1][0]}. {_OWN}',
        'request',
    )
