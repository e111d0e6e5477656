"""Visible tests of exercise 3.4, a latched map."""

import pytest
from nav_msgs.msg import OccupancyGrid
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Int32

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.4')

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def test_map(learner):
    """MapServer(['#..', '.?#']) publishes the data [100, 0, 0, 0, -1, 100], 3 columns wide and 2 rows high.

    Translate character by character, the first row first.
    """
    maps = learner.listen('/map', OccupancyGrid, LATCHED)
    learner.start('MapServer', ['#..', '.?#'])
    learner.settle()
    expect(maps.messages, 'No map came on /map. Publish it in the constructor.')
    grid = maps.messages[0]
    expect((grid.info.width, grid.info.height) != (2, 3), 'Width and height are exchanged: width counts the columns.')
    expect((grid.info.width, grid.info.height) == (3, 2),
           f'The map is {grid.info.width} wide and {grid.info.height} high, expected 3 and 2.')
    expect(list(grid.data) == [100, 0, 0, 0, -1, 100], f'data is {list(grid.data)}, expected [100, 0, 0, 0, -1, 100].')


def test_late_joiner(learner):
    """A subscriber that starts a minute later still gets the map.

    Durability TRANSIENT_LOCAL keeps it in the publisher.
    """
    learner.start('MapServer', ['#..', '.?#'])
    learner.run(60.0, step=10.0)
    late = learner.late_listener('/map', OccupancyGrid, LATCHED)
    expect(len(late) == 1, f'A late subscriber got {len(late)} maps, expected 1. Which durability keeps old messages?')


def test_reader(learner):
    """A MapReader that starts after the server counts the walls of the map.

    The subscription must ask for TRANSIENT_LOCAL, too.
    """
    answers = learner.listen('/walls', Int32, LATCHED)
    server = learner.talk('/map', OccupancyGrid, LATCHED)
    grid = OccupancyGrid(data=[100, 0, 0, 0, -1, 100])
    grid.info.width, grid.info.height = 3, 2
    server.send(grid)
    learner.run(1.0)
    learner.start('MapReader')
    learner.run(1.0)
    expect(answers.messages, 'MapReader said nothing about a map that was published before it started. '
                             'A volatile subscription does not get old messages.')
    expect(answers.data != [3], 'MapReader counts 3 walls in [100, 0, 0, 0, -1, 100]: unknown (-1) is no wall.')
    expect(answers.data == [2], f'MapReader says {answers.data} for [100, 0, 0, 0, -1, 100], expected [2].')
