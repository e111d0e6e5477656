"""Visible tests of exercise 8.7, parameters, status and stations."""

import pytest
from delivery_interfaces.srv import SetStation
from std_msgs.msg import String

from helpers.checks.chapter_08.parameters import Parameters
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.7')


def test_status(learner):
    """The status is idle, twice a second.

    A timer with the period status_period publishes self.state.
    """
    heard = learner.listen('/status', String)
    node = learner.start('StationKeeper')
    expect(node.name == '/delivery_robot', f'Your node is called {node.name}, expected /delivery_robot.')
    learner.run(2.1)
    expect(heard.data == ['idle'] * 4, f'In 2.1 s these came on /status: {heard.data}, expected idle four times.')


def test_station(learner):
    """A station is noted, and place() gives it.

    self.stations[request.name] = request.x, request.y; and response.success.
    """
    client = learner.client('/set_station', SetStation)
    node = learner.start('StationKeeper')
    response = client.call(name='kitchen', x=-2.0, y=2.0)
    expect(response.success, f'kitchen at (-2, 2) was refused: {response.message!r}.')
    found = node.call('place', 'kitchen')
    expect(found is not None and list(found) == [-2.0, 2.0], f"place('kitchen') is {found}, expected (-2.0, 2.0).")


def test_parameter(learner):
    """max_linear is 0.5, and 7.0 is refused.

    declare_parameter(name, default, bounded(description, low, high)).
    """
    learner.start('StationKeeper')
    parameters = Parameters(learner, '/delivery_robot')
    value = parameters.get('max_linear')
    expect(value == 0.5, f'max_linear is {value!r} at the start, expected 0.5.')
    expect(not parameters.set(max_linear=7.0).successful, 'max_linear 7.0 was accepted.')
