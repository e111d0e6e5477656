"""Maps as rows of characters, and as grids: for exercise 3.4."""

import pytest
from nav_msgs.msg import OccupancyGrid
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Int32

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.runner import about, expect

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
ALL_KEPT = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
LARGE = 200  # cells: a map of so many is not printed
VALUES = {'#': 100, '.': 0, '?': -1}
# In the maps of other servers: probably a wall, and a number that other programs give a meaning of their own
OTHERS = {**VALUES, '+': 99, '*': 120}


def random_rows(random) -> list[str]:
    """A map with all three kinds of cells, in different numbers, that is another one in any other order."""
    width, height = random.sample(range(3, 9), 2)
    while True:
        rows = [''.join(random.choice('#..?') for _ in range(width)) for _ in range(height)]
        cells = ''.join(rows)
        if (
            len({cells.count(kind) for kind in VALUES}) == 3
            and all(cells.count(kind) > 1 for kind in VALUES)
            and all(cells != ''.join(other) for other in orders(rows).values())
        ):
            return rows


def one_row(random) -> list[str]:
    """A map of a single row."""
    return [''.join(random.choice('#..?') for _ in range(random.randint(5, 12)))]


def orders(rows: list[str]) -> dict[str, list[str]]:
    """The map in wrong orders, by what is wrong."""
    return {
        'column by column; it must go row by row': [row[x] for x in range(len(rows[0])) for row in rows],
        'from the last row to the first; it must begin with the first': rows[::-1],
        'from right to left in each row': [row[::-1] for row in rows],
    }


def values(rows: list[str]) -> list[int]:
    """The cells, row by row."""
    return [OTHERS[cell] for row in rows for cell in row]


def walls(rows: list[str]) -> int:
    """How many walls there are."""
    return ''.join(rows).count('#')


def large_rows(random) -> list[str]:
    """A map with more rows and columns than one would write by hand, as maps of real rooms have."""
    width, height = random.randint(105, 140), random.randint(55, 65)
    return [''.join(random.choice('##.?') for _ in range(width)) for _ in range(height)]


def grid_of(rows: list[str], frame: str = 'map', resolution: float = 0.1, stamp: int = 0) -> OccupancyGrid:
    """The map as a server publishes it; `stamp` in seconds."""
    grid = OccupancyGrid(data=values(rows))
    grid.header.frame_id, grid.header.stamp.sec = frame, stamp
    grid.info.width, grid.info.height, grid.info.resolution = len(rows[0]), len(rows), resolution
    return grid


def check_not_again(learner, maps) -> None:
    """The one map that has come is not published again for another subscriber: a latched map reaches it, too."""
    learner.late_listener(maps.topic, OccupancyGrid, ALL_KEPT)
    learner.run(11.0, step=10.0)
    expect(
        len(maps) == 1,
        f'When another subscriber had come, the map was published again: {len(maps)} maps came, expected one. '
        'TRANSIENT_LOCAL gives the map to those who come late, without another publication.',
        'one-map',
    )


def check_once(maps, index: int) -> None:
    """The map with this index is the first that its publisher has sent: a late listener does not hear the others."""
    number = maps.numbers[index]
    expect(number == 1, f'A MapServer published {number} maps in its constructor, expected one.', 'one-map')


def check_grid(grid: OccupancyGrid, rows: list[str]) -> None:
    """`grid` is the map of `rows`."""
    width, height = len(rows[0]), len(rows)
    shown = rows if width * height < LARGE else f'a map of {height} rows and {width} columns'
    size = grid.info.width, grid.info.height
    expect(
        width == height or size != (height, width),
        f'For {shown}: width and height are exchanged. The width counts the columns.',
        'size',
    )
    expect(
        size == (width, height),
        f'For {shown} the map is {size[0]} wide and {size[1]} high, expected {width} and {height}.',
        'size',
    )
    expect(
        grid.info.resolution == pytest.approx(0.1),
        f'info.resolution is {grid.info.resolution:g}, expected 0.1.',
        'resolution',
    )
    expect(grid.header.frame_id == 'map', f"header.frame_id is {grid.header.frame_id!r}, expected 'map'.", 'frame')
    data, wanted = list(grid.data), values(rows)
    for what, other in orders(rows).items():
        expect(data == wanted or data != values(other), f'For {shown}: the data goes {what}.', 'order')
    expect(len(data) == len(wanted), f'For {shown} data has {len(data)} values, expected {len(wanted)}.', 'cells')
    for place, (got, right) in enumerate(zip(data, wanted, strict=True)):
        expect(
            got == right,
            f'For {shown}: the cell {"".join(rows)[place]!r} in row {place // width}, column '
            f'{place % width} (counted from 0) is {got} in data, expected {right}.',
            'cells',
        )


def check_answers(answers: list[int], sent: list[list[str]], note: str = '') -> None:
    """The reader's answers to these maps. `note`: what is said of a map that has none."""
    for rows, answer in zip(sent, answers, strict=False):
        cells = ''.join(rows)
        expect(
            answer == walls(rows) or len(cells) < LARGE,
            f'MapReader says {answer} for a map of {len(rows)} rows and {len(rows[0])} columns, in which {walls(rows)} '
            'cells are 100.',
            'walls',
        )
        expect(
            answer != walls(rows) + cells.count('?') or not cells.count('?'),
            f'MapReader counts {answer} walls in {rows}: unknown (-1) is no wall.',
            'walls',
        )
        for kind in '+*':
            expect(
                answer == walls(rows) or answer != walls(rows) + cells.count(kind),
                f'MapReader counts {answer} walls in a map in which {walls(rows)} cells are 100 and '
                f'{cells.count(kind)} are {OTHERS[kind]}: only 100 is a wall.',
                'walls',
            )
        expect(answer == walls(rows), f'MapReader says {answer} for {rows}, expected {walls(rows)}.', 'walls')
    expect(
        len(answers) == len(sent), f'{len(sent)} maps gave {len(answers)} answers; each map gets one.{note}', 'walls'
    )


def check_own_answers(learner, reader, answers, server) -> None:
    """A reader answers on its own topic, of which `answers` are, when another one is made in another namespace."""
    others = learner.listen(f'{OTHER}/walls', Int32, ALL_KEPT)
    with about('walls'):
        learner.start('MapReader', beside=reader, remap={'__ns': OTHER})
        learner.settle()
        for recorded in (answers, others):
            recorded.clear()
        server.send(grid_of(one_row(learner.random)))
        learner.settle()
    check_own('MapReader', 'A map came to the first one', len(answers), len(others), 'walls', 'publisher', 'walls')


def check_unheard(learner, reader) -> None:
    """What a reader has counted while nobody listened reaches who listens later. `reader`: another one."""
    space, rows = '/unheard', random_rows(learner.random)
    learner.talk(f'{space}/map', OccupancyGrid, LATCHED).send(grid_of(rows))
    with about('walls'):
        learner.start('MapReader', beside=reader, remap={'__ns': space})
        learner.settle()
    late = learner.late_listener(f'{space}/walls', Int32, LATCHED)
    expect(
        late.data == [walls(rows)],
        f'A map of {walls(rows)} walls came while nobody listened on walls; who listens later gets {late.data}. '
        'Publish for each map, also if nobody listens: TRANSIENT_LOCAL keeps the answer.',
        'walls',
    )
