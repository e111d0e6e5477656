"""Visible tests of exercise 3.4, a latched map."""

import pytest
from nav_msgs.msg import OccupancyGrid
from std_msgs.msg import Int32

from helpers.checks.chapter_03.endpoints import check_latched, check_name, check_nothing_else, check_topic, robot
from helpers.checks.chapter_03.maps import (
    ALL_KEPT,
    LATCHED,
    check_answers,
    check_grid,
    check_not_again,
    check_once,
    check_own_answers,
    check_unheard,
    grid_of,
    large_rows,
    one_row,
    random_rows,
)
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.4'), pytest.mark.wiring(type='topics', qos='qos', namespace='topics')]


@pytest.mark.rules('server-node', 'one-map', 'cells', 'order', 'size', 'resolution', 'frame', 'topics', 'qos')
def test_server(learner):
    """A MapServer publishes its map once, in the constructor, and late subscribers still get it.

    Translate character by character, the first row first. TRANSIENT_LOCAL keeps the map in the publisher.
    """
    space = robot(learner.random)
    rows, other = random_rows(learner.random), one_row(learner.random)
    with about('cells'):
        server = learner.start('MapServer', rows, remap={'__ns': space})
    check_name(server, 'map_server', 'server-node')
    check_topic(learner, 'publisher', space, 'map', 'topics')
    check_latched(learner, 'publisher', f'{space}/map', 1, 'qos')
    maps = learner.late_listener(f'{space}/map', OccupancyGrid, ALL_KEPT)
    expect(maps.messages, 'No map came on map when the server was there. Publish it in the constructor.', 'one-map')
    check_grid(maps.messages[0], rows)
    check_once(maps, 0)
    seconds = learner.random.randint(310, 400)
    learner.run(seconds, step=100.0)
    expect(
        len(maps) == 1,
        f'{len(maps)} maps came in {seconds} s, expected one. Nothing needs to be repeated: a latched map is kept.',
        'one-map',
    )
    check_not_again(learner, maps)
    learner.start('MapServer', other, beside=server)
    learner.settle()
    expect(
        len(maps) > 1,
        'A second MapServer, started later in the same program, published no map in its constructor.',
        'one-map',
    )
    check_grid(maps.messages[1], other)
    check_once(maps, 1)
    expect(
        len(maps) == 2,
        f'A second MapServer published {len(maps) - 1} maps in its constructor, expected one.',
        'one-map',
    )
    large = large_rows(learner.random)
    with about('cells'):
        learner.start('MapServer', large, beside=server)
        learner.settle()
    expect(len(maps) == 3, f'A map of {len(large)} rows was published {len(maps) - 2} times, expected once.', 'one-map')
    check_grid(maps.messages[2], large)


@pytest.mark.rules('reader-node', 'late', 'walls', 'topics', 'qos')
def test_reader(learner):
    """A MapReader that starts after the server counts the walls of the map, and of each map after it.

    The subscription must ask for TRANSIENT_LOCAL, too.
    """
    random, space = learner.random, robot(learner.random)
    answers = learner.listen(f'{space}/walls', Int32, ALL_KEPT)
    server = learner.talk(f'{space}/map', OccupancyGrid, LATCHED)
    maps = [random_rows(random)]
    server.send(grid_of(maps[0]))
    learner.run(random.randint(5, 60), step=10.0)
    reader = learner.start('MapReader', remap={'__ns': space})
    check_name(reader, 'map_reader', 'reader-node')
    check_topic(learner, 'subscription', space, 'map', 'topics')
    check_topic(learner, 'publisher', space, 'walls', 'topics')
    there = learner.endpoints(f'{space}/map').subscriptions
    expect(
        there[0].latched,
        'Your subscription to map is VOLATILE: it does not get a map that was published before MapReader started.',
        'late',
    )
    for kind, topic in (('subscription', 'map'), ('publisher', 'walls')):
        check_latched(learner, kind, f'{space}/{topic}', 1, 'qos')
    with about('walls'):
        learner.settle()
    expect(answers.messages, 'MapReader said nothing about a map that was published before it started.', 'late')
    check_answers(answers.data, maps)
    same = list(maps[0])
    random.shuffle(same)  # another map with as many walls
    # One map comes twice: each time it is a map.
    maps += [same, same, ['.?.', '...'], ['#+.', '+?+'], ['*.#', '#?*'], large_rows(random), random_rows(random)]
    stamp = random.randint(900, 9000)  # in seconds; they get older: a map is one like any other
    for number, rows in enumerate(maps[1:], start=2):
        twice = rows == maps[number - 2]
        stamp -= 0 if twice else 60
        frame, resolution = ('map', 0.1) if number < len(maps) - 1 else (f'floor_{random.randint(1, 9)}', 0.05)
        server.send(grid_of(rows, frame, resolution, stamp))
        with about('walls'):
            learner.settle()
        note = (
            ' The last one is equal to the one before.'
            if twice
            else f' The last one has the frame_id {frame!r}, the resolution {resolution:g} and the stamp {stamp} s. '
            'Each one counts, also an old one.'
        )
        check_answers(answers.data, maps[:number], note)
    many = [one_row(random) for _ in range(random.randint(60, 70))]
    for rows in many:
        server.send(grid_of(rows))
        learner.settle()
    check_answers(answers.data, maps + many, ' That many came, one after the other.')
    learner.run(61.0, step=10.0)
    check_answers(answers.data, maps + many)
    check_nothing_else(learner, {f'{space}/walls'}, 'walls')
    check_own_answers(learner, reader, answers, server)
    check_unheard(learner, reader)
