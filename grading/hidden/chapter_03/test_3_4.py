"""Hidden tests of exercise 3.4, a latched map."""

import pytest
from nav_msgs.msg import OccupancyGrid
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Int32

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.4')

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
ALL_KEPT = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
VALUES = {'#': 100, '.': 0, '?': -1}


def random_rows(random):
    """A map with all three kinds of cells that is another one if it is read column by column."""
    width, height = random.sample(range(3, 9), 2)
    while True:
        rows = [''.join(random.choice('#..?') for _ in range(width)) for _ in range(height)]
        cells, by_columns = ''.join(rows), ''.join(row[x] for x in range(width) for row in rows)
        if set(cells) == set(VALUES) and cells != by_columns:
            return rows


def grid_of(rows):
    grid = OccupancyGrid(data=[VALUES[cell] for row in rows for cell in row])
    grid.info.width, grid.info.height = len(rows[0]), len(rows)
    return grid


@pytest.mark.weight(2)
def test_any_map(learner):
    """A map of any size is published row by row, with its size, its resolution and the frame map.

    Width counts the columns. The data is one flat list: the first row first.
    """
    rows = random_rows(learner.random)
    learner.start('MapServer', rows)
    late = learner.late_listener('/map', OccupancyGrid, LATCHED)
    expect(late.messages, 'A subscriber that came after the start got no map.')
    grid = late.messages[0]
    width, height = len(rows[0]), len(rows)
    expect((grid.info.width, grid.info.height) == (width, height),
           f'{height} rows of {width} characters gave the width {grid.info.width} and the height {grid.info.height}.')
    columns_first = [VALUES[row[x]] for x in range(width) for row in rows]
    expect(list(grid.data) != columns_first, 'The data goes column by column; it must go row by row.')
    expect(list(grid.data) == list(grid_of(rows).data), f'The data of {rows} is {list(grid.data)}.')
    expect(grid.header.frame_id == 'map', f'header.frame_id is {grid.header.frame_id!r}, expected "map".')
    expect(grid.info.resolution == pytest.approx(0.1), f'info.resolution is {grid.info.resolution:g}, expected 0.1.')


def test_one_map_only(learner):
    """The map is published once. Latching makes repetition needless.

    No timer: TRANSIENT_LOCAL serves those who come late.
    """
    maps = learner.listen('/map', OccupancyGrid, ALL_KEPT)
    learner.start('MapServer', random_rows(learner.random))
    learner.run(10.1, step=1.0)
    expect(len(maps) < 2, f'{len(maps)} maps came in 10 s, expected 1. Do not repeat in a timer: latch.')
    expect(len(maps) == 1, 'No map came.')
    late = learner.late_listener('/map', OccupancyGrid, ALL_KEPT)
    expect(len(late) == 1, f'A late subscriber gets {len(late)} maps, expected 1.')


def test_publisher_qos(learner):
    """The server's publisher is RELIABLE and TRANSIENT_LOCAL, so that every subscriber fits.

    A QoSProfile takes both as arguments; RELIABLE is the default.
    """
    learner.start('MapServer', ['#.'])
    publishers = learner.endpoints('/map').publishers
    expect(len(publishers) == 1, f'The server has {len(publishers)} publishers on /map, expected 1.')
    expect(publishers[0].latched, 'The publisher of /map is VOLATILE: who comes late gets nothing.')
    expect(publishers[0].reliable, 'The publisher of /map is BEST_EFFORT: a map must not get lost.')


def test_reader_late(learner):
    """A reader that starts after the map counts its walls, and tells it to those who ask even later.

    TRANSIENT_LOCAL on both of its topics.
    """
    rows = random_rows(learner.random)
    walls, other = ''.join(rows).count('#'), ''.join(rows).count('?')
    server = learner.talk('/map', OccupancyGrid, LATCHED)
    server.send(grid_of(rows))
    learner.run(1.0)
    learner.start('MapReader')
    learner.run(30.0, step=10.0)
    late = learner.late_listener('/walls', Int32, LATCHED)
    expect(late.messages, 'The reader said nothing about a map that is older than itself. Ask for TRANSIENT_LOCAL.')
    expect(late.data[-1] != walls + other, 'Unknown cells (-1) were counted as walls.')
    expect(late.data == [walls], f'A map with {walls} walls gave {late.data}.')


def test_reader_every_map(learner):
    """The reader answers every map, and keeps only the newest answer for late joiners.

    Publish in the callback; depth 1 keeps one.
    """
    answers = learner.listen('/walls', Int32, ALL_KEPT)
    server = learner.talk('/map', OccupancyGrid, LATCHED)
    learner.start('MapReader')
    maps = [['#..'], ['###'], ['...', '?#.']]
    for rows in maps:
        server.send(grid_of(rows))
        learner.run(1.0)
    expect(answers.data == [1, 3, 1], f'Three maps with 1, 3 and 1 walls gave the answers {answers.data}.')
    late = learner.late_listener('/walls', Int32, ALL_KEPT)
    expect(len(late) == 1, f'A late listener on /walls gets {len(late)} answers; depth 1 keeps only the newest.')


def test_together(learner):
    """Server and reader work together, in either order of their starts, and in a namespace.

    Both sides use the same QoS and the same relative name.
    """
    rows = random_rows(learner.random)
    answers = learner.listen('/floor2/walls', Int32, LATCHED)
    names = ['MapServer', 'MapReader']
    learner.random.shuffle(names)
    first = None
    for name in names:
        rows_or_nothing = [rows] if name == 'MapServer' else []
        node = learner.start(name, *rows_or_nothing, beside=first, remap={'__ns': '/floor2'})
        wanted = '/floor2/map_server' if name == 'MapServer' else '/floor2/map_reader'
        expect(node.name == wanted, f'A node is called {node.name}, expected {wanted}.')
        learner.run(5.0, step=1.0)
        first = first or node
    learner.wait_until(lambda: answers.data, timeout=3)
    expect(answers.data == [''.join(rows).count('#')],
           f'Server and reader in the namespace /floor2 gave {answers.data} for {rows}. Are the topic names relative?')
