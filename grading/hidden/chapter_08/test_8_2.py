"""Hidden tests of exercise 8.2, a governor."""

import pytest
from geometry_msgs.msg import Twist
from rclpy.parameter import Parameter

from helpers.checks.chapter_08.parameters import Parameters
from helpers.checks.chapter_08.test_8_2 import command
from helpers.runner import expect
from helpers.runner.verdicts import LearnerCrashed

pytestmark = pytest.mark.exercise('8.2')


def governed(learner, namespace='', **start):
    heard = learner.listen(f'{namespace}/cmd_vel', Twist)
    talker = learner.talk(f'{namespace}/cmd_vel_in', Twist)
    learner.start('Governor', **start)
    return heard, talker


def newest(learner, heard, seconds=0.1):
    """linear.x of the newest message after some time."""
    heard.clear()
    learner.run(seconds)
    expect(heard.messages, f'Nothing came on {heard.topic} in {seconds:g} s.')
    return heard.messages[-1].linear.x


@pytest.mark.weight(2)
def test_limit(learner):
    """linear.x is limited in both directions; smaller speeds and angular.z pass; the other fields are 0.

    max(-limit, min(limit, speed)), and a new Twist with two fields.
    """
    heard, talker = governed(learner)
    learner.run(0.1)
    expect(heard.messages == [Twist()], 'Before the first command, zeros are expected, once in 0.1 s.')
    draw = learner.random
    small, large, turn = draw.randint(1, 49) / 100, draw.randint(60, 300) / 100, draw.randint(-300, 300) / 100
    for speed, wanted in ((small, small), (large, 0.5), (-small, -small), (-large, -0.5)):
        message = command(speed, turn)
        message.linear.y = message.angular.x = 0.7
        talker.send(message)
        got = newest(learner, heard)
        expect(got == wanted, f'linear.x {speed:g} came out as {got:g}, expected {wanted:g}.')
        expect(heard.messages[-1] == command(wanted, turn),
               f'With linear.x {speed:g} and angular.z {turn:g} this came out: {heard.messages[-1]}. Only these two '
               'fields are passed on.')


def test_rhythm(learner):
    """The timer decides when a message goes out; of several commands the newest one counts.

    Note the command in the callback of the subscription, and publish in the timer.
    """
    heard, talker = governed(learner)
    learner.run(0.25)
    heard.clear()
    talker.send(command(0.1), command(0.3))
    learner.settle()
    expect(not heard.messages, 'A message went out at once when a command came. The timer publishes, rate times a '
                               'second.')
    learner.run(0.5)
    expect(heard.stamps == pytest.approx([0.3, 0.4, 0.5, 0.6, 0.7]), f'Messages came at {heard.stamps} s, expected '
                                                                     'every 0.1 s.')
    speeds = {message.linear.x for message in heard.messages}
    expect(speeds == {0.3}, f'After the commands 0.1 and 0.3 these came out: {sorted(speeds)}. The newest one counts, '
                            'until the next one comes.')


@pytest.mark.weight(2)
def test_changes_act_at_once(learner):
    """A new limit and a new mode hold from the next message on.

    Read the parameters in the timer, and not once in the constructor.
    """
    heard, talker = governed(learner)
    parameters = Parameters(learner)
    talker.send(command(1.9, 0.5))
    limit, slow = learner.random.randint(60, 180) / 100, learner.random.randint(5, 45) / 100
    for values, wanted in (({'max_linear': limit}, limit), ({'mode': 'slow'}, 0.2), ({'slow_linear': slow}, slow),
                           ({'mode': 'stop'}, 0.0), ({'mode': 'normal'}, limit)):
        expect(parameters.set(**values).successful, f'{values} was refused.')
        got = newest(learner, heard)
        expect(got == wanted, f'After {values} was set, linear.x is {got:g}, expected {wanted:g}. The value that is '
                              'set must be the one that is used.')
        if values == {'mode': 'stop'}:
            expect(heard.messages[-1] == Twist(), 'In the mode stop it still turns: angular.z is not 0.')


def test_descriptors(learner):
    """Each parameter has its type, its default, its bounds and a description.

    declare_parameter(name, default, ParameterDescriptor(description=…, floating_point_range=[…])).
    """
    learner.start('Governor')
    parameters = Parameters(learner)
    for name, default, bounds in (('max_linear', 0.5, (0.0, 2.0)), ('slow_linear', 0.2, (0.0, 2.0)),
                                  ('rate', 10.0, (1.0, 50.0)), ('mode', 'normal', None)):
        found = parameters.describe(name)
        expect(found, f'There is no parameter {name}.')
        wanted = Parameter(name, value=default).type_
        expect(found.type == wanted.value, f'{name} has the type {Parameter.Type(found.type).name}, expected '
                                           f'{wanted.name}. The default sets the type: write 10.0, and not 10.')
        value = parameters.get(name)
        expect(value == default, f'{name} is {value!r} at the start, expected {default!r}.')
        expect(found.description.strip(), f'{name} has no description.')
        if bounds:
            ranges = [(one.from_value, one.to_value) for one in found.floating_point_range]
            expect(ranges == [bounds], f'The descriptor of {name} has the bounds {ranges}, expected {[bounds]}.')


def test_out_of_bounds(learner):
    """A value out of bounds, or of another type, is refused, and the old one stays. The bounds themselves are good.

    Bounds in the descriptor do this without any code.
    """
    learner.start('Governor')
    parameters, draw = Parameters(learner), learner.random
    for name, value in (('max_linear', draw.randint(201, 900) / 100), ('slow_linear', -draw.randint(1, 90) / 100),
                        ('rate', 0.5), ('rate', 51.0), ('rate', 20), ('mode', 1)):
        before = parameters.get(name)
        expect(not parameters.set(**{name: value}).successful, f'{name} = {value!r} was accepted.')
        expect(parameters.get(name) == before, f'{name} = {value!r} was refused, and yet the parameter has changed.')
    for name, value in (('max_linear', 2.0), ('slow_linear', 0.0), ('rate', 50.0), ('rate', 1.0)):
        expect(parameters.set(**{name: value}).successful, f'{name} = {value!r} was refused.')


@pytest.mark.weight(2)
def test_rule(learner):
    """No request makes slow_linear larger than max_linear, and every other one is accepted.

    Judge the values as they would be after the request: those of the request, and the present ones for the rest.
    """
    learner.start('Governor')
    parameters, draw = Parameters(learner), learner.random
    low, high = draw.randint(5, 15) / 100, draw.randint(60, 190) / 100
    for values, good in (({'slow_linear': high}, False), ({'max_linear': low}, False),
                         ({'max_linear': high, 'slow_linear': high}, True), ({'max_linear': 0.3}, False),
                         ({'slow_linear': low / 2, 'max_linear': low}, True), ({'slow_linear': high}, False),
                         ({'max_linear': low, 'slow_linear': high}, False), ({'slow_linear': low}, True)):
        now = {name: parameters.get(name) for name in ('max_linear', 'slow_linear')}
        answer = parameters.set(**values)
        expect(answer.successful == good, f'With {now}, the request {values} was '
                                          f'{"refused" if good else "accepted"}. Judge the values as they would be.')
        if not good:
            expect('slow_linear' in answer.reason or 'max_linear' in answer.reason,
                   f'The reason {answer.reason!r} names no parameter.')
            kept = {name: parameters.get(name) for name in now}
            expect(kept == now, f'The request {values} was refused, and yet there is now {kept}.')


@pytest.mark.weight(2)
def test_refused_has_no_effect(learner):
    """A request of which one value is refused changes nothing, neither the parameters nor what the node does.

    While checking, change nothing. Others may still refuse.
    """
    heard, talker = governed(learner)
    parameters = Parameters(learner)
    talker.send(command(1.9))
    expect(newest(learner, heard) == 0.5, 'linear.x 1.9 is not limited to 0.5.')
    for values in ({'max_linear': learner.random.randint(60, 180) / 100, 'mode': 'fast'}, {'mode': 'turbo'},
                   {'rate': 20.0, 'mode': 'Slow'}, {'mode': 'slow', 'slow_linear': 1.5}):
        answer = parameters.set(**values)
        expect(not answer.successful, f'The request {values} was accepted.')
        heard.clear()
        learner.run(0.5)
        expect({message.linear.x for message in heard.messages} == {0.5} and len(heard) == 5,
               f'The request {values} was refused, and yet the node works in another way since then: do not store a '
               'value while you check.')


def test_new_rate(learner):
    """A new rate acts at once: the next message comes one new period after the change.

    Make a new timer when the rate has been set.
    """
    heard, _ = governed(learner)
    parameters, rate = Parameters(learner), learner.random.choice([20.0, 40.0, 25.0])
    learner.run(0.25)
    expect(parameters.set(rate=rate).successful, f'rate = {rate:g} was refused.')
    heard.clear()
    learner.run(0.4)
    wanted = [0.25 + n / rate for n in range(1, int(0.4 * rate + 0.5) + 1)]
    expect(len(heard) <= len(wanted), f'At a rate of {rate:g}, {len(heard)} messages came in 0.4 s: does the old timer '
                                      'still run?')
    expect(heard.stamps == pytest.approx(wanted, abs=1e-6),
           f'The rate became {rate:g} at 0.25 s. Messages came at {[round(s, 4) for s in heard.stamps]} s, expected '
           f'at {[round(s, 4) for s in wanted]} s.')


@pytest.mark.weight(2)
def test_values_at_the_start(learner):
    """Values from the command line or a file are checked, too: with a bad one the node does not start.

    Add the callback that checks before you declare the parameters.
    """
    draw = learner.random
    limit = draw.randint(90, 190) / 100
    start = {'max_linear': limit, 'slow_linear': 0.8, 'mode': 'slow', 'rate': 20.0}
    heard, talker = governed(learner, parameters=start)
    talker.send(command(3.0))
    expect(newest(learner, heard) == 0.8, f'Started with max_linear {limit:g}, slow_linear 0.8 and the mode slow, '
                                          f'linear.x is {heard.messages[-1].linear.x:g}, expected 0.8.')
    expect(len(heard) == 2, f'Started with the rate 20, {len(heard)} messages came in 0.1 s, expected 2.')
    for values in ({'mode': 'fast'}, {'slow_linear': 0.6}, {'max_linear': 0.1}):
        try:
            learner.start('Governor', parameters=values)
        except LearnerCrashed:
            continue
        expect(False, f'The node starts with {values}. When the parameters are declared, nothing checks them: is the '
                      'callback added before?')


def test_two_robots(learner):
    """Two governors in two namespaces do not disturb each other.

    Relative names, and state in the object.
    """
    first, one = governed(learner, '/robot1', remap={'__ns': '/robot1'})
    second, two = governed(learner, '/robot2', remap={'__ns': '/robot2'})
    expect(Parameters(learner, '/robot1/governor').set(mode='stop').successful, 'The mode stop was refused.')
    one.send(command(0.3))
    two.send(command(-0.4))
    learner.run(0.2)
    expect(first.messages and second.messages, 'A governor in a namespace does not publish on cmd_vel there.')
    got = first.messages[-1].linear.x, second.messages[-1].linear.x
    expect(got == (0.0, -0.4), f'Two governors give {got}, expected 0 from the one that is stopped, and -0.4.')
