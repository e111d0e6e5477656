"""What the tests of exercise 8.2 share: a governor with a planner before it and a base behind it."""

import pytest
from geometry_msgs.msg import Twist
from rclpy.parameter import Parameter

from helpers.checks.chapter_08.parameter_files import shown
from helpers.checks.chapter_08.parameter_services import Parameters, check_bounds
from helpers.runner import about, expect, explanations
from helpers.runner.verdicts import LearnerCrashed

TABLE = (
    ('max_linear', 0.5, (0.0, 2.0)),
    ('slow_linear', 0.2, (0.0, 2.0)),
    ('rate', 10.0, (1.0, 50.0)),
    ('mode', 'normal', None),
)

# Their periods have more than two decimals, and are whole nanoseconds.
RATES = (1.25, 3.2, 6.4, 8.0, 16.0, 40.0)

LONG = 600  # s, and at 1 message a second as many messages


def command(linear: float, angular: float = 0.0) -> Twist:
    """A command, in m/s and rad/s."""
    message = Twist()
    message.linear.x, message.angular.z = linear, angular
    return message


class Governed:
    """The learner's governor in a namespace, what it hears and what it says."""

    def __init__(self, learner, namespace: str, **parameters):
        """:param parameters: with which it is started."""
        self.learner, self.namespace = learner, namespace
        self.heard = learner.listen(f'{namespace}/cmd_vel', Twist)
        self._talker = learner.talk(f'{namespace}/cmd_vel_in', Twist)
        self.node = learner.start('Governor', remap={'__ns': namespace}, parameters=parameters or None)
        name = f'{namespace}/governor'
        expect(
            self.node.name == name,
            f'In the namespace {namespace}, your node is called {self.node.name}, expected {name}.',
            'names',
        )
        self.parameters = Parameters(learner, name)
        learner.settle()
        for topic, kind in (('cmd_vel_in', 'subscriptions'), ('cmd_vel', 'publishers')):
            there = getattr(learner.endpoints(f'{namespace}/{topic}'), kind)
            absolute = getattr(learner.endpoints(f'/{topic}'), kind)
            expect(
                there,
                f'In the namespace {namespace}, your node has no {kind[:-1]} on {namespace}/{topic}'
                + (f', but one on /{topic}. A relative name has no slash at its beginning.' if absolute else '.'),
                'names',
            )

    def send(self, *commands: Twist) -> None:
        """Publish commands of the planner."""
        self._talker.send(*commands)
        self.learner.settle()

    def after(self, seconds: float) -> list[Twist]:
        """What comes in this time."""
        self.heard.clear()
        self.learner.run(seconds, step=max(1.0, seconds / 20))
        return self.heard.messages

    def newest(self, seconds: float, rule: str) -> Twist:
        """The last message of this time; fail if none comes."""
        found = self.after(seconds)
        expect(
            found,
            f'Nothing came on {self.heard.topic} in {seconds:g} s. The timer publishes in every period, in each mode.',
            rule,
        )
        return found[-1]

    def accepts(self, rule: str, **values) -> None:
        """Set parameters; fail if that is refused, or if a message goes out at that moment."""
        self.heard.clear()
        answer = self.parameters.set(**values)
        expect(answer.successful, f'The request {shown(values)} was refused: {answer.reason!r}.', rule)
        self.learner.settle()
        expect(
            not self.heard.messages,
            f'A message went out at once when {shown(values)} was set. The timer publishes, and nobody else.',
            rule,
        )


def judge_rhythm(governed: Governed, rate: float) -> None:
    """The rules `rhythm`, `before`, `newest` and `limit`; right after the start, with this rate."""
    period = 1 / rate
    first = governed.after(2.5 * period)
    at = [round(stamp, 4) for stamp in governed.heard.stamps]
    expect(
        not governed.learner.slept,
        'Your node sleeps, or waits in a loop, and stands still meanwhile: the timer alone gives the rhythm.',
        'rhythm',
    )
    expect(
        first,
        f'With rate = {rate:g}, nothing came on {governed.heard.topic} in {2.5 * period:g} s after the '
        'start. Before the first command, zeros are expected.',
        'before',
    )
    expect(
        governed.heard.numbers[0] == 1,
        'A message went out in the constructor. Publish in the timer only: the first one comes one period after the '
        'start.',
        'rhythm',
    )
    expect(
        at == pytest.approx([period, 2 * period], abs=1e-4),
        f'With rate = {rate:g}, the first messages came {at} s after the start, expected one every {period:g} s.',
        'rhythm',
    )
    expect(
        all(one == Twist() for one in first),
        f'Before the first command this came: linear.x {first[0].linear.x:g}, angular.z {first[0].angular.z:g}. '
        'Zeros are expected.',
        'before',
    )
    _judge_newest(governed, rate)


def _judge_newest(governed: Governed, rate: float) -> None:
    """What goes out after commands: the newest one, in the rhythm of before."""
    period = 1 / rate
    governed.heard.clear()
    draw = governed.learner.random
    speeds = draw.sample([0.1, 0.2, 0.3, 0.4], 3)
    governed.send(*map(command, speeds[:2]))
    expect(
        not governed.heard.messages,
        'A message went out at once when a command came. Let the callback of the '
        'subscription note the command, and the timer publish it.',
        'rhythm',
    )
    for wanted, count, sent in ((speeds[1], 3, speeds[:2]), (speeds[2], 2, speeds)):
        begin = governed.learner.now / 1e9
        came = governed.after(count * period)
        expect(
            len(came) == count,
            f'With rate = {rate:g}, {len(came)} messages came in {count * period:g} s after the '
            f'commands {sent} m/s, expected {count}: a command is repeated until the next one '
            'comes.',
            'rhythm',
        )
        expect(governed.heard.stamps[0] - begin < period, 'The rhythm changed when a command came.', 'rhythm')
        got = [one.linear.x for one in came]
        expect(
            got == pytest.approx([wanted] * count),
            f'After the commands {sent} m/s these came out: {got}. The newest one is {wanted}, and it is not too fast.',
            'newest' if {0.0, *sent} & set(got) else 'limit',
        )
        governed.send(command(speeds[2]))
    long = min(30.0, 200 * period)
    got = {one.linear.x for one in governed.after(long)}
    expect(
        got == {speeds[2]},
        f'The newest command was {speeds[2]} m/s, and in the {long:g} s after it these came out: {sorted(got)}. It is '
        'published again and again, until the next one comes.',
        'newest',
    )
    _judge_many(governed, period)
    _judge_halt(governed, period)


def _judge_many(governed: Governed, period: float) -> None:
    """A planner that has said hundreds of commands: the newest one counts, as at the beginning."""
    draw = governed.learner.random
    for number in range(24):
        speeds = [round(draw.uniform(0.01, 0.4), 3) for _ in range(10)]  # as many as the subscription keeps
        governed.send(*map(command, speeds))
        got = governed.newest(period, 'rhythm').linear.x
        expect(
            got == pytest.approx(speeds[-1]),
            f'After {10 * number} others these commands came, in m/s: {speeds}. {got:g} m/s came out, expected the '
            'newest one, however many there were before.',
            'newest',
        )


def _judge_halt(governed: Governed, period: float) -> None:
    """A planner that says zero after it drove: it is a command like any other."""
    speed = 0.3
    governed.send(command(speed))
    governed.newest(period, 'rhythm')
    governed.heard.clear()
    governed.send(Twist())
    expect(
        not governed.heard.messages,
        'A message went out at once when the command 0 m/s came. It waits for the timer, like any other.',
        'rhythm',
    )
    got = governed.newest(period, 'rhythm')
    expect(
        got == Twist(),
        f'The planner said {speed:g} m/s, and then 0 m/s; linear.x came out as {got.linear.x:g}. A command of zeros is '
        'the newest one, too: else the robot never stands.',
        'newest',
    )
    little = governed.learner.random.randint(1, 9) / 10_000
    governed.send(command(little, -little))
    got = governed.newest(period, 'rhythm')
    expect(
        (got.linear.x, got.angular.z) == pytest.approx((little, -little), abs=1e-7),
        f'The planner said 0 m/s, and then {little:g} m/s and {-little:g} rad/s; {got.linear.x:g} m/s and '
        f'{got.angular.z:g} rad/s came out. A command that differs by little is the newest one, too.',
        'newest',
    )


def judge_limit(governed: Governed, limit: float, period: float) -> None:
    """The rules `limit` and `other-fields`."""
    draw = governed.learner.random
    turn = draw.choice([-1, 1]) * draw.randint(11, 40) / 1.25  # more than any limit of linear.x
    for speed in (0.5 * limit, limit + draw.randint(10, 90) / 100, -0.4 * limit, -limit - draw.randint(10, 90) / 100):
        wanted = max(-limit, min(limit, speed))
        message = command(speed, turn)
        message.linear.y = message.linear.z = message.angular.x = message.angular.y = 0.7
        governed.send(message)
        got = governed.newest(period, 'rhythm')
        expect(
            got.linear.x == pytest.approx(wanted),
            f'With max_linear = {limit:g}, linear.x {speed:g} came out as {got.linear.x:g}, expected {wanted:g}.',
            'limit',
        )
        expect(
            got.angular.z == turn,
            f'angular.z {turn:g} came out as {got.angular.z:g}. It stays as it is.',
            'other-fields',
        )
        rest = [got.linear.y, got.linear.z, got.angular.x, got.angular.y]
        expect(
            rest == [0.0] * 4,
            f'Other fields than linear.x and angular.z came out as {rest}, expected zeros. '
            'Publish a new Twist with these two fields.',
            'other-fields',
        )


def judge_changes(governed: Governed, limit: float, rate: float) -> None:
    """The rules `at-once`, `newest`, `new-rate` and `refused`, with the mode normal and this limit and rate."""
    limit = _judge_new_limits(governed, limit, rate)
    _judge_refused(governed, limit, rate)
    rate = _judge_new_rate(governed, rate)
    _judge_silent_planner(governed, rate)
    _judge_new_modes(governed, rate)
    _judge_zero(governed, 1 / rate)
    _judge_two(governed)


def _judge_zero(governed: Governed, period: float) -> None:
    """The rules `limit` and `modes`, where the limit is changed to 0.0, and `pair`, where both are."""
    for change, name, rule, refused in (
        ({'slow_linear': 0.0, 'mode': 'slow'}, 'slow_linear', 'modes', 'modes'),
        ({'max_linear': 0.0, 'mode': 'normal'}, 'max_linear', 'limit', 'pair'),  # both are 0.0: none is above the other
    ):
        governed.accepts(refused, **change)
        for speed in (0.4, -0.4):
            governed.send(command(speed))
            got = governed.newest(period, 'rhythm').linear.x
            expect(
                got == 0,
                f'After the request {shown(change)}, linear.x {speed:g} came out as {got:g}, expected 0. A limit of '
                f'{name} = 0.0 is a limit, too; in Python, 0.0 counts as false.',
                rule,
            )


def _judge_two(governed: Governed) -> None:
    """The rule `before`, of another governor in the same program, to which no command comes: this one stands."""
    governed.send(command(0.3, 0.5))
    governed.accepts('at-once', mode='stop')
    governed.learner.start('Governor', beside=governed.node)
    governed.learner.settle()
    wrong = [one for one in governed.after(0.25) if one != Twist()]
    speed = wrong[0].linear.x if wrong else 0.0
    expect(
        not wrong,
        'A governor has got the command 0.3 m/s, and stands in the mode stop. A second one was made in the same '
        f'program, no command has come to it, and it says {speed:g} m/s: the command belongs to the object (self), not '
        'to the class.',
        'before',
    )


def _judge_new_limits(governed: Governed, limit: float, rate: float) -> float:
    """A command that is too fast, while `max_linear` changes twice; returns the limit that is left."""
    period = 1 / rate
    governed.send(command(3.0, 0.5))
    governed.newest(period, 'rhythm')
    speeds = [one.linear.x for one in governed.after(2 * period)]
    expect(
        len(speeds) == 2,
        f'With rate = {rate:g}, {len(speeds)} messages came in 2 periods, that is in {2 * period:g} s.',
        'rhythm',
    )
    expect(
        speeds == pytest.approx([limit] * 2),
        f'With max_linear = {limit:g}, after the one command 3.0 m/s these came out: {speeds}, expected {limit:g} '
        'again and again.',
        'limit' if any(speeds) else 'newest',
    )
    governed.learner.run(0.3 * period)
    other = limit
    for change in (-0.15, 0.3):  # what was cut off when it came does not come back
        before, other = other, round(other + change, 2)
        governed.accepts('at-once', max_linear=other)
        got = governed.newest(period, 'rhythm')
        expect(
            got.linear.x == pytest.approx(other),
            f'The command is 3.0 m/s. max_linear was changed from {before:g} to {other:g}, and linear.x is '
            f'{got.linear.x:g}. Keep the command as it came, and read the parameter when you publish.',
            'at-once',
        )
    expect(
        _in_rhythm(governed, rate),
        'After a change of max_linear, the messages come at other moments. Only a new rate begins with a new period.',
        'new-rate',
    )
    for change in ({'slow_linear': 0.15}, {'mode': 'slow'}, {'mode': 'stop'}, {'mode': 'normal'}):
        governed.accepts('at-once', **change)
        governed.newest(period, 'modes')
        expect(
            _in_rhythm(governed, rate),
            f'After the request {shown(change)}, 0.3 periods after a message, the messages come at other moments. Only '
            'a new rate begins with a new period: leave the timer alone.',
            'new-rate',
        )
    governed.send(command(3.0, 0.5))  # whether the one before has outlived the mode stop is looked at later
    return other


def _in_rhythm(governed: Governed, rate: float) -> bool:
    """Whether the last message came a whole number of periods after the start."""
    late = (governed.heard.stamps[-1] * rate) % 1
    return min(late, 1 - late) < 0.01


def _judge_refused(governed: Governed, limit: float, rate: float) -> None:
    """Requests of which one part is wrong: refused, and nothing is changed by them."""
    period = 1 / rate
    above = round(limit + 0.1, 2)
    for bad, rule in (
        ({'max_linear': above, 'mode': 'fast'}, 'unknown-mode'),
        ({'mode': 'turbo'}, 'unknown-mode'),
        ({'rate': 2 * rate, 'mode': 'Slow'}, 'unknown-mode'),
        ({'mode': 'slow', 'slow_linear': 2.5}, 'bounds'),
        ({'mode': 'stop', 'slow_linear': above}, 'pair'),
        ({'mode': 'slow', 'max_linear': 0.05}, 'pair'),
        ({'rate': 2 * rate, 'slow_linear': above}, 'pair'),
        ({'max_linear': 0.05, 'rate': rate}, 'pair'),
    ):
        expect(not governed.parameters.set(**bad).successful, f'The request {shown(bad)} was accepted.', rule)
        came = governed.after(2 * period)
        speeds = sorted({one.linear.x for one in came})
        expect(
            len(came) == 2 and speeds == pytest.approx([limit]),
            f'The request {shown(bad)} was refused, and yet the node works in another way since then: {len(came)} '
            f'messages in {2 * period:g} s, linear.x {speeds}. While you check, store and change nothing.',
            'refused',
        )
        expect(
            _in_rhythm(governed, rate),
            f'The request {shown(bad)} was refused, and since then the messages come at other moments. While you '
            'check, leave the timer alone.',
            'refused',
        )


def _judge_new_rate(governed: Governed, rate: float) -> float:
    """Other rates, alone and with another value, which begin with a new period; returns the last one.

    The first one comes in the mode stop, and the second one ends this mode.
    """
    draw = governed.learner.random
    between = [one for one in RATES[1:-1] if one != rate]
    news = [one for one in (RATES[0], RATES[-1]) if one != rate]  # the slowest and the fastest
    news += draw.sample(between, 3 - len(news))
    draw.shuffle(news)
    governed.accepts('at-once', mode='stop')
    for new, before, behind in zip(news, ({}, {'mode': 'normal'}, {}), ({}, {}, {'mode': 'normal'}), strict=True):
        request = {**before, 'rate': new, **behind}
        governed.accepts('new-rate', **request)
        begin = governed.learner.now / 1e9
        governed.after(3.5 / new)
        at = [round(stamp - begin, 4) for stamp in governed.heard.stamps]
        expect(
            at == pytest.approx([1 / new, 2 / new, 3 / new], abs=1e-4),
            f'The rate was {rate:g}, and the request {shown(request)} was accepted'
            + (', in the mode stop' if new == news[0] else '')
            + '. After that, messages came after '
            f'{at} s, expected one every {1 / new:g} s.'
            + (' Does the old timer still run?' if len(at) > 3 else '')
            + (' Look at all parameters of a request.' if len(request) > 1 else ''),
            'new-rate',
        )
        rate = new
    return rate


def _judge_silent_planner(governed: Governed, rate: float) -> None:
    """One command, and none for minutes: it is still the newest one, and the rhythm goes on.

    Afterwards the rate is the one of before.
    """
    governed.send(command(0.1, 0.5))
    governed.accepts('new-rate', rate=1.0)
    came = governed.after(LONG + 0.5)
    expect(
        len(came) == LONG,
        f'With rate = 1, {len(came)} messages came in {LONG + 0.5:g} s, expected {LONG}: it goes on as long as the '
        'robot runs.',
        'rhythm',
    )
    got = {(one.linear.x, one.angular.z) for one in came}
    expect(
        got == {(0.1, 0.5)},
        f'The planner said 0.1 m/s and 0.5 rad/s, then rate was set to 1, and for {LONG} s nothing else came. In this '
        f'time (linear.x, angular.z) was {sorted(got)}. A command holds until the next one comes, whatever is set.',
        'limit' if len(got) == 1 and got != {(0.0, 0.0)} else 'newest',
    )
    governed.accepts('new-rate', rate=rate)
    governed.send(command(3.0, 0.5))


def _judge_new_modes(governed: Governed, rate: float) -> None:
    """The modes stop and slow, while the newest command is too fast for both, and came before stop or during it."""
    slow = governed.parameters.get('slow_linear')
    for turn, when in ((0.5, 'before'), (-0.5, 'during')):
        governed.accepts('at-once', mode='stop')
        if when == 'during':
            governed.send(command(3.0, turn))
        got = governed.newest(1 / rate, 'at-once')
        expect(
            got == Twist(),
            f'The mode was changed to stop, and the next message says linear.x {got.linear.x:g}, '
            f'angular.z {got.angular.z:g}.',
            'at-once',
        )
        if when == 'before':
            _judge_long_stop(governed, rate)
        governed.accepts('at-once', mode='slow')
        got = governed.newest(1 / rate, 'at-once')
        expect(
            (got.linear.x, got.angular.z) == pytest.approx((slow, turn)),
            f'The newest command is 3 m/s, {turn:g} rad/s; it came {when} the mode stop. The mode is now slow, and the '
            f'next message says {got.linear.x:g} m/s, {got.angular.z:g} rad/s, expected {slow:g} and {turn:g}.',
            'newest' if got == Twist() or got.angular.z == -turn else 'at-once',
        )
        governed.send(command(-slow / 2, turn))
        got = governed.newest(1 / rate, 'at-once').linear.x
        expect(
            got == pytest.approx(-slow / 2),
            f'In the mode slow, with slow_linear = {slow:g}, linear.x {-slow / 2:g} came out as {got:g}. What is '
            'smaller than the limit stays as it is.',
            'modes',
        )
        governed.send(command(3.0, turn))


def _judge_long_stop(governed: Governed, rate: float) -> None:
    """The rules `rhythm` and `modes`: the mode stop lasts, and zeros go out in each of its periods."""
    came = governed.after(20.5 / rate)
    expect(
        len(came) == 20,
        f'In the mode stop, with rate = {rate:g}, {len(came)} messages came in 20.5 periods, expected 20. It publishes '
        'in each mode, as long as the mode lasts: in stop, zeros.',
        'rhythm',
    )
    wrong = [one for one in came if one != Twist()]
    speed, turn = (wrong[0].linear.x, wrong[0].angular.z) if wrong else (0.0, 0.0)
    expect(
        not wrong,
        f'In the mode stop, {len(wrong)} of 20 messages are no zeros: linear.x {speed:g}, angular.z {turn:g}. It holds '
        'until the mode changes.',
        'modes',
    )


def judge_modes(learner, namespace: str) -> None:
    """The rules `modes` and `at-start`: a governor that is started in the modes stop and slow."""
    draw = learner.random
    pairs = [(0.05, 0.12 + draw.randint(0, 5) / 100), (0.8, 1.3 + draw.randint(0, 5) / 100)]  # around the defaults
    draw.shuffle(pairs)
    for mode, (slow, limit) in zip(('stop', 'slow'), pairs, strict=True):
        wanted = command(slow, 0.4) if mode == 'slow' else Twist()
        start = {'mode': mode, 'slow_linear': slow, 'max_linear': limit, 'rate': 20.0}
        with about('at-start'):
            governed = _started(learner, f'{namespace}_{mode}', start)
        governed.send(command(3.0, 0.4))
        got = governed.newest(0.05, 'at-start')
        what = f'Started with {shown(start)}: the command 3.0 m/s, 0.4 rad/s'
        expect(
            (got.linear.x, got.angular.z) == pytest.approx((wanted.linear.x, wanted.angular.z)),
            f'{what} came out as linear.x {got.linear.x:g}, angular.z {got.angular.z:g}, expected '
            f'{wanted.linear.x:g} and {wanted.angular.z:g}.',
            'modes',
        )
        governed.send(command(-3.0, 0.4))
        got = governed.newest(0.05, 'at-start')
        expect(
            got.linear.x == pytest.approx(-wanted.linear.x),
            f'In the mode {mode}, linear.x -3 came out as {got.linear.x:g}.',
            'modes',
        )


def _started(learner, namespace: str, start: dict) -> Governed:
    """A governor with these values: all are good together, and one of them may not fit the default of another."""
    try:
        return Governed(learner, namespace, **start)
    except LearnerCrashed as crash:
        expect(
            'InvalidParameterValue' not in str(crash),
            f'The node does not start with {shown(start)}, and these values are good: while one of them is declared, '
            f'another one may have no value yet, and its default does not count. {crash}',
            'at-start',
        )
        raise


def judge_bad_start(learner, *starts: dict) -> None:
    """The rule `at-start`: with these values the node must not start."""
    for values in starts:
        try:
            learner.start('Governor', parameters=values)
        except LearnerCrashed:
            continue
        expect(
            False,
            f'The node starts with {shown(values)}. When the parameters are declared, nothing checks them: '
            'is the callback added before?',
            'at-start',
        )


def judge_table(governed: Governed) -> None:
    """The rules `defaults`, `description` and `bounds`, of a governor that has just started."""
    parameters, draw = governed.parameters, governed.learner.random
    for name, default, bounds in TABLE:
        found = parameters.describe(name)
        expect(found, f'There is no parameter {name}.', 'defaults')
        wanted = Parameter(name, value=default).type_
        expect(
            found.type == wanted.value,
            f'{name} has the type {Parameter.Type(found.type).name}, expected {wanted.name}. The default gives the '
            f'type: write {default!r}.',
            'defaults',
        )
        expect(
            not found.dynamic_typing,
            f'{name} may change its type: leave dynamic_typing out of its descriptor. The default gives the type.',
            'defaults',
        )
        value = parameters.get(name)
        expect(value == default, f'{name} is {value!r} at the start, expected {default!r}.', 'defaults')
        expect(found.description.strip(), f'{name} has no description.', 'description')
        if bounds:
            check_bounds(found, bounds)
    for name, value in (
        ('max_linear', draw.randint(201, 900) / 100),
        ('slow_linear', -draw.randint(1, 90) / 100),
        ('rate', 0.5),
        ('rate', 51.0),
    ):
        expect(not parameters.set(**{name: value}).successful, f'{name} = {value!r} was accepted.', 'bounds')
    for name, value in (('max_linear', 2.0), ('slow_linear', 0.0), ('rate', 50.0), ('rate', 1.0)):
        governed.accepts('bounds', **{name: value})


def judge_rules(governed: Governed) -> None:
    """The rules `unknown-mode`, `pair`, `reason` and `refused`, on the values of the parameters."""
    parameters, draw = governed.parameters, governed.learner.random
    governed.accepts('pair', max_linear=0.5, slow_linear=0.2)
    low, high = draw.randint(5, 15) / 100, draw.randint(60, 190) / 100
    for values, good in (
        ({'slow_linear': high}, False),
        ({'max_linear': low}, False),
        ({'max_linear': 0.0}, False),
        ({'slow_linear': 0.0, 'max_linear': low}, True),
        ({'max_linear': high, 'slow_linear': high}, True),
        ({'max_linear': 0.55, 'slow_linear': 0.3}, True),  # the first one alone would be refused
        ({'slow_linear': high, 'max_linear': high}, True),
        ({'max_linear': 0.3}, False),
        ({'slow_linear': low / 2, 'max_linear': low}, True),
        ({'slow_linear': high}, False),
        ({'max_linear': low, 'slow_linear': high}, False),
        ({'mode': 'slow', 'max_linear': low, 'slow_linear': high}, False),
        ({'slow_linear': low}, True),
        ({'mode': draw.choice(['fast', 'Slow'])}, False),
        ({'mode': ''}, False),
        ({'mode': draw.choice(['norm', 'low', 'to'])}, False),
        ({'mode': 'slow'}, True),
        ({'slow_linear': high}, False),
        ({'max_linear': low / 2}, False),
        ({'mode': 'stop'}, True),
        ({'slow_linear': high}, False),
        ({'max_linear': low / 2}, False),
        ({'mode': 'normal '}, False),
        ({'mode': 'normal'}, True),
    ):
        pair = bool({'max_linear', 'slow_linear'} & values.keys())
        rule = 'pair' if pair else 'unknown-mode'
        now = {name: parameters.get(name) for name in ('max_linear', 'slow_linear', 'mode')}
        after = now | values
        equal = good and pair and after['slow_linear'] == after['max_linear']
        answer = parameters.set(**values)
        expect(
            answer.successful == good,
            f'With {shown(now)}, the request {shown(values)} was {"refused" if good else "accepted"}. '
            + ('Judge the values as they would be after the request, in each mode.' if pair and not equal else '')
            + ('Equal values are good: slow_linear is not above max_linear.' if equal else '')
            + (' In Python, 0.0 counts as false.' if 0.0 in values.values() else ''),
            rule,
        )
        if not good:
            names = ['slow_linear', 'max_linear'] if pair else ['mode']
            expect(
                any(name in answer.reason for name in names),
                f'The request {shown(values)} was refused with the reason {answer.reason!r}, which does not name '
                f'{names[0]}. {explanations.explain("InvalidParameterValueException", answer.reason)}'.strip(),
                'reason',
            )
            kept = {name: parameters.get(name) for name in now}
            expect(kept == now, f'The request {shown(values)} was refused, and yet now {shown(kept)}.', 'refused')
