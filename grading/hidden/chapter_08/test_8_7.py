"""Hidden tests of exercise 8.7, parameters, status and stations."""

import math

import pytest
from delivery_interfaces.srv import SetStation
from rclpy.parameter import Parameter
from std_msgs.msg import String

from helpers.checks.chapter_08.parameters import Parameters
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.7')
TABLE = {'max_linear': (0.5, 0.05, 1.0), 'max_angular': (1.0, 0.1, 2.0), 'tolerance': (0.1, 0.02, 0.5),
         'timeout': (60.0, 1.0, 600.0), 'status_period': (0.5, 0.1, 10.0)}


@pytest.mark.weight(3)
def test_parameters(learner):
    """Each of the five parameters has its default, its bounds and a description.

    declare_parameter(name, default, bounded(description, low, high)).
    """
    learner.start('StationKeeper')
    parameters = Parameters(learner, '/delivery_robot')
    for name, (default, low, high) in TABLE.items():
        found = parameters.describe(name)
        expect(found, f'There is no parameter {name}.')
        expect(found.type == Parameter.Type.DOUBLE.value, f'{name} has the type {Parameter.Type(found.type).name}, '
                                                          'expected DOUBLE: write 60.0, and not 60.')
        value = parameters.get(name)
        expect(value == default, f'{name} is {value:g} at the start, expected {default:g}.')
        ranges = [(one.from_value, one.to_value) for one in found.floating_point_range]
        expect(ranges == [(low, high)], f'The descriptor of {name} has the bounds {ranges}, expected {[(low, high)]}.')
        expect(found.description.strip(), f'{name} has no description.')


@pytest.mark.weight(2)
def test_status(learner):
    """The status comes every status_period seconds, and who comes late gets the newest one at once.

    The period of the timer is the parameter's value; DurabilityPolicy.TRANSIENT_LOCAL, depth 1.
    """
    period = learner.random.choice([0.2, 0.3, 0.7])
    heard = learner.listen('/status', String)
    learner.start('StationKeeper', parameters={'status_period': period})
    learner.run(4.05 * period)
    expect(len(heard) == 4, f'With a status_period of {period} s, {len(heard)} messages came in {4.05 * period:.2f} s, '
                            'expected 4.')
    late = learner.late_listener('/status', String)
    expect(late.data == ['idle'], f'Who subscribes late gets {late.data} at once, expected the newest status, idle. '
                                  'That is what transient local is for, with depth 1.')


def test_relative_names(learner):
    """In a namespace, status and set_station are in it.

    Names without a slash at their beginning.
    """
    namespace = f'/robot{learner.random.randint(2, 99)}'
    heard = learner.listen(f'{namespace}/status', String)
    client = learner.client(f'{namespace}/set_station', SetStation)
    learner.start('StationKeeper', remap={'__ns': namespace})
    learner.run(0.6)
    expect(len(heard), f'In the namespace {namespace}, nothing came on {namespace}/status.')
    expect(client.call(name='a', x=1.0, y=2.0).success, f'{namespace}/set_station refused a at (1, 2).')


@pytest.mark.weight(2)
def test_stations(learner):
    """Several stations are kept; a known name gets its new place; an unknown one is None.

    A dictionary: name → (x, y).
    """
    client, draw = learner.client('/set_station', SetStation), learner.random
    node = learner.start('StationKeeper')
    names = draw.sample(['kitchen', 'office', 'lab', 'storage', 'gate 7', 'Küche'], 3)
    wanted = {}
    for name in [*names, names[0]]:
        wanted[name] = [draw.randint(-40, 40) / 10, draw.randint(-40, 40) / 10]
        response = client.call(name=name, x=wanted[name][0], y=wanted[name][1])
        expect(response.success, f'{name!r} at {wanted[name]} was refused. success must be set to True.')
    for name in names:
        found = node.call('place', name)
        expect(found is not None and list(found) == wanted[name],
               f'place({name!r}) is {found}, expected {tuple(wanted[name])}.')
    expect(node.call('place', 'moon') is None, "place('moon') is not None, and nobody has set this station.")


@pytest.mark.weight(2)
def test_refused(learner):
    """An empty name, and places that are no finite numbers, are refused, with a message; nothing changes.

    First look, then note.
    """
    client = learner.client('/set_station', SetStation)
    node = learner.start('StationKeeper')
    client.call(name='dock', x=1.0, y=2.0)
    for name, x, y in (('', 1.0, 1.0), ('dock', math.nan, 1.0), ('dock', 1.0, math.nan), ('dock', math.inf, 0.0),
                       ('dock', 0.0, -math.inf)):
        response = client.call(name=name, x=x, y=y)
        expect(not response.success, f'The station {name!r} at ({x:g}, {y:g}) was accepted.')
        expect(response.message, f'The station {name!r} at ({x:g}, {y:g}) was refused without a message.')
    found = node.call('place', 'dock')
    expect(found is not None and list(found) == [1.0, 2.0],
           f"Requests for dock were refused, and now place('dock') is {found}, expected (1.0, 2.0) as before.")
    expect(node.call('place', '') is None, 'The empty name was refused, and yet it is a station now.')
