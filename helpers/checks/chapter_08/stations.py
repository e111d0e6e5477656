"""What the tests of exercise 8.7 share: the learner's StationKeeper, and what is asked of it."""

import math

import pytest
from delivery_interfaces.srv import SetStation
from rclpy.parameter import Parameter
from std_msgs.msg import String

from helpers.checks.chapter_03.endpoints import check_lifespan
from helpers.checks.chapter_08.parameter_services import Parameters, check_bounds
from helpers.runner import about, expect
from helpers.runner.peers import SECOND
from helpers.runner.verdicts import WiringError

TABLE = {
    'max_linear': (0.5, 0.05, 1.0),
    'max_angular': (1.0, 0.1, 2.0),
    'tolerance': (0.1, 0.02, 0.5),
    'timeout': (60.0, 1.0, 600.0),
    'status_period': (0.5, 0.1, 10.0),
}
# Names of ROS may not be like these; a station's name is any text.
ODD_NAMES = [
    'gate/7',
    '/lab',
    '~/dock',
    '2nd floor',
    '42',
    "Ann's desk",
    '"here"',
    '{room}',
    '-1',
    'Straße',
    'Cafe\u0301',  # an e and an accent that are two letters
    '東門',
    'up__and_down_',
    1200 * 'a',
    'first line\nsecond line',
    'left\tright',
    'None',
]
MANY = 600  # periods
NAMES = ['kitchen', 'office', 'lab', 'storage', 'gate 7', 'Küche', 'dock', 'x']


class Keeper:
    """The learner's node in a namespace, with what the tests hear and ask."""

    def __init__(self, learner, namespace: str = '', *, strict: bool = True, **parameters):
        """:param strict: whether a status that cannot be heard is a fault here. :param parameters: of the node."""
        self.learner, self.namespace = learner, namespace
        self.heard = learner.listen(f'{namespace}/status', String, strict=strict)
        self.stations = learner.client(f'{namespace}/set_station', SetStation)
        try:
            self.node = learner.start(
                'StationKeeper', remap={'__ns': namespace} if namespace else None, parameters=parameters or None
            )
            learner.settle()
        except WiringError as error:  # `about` would name a rule that has nothing to do with it
            error.rule = 'latched' if error.kind == 'qos' else 'names'
            raise
        name = f'{namespace}/delivery_robot'
        expect(self.node.name == name, f'Your node is called {self.node.name}, expected {name}.', 'names')
        absolute = learner.endpoints('/status').publishers if namespace else []
        expect(
            not absolute,
            f'In the namespace {namespace}, your node publishes on /status, expected '
            f'{namespace}/status. A relative name has no slash at its beginning.',
            'names',
        )

    def set(self, name: str, x: float, y: float, rule: str = 'station'):
        """Call set_station; returns the response."""
        with about(rule):
            return self.stations.call(name=name, x=x, y=y)

    def place(self, name: str, rule: str):
        """What the learner's `place` returns."""
        with about(rule):
            return self.node.call('place', name)


def judge_status(keeper: Keeper, period: float) -> None:
    """The rules `status`, `status-period` and `latched`, right after the start."""
    learner = keeper.learner
    early = learner.late_listener(f'{keeper.namespace}/status', String)
    expect(
        not early.data,
        f'Right after the start {early.data} came on status, expected nothing: only the timer publishes, the first '
        'time one period later.',
        'status-period',
    )
    learner.run(3.05 * period)
    heard = keeper.heard
    if not heard.data:
        learner.run(12.0)  # does it come later?
    expect(
        heard.data, f'With status_period = {period:g}, nothing came on status in {12 + 3.05 * period:.2f} s.', 'status'
    )
    expect(set(heard.data) == {'idle'}, f'These came on status: {heard.data}, expected idle.', 'status')
    wanted = [period * number for number in (1, 2, 3)]
    expect(
        heard.stamps == pytest.approx(wanted, abs=1e-4),
        f'With status_period = {period:g}, messages came at {[round(stamp, 3) for stamp in heard.stamps]} s, '
        f'expected {[round(stamp, 3) for stamp in wanted]}.',
        'status-period',
    )
    state = _judge_one_period(keeper, period)
    with about('latched'):
        late = learner.late_listener(f'{keeper.namespace}/status', String)
    expect(
        late.data == [state],
        f'Who subscribes late gets {late.data} at once, expected the newest status, '
        f'{state!r}, and only that. Use transient local with depth 1.',
        'latched',
    )
    for publisher in learner.endpoints(f'{keeper.namespace}/status').publishers:
        check_lifespan(publisher, 'latched')
    heard.clear()
    begin = learner.now / SECOND
    changed = Parameters(learner, f'{keeper.namespace}/delivery_robot').set(status_period=2.5 * period)
    expect(changed.successful, f'status_period = {2.5 * period:g} was refused: {changed.reason!r}.', 'status-period')
    learner.run(3.05 * period)
    expect(
        len(heard) == 3,
        f'At the start status_period was {period:g}. Then it was set to {2.5 * period:g}, and {len(heard)} messages '
        f'came in {learner.now / SECOND - begin:.2f} s, expected 3: the value at the start counts.',
        'status-period',
    )
    _judge_status_after_long(keeper, period)


def _judge_one_period(keeper: Keeper, period: float) -> str:
    """The rules `status` and `status-period`, from the third message to the fourth; returns the new state.

    Meanwhile all sorts of requests come, and none of them is a reason for a message, or for another rhythm.
    """
    learner, heard = keeper.learner, keeper.heard
    # Of any length, with any letters.
    state = f' Driving to {learner.random.choice(NAMES)}' + learner.random.randint(9, 20) * ' and on' + ' '
    parameters = Parameters(learner, f'{keeper.namespace}/delivery_robot')
    for what, ask in (
        ('A station was refused', lambda: keeper.set('', 1.0, 2.0)),
        ('max_linear = 7 was asked for', lambda: parameters.set(max_linear=7.0)),
        (f'self.state became {state!r}', lambda: keeper.node.call('__setattr__', 'state', state)),
        ('A station was set', lambda: keeper.set('b', 1.0, 2.0)),
        ('place was called', lambda: keeper.place('b', 'status-period')),
        ('max_linear was set', lambda: parameters.set(max_linear=0.3)),
    ):
        ask()
        learner.settle()
        expect(
            len(heard) == 3, f'{what}, and at once a message came on status: only the timer publishes.', 'status-period'
        )
    learner.run(period)
    expect(
        len(heard) == 4,
        f'A station and a parameter were set, and {len(heard) - 3} messages came on status in one period of '
        f'{period:g} s, expected 1: only the timer publishes.',
        'status-period',
    )
    expect(
        heard.stamps[-1] == pytest.approx(4 * period, abs=1e-4),
        f'With status_period = {period:g}, a station and a parameter were set at {3.05 * period:.3f} s. The next '
        f'message came at {heard.stamps[-1]:.3f} s, expected {4 * period:.3f} s: no request changes the rhythm.',
        'status-period',
    )
    expect(
        heard.data[-1] == state,
        f'self.state became {state!r}, a station was set, and {period:g} s later {heard.data[-1]!r} came on '
        'status: publish it as it is then.',
        'status',
    )
    return state


def judge_periods(learner) -> None:
    """The rule `status-period`, with a period that is nearly the shortest, and one that is nearly the longest."""
    draw = learner.random
    for number, (low, high) in enumerate(((0.101, 0.114), (7.0, 9.9)), draw.randint(2, 50)):
        period = round(draw.uniform(low, high), 3) + 0.0004  # no whole number of milliseconds
        with about('status-period'):  # in a namespace that no robot has that was started before
            keeper = Keeper(learner, f'/cart{number}', status_period=period)
        begin = learner.now / SECOND
        learner.run(2.05 * period)
        at = [round(stamp - begin, 5) for stamp in keeper.heard.stamps]
        expect(
            at == pytest.approx([period, 2 * period], abs=5e-5),
            f'Started with status_period = {period:g}, messages came on status after {at} s, expected '
            f'{[round(period, 5), round(2 * period, 5)]}. The period is the value of the parameter, as it is.',
            'status-period',
        )


def _judge_status_after_long(keeper: Keeper, period: float) -> None:
    """The status comes, and is that of the moment, also when the robot has run for long."""
    learner, heard = keeper.learner, keeper.heard
    heard.clear()
    learner.run(MANY * period, step=10 * period)
    expect(
        len(heard) == MANY,
        f'Then {len(heard)} messages came on status in {MANY} periods of {period:g} s, expected {MANY}: it goes on '
        'as long as the robot runs.',
        'status-period',
    )
    state = f'driving to {learner.random.choice(NAMES)} at last'
    keeper.node.call('__setattr__', 'state', state)
    learner.run(period)
    expect(
        heard.data[-1] == state,
        f'More than {MANY} periods after the start self.state became {state!r}, and {period:g} s later '
        f'{heard.data[-1]!r} came on status: publish it as it is then.',
        'status',
    )


def judge_table(learner, namespace: str, parameters: Parameters) -> None:
    """The rules `parameters`, `bounds` and `description`."""
    for name, (default, low, high) in TABLE.items():
        found = parameters.describe(name)
        expect(found, f'There is no parameter {name}.', 'parameters')
        expect(
            found.type == Parameter.Type.DOUBLE.value,
            f'{name} has the type {Parameter.Type(found.type).name}, expected DOUBLE: write 60.0, and not 60.',
            'parameters',
        )
        expect(
            not found.dynamic_typing,
            f'{name} may change its type: leave dynamic_typing out of its descriptor. It is a double.',
            'parameters',
        )
        value = parameters.get(name)
        expect(value == default, f'{name} is {value:g} at the start, expected {default:g}.', 'parameters')
        check_bounds(found, (low, high))
        expect(found.description.strip(), f'{name} has no description.', 'description')
    for name, (_, low, high) in TABLE.items():
        for value in (low - 0.01, high + 0.01, 1.5 * high):
            expect(not parameters.set(**{name: value}).successful, f'{name} = {value:g} was accepted.', 'bounds')
        expect(parameters.set(**{name: high}).successful, f'{name} = {high:g} was refused.', 'bounds')


def judge_start(learner) -> None:
    """The rule `parameters`, for values that are given at the start."""
    given = {name: round(learner.random.uniform(low, high), 3) for name, (_, low, high) in TABLE.items()}
    with about('parameters'):
        Keeper(learner, strict=False, **given)
    parameters = Parameters(learner, '/delivery_robot')
    for name, value in given.items():
        got = parameters.get(name)
        expect(got is not None, f'There is no parameter {name}.', 'parameters')
        expect(
            got == value,
            f'The node was started with {name} = {value:g}, and {name} is {got}. A value from outside takes '
            'the place of the default.',
            'parameters',
        )


def judge_stations(keeper: Keeper) -> None:
    """The rules `station`, `new-place`, `unknown`, `bad-station`, `message` and `unchanged`."""
    names = keeper.learner.random.sample(NAMES, len(NAMES))
    nobody = names.pop()
    names += [f' {names[0]}', f'{names[1]} ', '  ']  # other names than those without blanks
    names += keeper.learner.random.sample(ODD_NAMES, len(ODD_NAMES))
    wanted = _judge_new_stations(keeper, names)
    for name in (nobody, names[0] + 's', names[0].upper(), f' {names[2]} ', '', 'Caf\u00e9', nobody):
        found = keeper.place(name, 'unknown')
        expect(found is None, f'place({name!r}) is {found}, and nobody has set this station: expected None.', 'unknown')
    _judge_bad_stations(keeper, wanted, names[1], nobody)
    other = keeper.learner.start('StationKeeper', beside=keeper.node)
    found = other.call('place', names[1])
    expect(
        found is None,
        f'A second robot in the same program was told nothing, and its place({names[1]!r}) is {found}: '
        'the stations belong to the object, not to the class.',
        'unknown',
    )


def _judge_places(keeper: Keeper, wanted: dict[str, list[float]], what: str, rule: str) -> None:
    """`place` knows all these stations. `what`: what has happened before."""
    for name in wanted:
        _judge_place(keeper, name, wanted[name], what, rule)


def _judge_place(keeper: Keeper, name: str, wanted: list[float], what: str, rule: str) -> None:
    """`place` of this station is the pair that is wanted, a tuple: a list is equal to no tuple."""
    found = keeper.place(name, rule)
    expect(
        isinstance(found, (list, tuple)) and list(found) == wanted,
        f'{what}, place({name!r}) is {found}, expected the tuple {tuple(wanted)}.',
        rule,
    )
    expect(
        type(found) is not list,
        f'place({name!r}) is the list {found}, expected the tuple {tuple(found)}. A tuple stands in round '
        'brackets, or in none.',
        rule,
    )


def _judge_new_stations(keeper: Keeper, names: list[str]) -> dict[str, list[float]]:
    """Set these stations, and the first one again; returns where they are."""
    draw = keeper.learner.random
    wanted: dict[str, list[float]] = {}
    busy = f'driving to {names[0]}'
    # The origin of the map is a place, and two names may have the same one.
    origin, twin = draw.sample(range(1, len(names)), 2)
    for number, name in enumerate(names):
        wanted[name] = [round(draw.uniform(-size, size), 9) for size in (3, 2000)]
        if number == origin:
            wanted[name] = [0.0, 0.0]
        elif number == twin:
            wanted[name] = wanted[names[0]]
        if number == len(names) // 2:
            keeper.node.call('__setattr__', 'state', busy)
        response = keeper.set(name, *wanted[name])
        expect(
            response.success,
            f'{name!r} at {tuple(wanted[name])} was refused: success is false. The message: {response.message!r}.'
            + (' A name is any text that is not empty.' if name in ODD_NAMES else '')
            + (f' (self.state is {busy!r}: a station may be set at any time.)' if number >= len(names) // 2 else ''),
            'station',
        )
        _judge_place(keeper, name, wanted[name], 'After set_station', 'station')
        if len(wanted) in (2, len(names)):
            _judge_places(keeper, wanted, f'After {name!r} was set', 'new-place')
    wanted |= _judge_far_stations(keeper, names[-1])
    wanted[names[0]] = [0.0, draw.randint(-40, 40) / 10]
    expect(
        keeper.set(names[0], *wanted[names[0]], 'new-place').success,
        f'A new place for {names[0]!r} was refused.',
        'new-place',
    )
    _judge_places(keeper, wanted, f'After {names[0]!r} got a new place', 'new-place')
    for name in names[1:]:
        wanted[name] = [round(draw.uniform(-9, 9), 3), round(draw.uniform(-9, 9), 3)]
        expect(
            keeper.set(name, *wanted[name], 'new-place').success, f'A new place for {name!r} was refused.', 'new-place'
        )
    _judge_places(keeper, wanted, 'After all stations got new places, one after the other', 'new-place')
    expect(
        keeper.set(names[0], *wanted[names[0]]).success,
        f'{names[0]!r} was set again, at the place that it has, and refused: success is false.',
        'station',
    )
    return wanted


def _judge_far_stations(keeper: Keeper, name: str) -> dict[str, list[float]]:
    """Set two stations as far away as numbers go, in different directions; returns where they are, by their names."""
    draw, there = keeper.learner.random, {}
    for number, signs in enumerate((draw.sample([1, -1], 2), 2 * [draw.choice([1, -1])]), 2):
        station, far = f'{name} {number}', [sign * draw.uniform(1.2, 1.7) * 1e308 for sign in signs]  # of 1.8e308
        expect(
            keeper.set(station, *far).success,
            f'{station!r} at ({far[0]:g}, {far[1]:g}) was refused. Both are finite numbers: judge each one by itself, '
            'because what is computed from them may be too large.',
            'station',
        )
        there[station] = far
    return there


def _judge_bad_stations(keeper: Keeper, wanted: dict[str, list[float]], known: str, nobody: str) -> None:
    """Stations that are refused, for a name that is `known` and one that nobody has set: `wanted` stays as it is."""
    before = _status(keeper)
    for name, x, y in (
        ('', 1.0, 1.0),
        (known, math.nan, 1.0),
        (known, 1.0, math.nan),
        (known, math.inf, 0.0),
        (known, 0.0, -math.inf),
        (nobody, math.nan, math.nan),
    ):
        response = keeper.set(name, x, y, 'bad-station')
        told = f'The station {name!r} at ({x:g}, {y:g})'
        expect(not response.success, f'{told} was accepted.', 'bad-station')
        expect(response.message.strip(), f'{told} was refused without a message.', 'message')
        _judge_places(keeper, wanted, f'{told} was refused, and now', 'unchanged')
        for other in (one for one in (name,) if one not in wanted):
            expect(
                keeper.place(other, 'unchanged') is None,
                f'{told} was refused, and yet it is a station now.',
                'unchanged',
            )
    after = _status(keeper)
    expect(
        after == before or not (before and after),  # whether it says anything is another rule
        f'Stations were refused, and the status is {after!r} now; before, it was {before!r}.',
        'unchanged',
    )


def _status(keeper: Keeper) -> str:
    """What the node says of itself; '' if it says nothing."""
    keeper.heard.clear()
    keeper.learner.run(1.2)  # longer than the period
    return keeper.heard.data[-1] if keeper.heard.data else ''
