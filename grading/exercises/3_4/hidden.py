"""Hidden tests of exercise 3.4, a latched map."""

import pytest
from nav_msgs.msg import OccupancyGrid
from std_msgs.msg import Int32

from helpers.checks.chapter_03.endpoints import check_latched, check_name, check_nothing_else, check_topic
from helpers.checks.chapter_03.maps import (
    ALL_KEPT,
    LATCHED,
    check_answers,
    check_grid,
    check_not_again,
    check_once,
    check_own_answers,
    grid_of,
    large_rows,
    one_row,
    random_rows,
    walls,
)
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.4'), pytest.mark.wiring(type='topics', qos='qos', namespace='topics')]


@pytest.mark.weight(2)
@pytest.mark.rules('cells', 'order', 'size', 'resolution', 'frame', 'qos')
def test_any_map(learner):
    """A map of any size is published row by row, with its size, its resolution and the frame map.

    Width counts the columns. The data is one flat list: the first row first.
    """
    random = learner.random
    width = random.randint(2, 7)
    line = '#?.' + ''.join(random.choice('#.?') for _ in range(width))
    maps = [random_rows(random), [line], list(line), [random.choice('#.?')], large_rows(random)]
    found = learner.listen('/map', OccupancyGrid, ALL_KEPT)
    first = None
    for number, rows in enumerate(maps, start=1):
        with about('cells'):
            node = learner.start('MapServer', rows, **({'beside': first} if first else {}))
        first = first or node
        if number == 1:
            check_topic(learner, 'publisher', '', 'map', 'topics')
            check_latched(learner, 'publisher', '/map', 1, 'qos')
        learner.settle()
        expect(len(found) >= number, 'A MapServer published no map in its constructor.', 'one-map')
        check_grid(found.messages[-1], rows)


@pytest.mark.rules('one-map')
def test_one_map_only(learner):
    """The map is published once, in the constructor. Latching makes repetition needless.

    No timer: TRANSIENT_LOCAL serves those who come late.
    """
    maps = learner.listen('/map', OccupancyGrid, ALL_KEPT)
    with about('cells'):
        first = learner.start('MapServer', random_rows(learner.random))
    check_topic(learner, 'publisher', '', 'map', 'topics')
    check_latched(learner, 'publisher', '/map', 1, 'qos')
    learner.settle()
    expect(len(maps) == 1, f'{len(maps)} maps came when the server had started, expected 1.', 'one-map')
    check_once(maps, 0)
    learner.run(10.1, step=1.0)
    learner.run(300.0, step=100.0)
    expect(len(maps) == 1, f'{len(maps)} maps came in 310 s, expected 1. Do not repeat in a timer: latch.', 'one-map')
    check_not_again(learner, maps)
    learner.start('MapServer', random_rows(learner.random), beside=first)
    learner.settle()
    expect(len(maps) == 2, f'A second server published {len(maps) - 1} maps when it started, expected 1.', 'one-map')


@pytest.mark.rules('qos', 'late', 'walls')
def test_reader_late(learner):
    """A reader that starts after the map counts its walls, and tells it to those who ask even later.

    TRANSIENT_LOCAL on both of its topics.
    """
    rows = random_rows(learner.random)
    server = learner.talk('/map', OccupancyGrid, LATCHED)
    server.send(grid_of(rows))
    learner.run(1.0)
    learner.start('MapReader')
    check_topic(learner, 'subscription', '', 'map', 'topics')
    check_topic(learner, 'publisher', '', 'walls', 'topics')
    expect(
        learner.endpoints('/map').subscriptions[0].latched,
        'The subscription to map is VOLATILE: it does not get old maps.',
        'late',
    )
    for kind, topic in (('subscription', '/map'), ('publisher', '/walls')):
        check_latched(learner, kind, topic, 1, 'qos')
    with about('walls'):
        learner.run(30.0, step=10.0)
    late = learner.late_listener('/walls', Int32, LATCHED)
    expect(
        late.messages, 'The reader said nothing about a map that is older than itself. Ask for TRANSIENT_LOCAL.', 'late'
    )
    check_answers(late.data, [rows])


@pytest.mark.rules('qos', 'walls')
def test_reader_every_map(learner):
    """The reader answers every map, and keeps only the newest answer for late joiners.

    Publish in the callback; depth 1 keeps one.
    """
    answers = learner.listen('/walls', Int32, ALL_KEPT)
    server = learner.talk('/map', OccupancyGrid, LATCHED)
    reader = learner.start('MapReader')
    check_topic(learner, 'subscription', '', 'map', 'topics')
    check_topic(learner, 'publisher', '', 'walls', 'topics')
    with about('walls'):
        learner.run(2.0)
    expect(not answers.messages, f'The reader said {answers.data} before there was a map.', 'walls')
    maps = [['#..'], ['###'], ['...', '?#.'], ['?'], ['##', '#.'], ['###'], ['+#', '#+', '++'], ['*#', '..', '#*']]
    learner.random.shuffle(maps)
    maps.append(maps[-1])
    maps += [one_row(learner.random) for _ in range(learner.random.randint(45, 60))]
    frames = [learner.random.choice(('map', 'world', '')) for _ in maps[2:]] + ['world', 'map']  # both of them
    for number, (rows, frame) in enumerate(zip(maps, frames, strict=True)):
        # A map is one like any other, however old, and equal ones, too.
        stamp = 9000 - 60 * (number - (rows == maps[number - 1]))
        server.send(grid_of(rows, frame, stamp=stamp))
        with about('walls'):
            learner.run(1.0)
    check_answers(answers.data, maps, ' Some have another frame_id than map, and some are older than those before.')
    learner.run(61.0, step=10.0)
    check_answers(answers.data, maps)
    check_nothing_else(learner, {'/walls'}, 'walls')
    late = learner.late_listener('/walls', Int32, ALL_KEPT)
    expect(len(late) == 1, f'A late listener on /walls gets {len(late)} answers; depth 1 keeps only the newest.', 'qos')
    check_own_answers(learner, reader, answers, server)


@pytest.mark.rules('server-node', 'reader-node', 'topics')
def test_together(learner):
    """Server and reader work together, in either order of their starts, and in a namespace.

    Both sides use the same QoS and the same relative name.
    """
    rows, space = random_rows(learner.random), f'/floor{learner.random.randint(2, 9)}'
    answers = learner.listen(f'{space}/walls', Int32, LATCHED)
    names = ['MapServer', 'MapReader']
    learner.random.shuffle(names)
    first = None
    for name in names:
        with about('cells'):
            node = learner.start(name, *([rows] if name == 'MapServer' else []), beside=first, remap={'__ns': space})
        wanted = ('map_server', 'server-node') if name == 'MapServer' else ('map_reader', 'reader-node')
        check_name(node, *wanted)
        if name == 'MapServer':
            check_topic(learner, 'publisher', space, 'map', 'topics')
            check_latched(learner, 'publisher', f'{space}/map', 1, 'qos')
        else:
            check_topic(learner, 'subscription', space, 'map', 'topics')
            check_topic(learner, 'publisher', space, 'walls', 'topics')
            expect(
                learner.endpoints(f'{space}/map').subscriptions[0].latched,
                'The subscription to map is VOLATILE: it does not get old maps.',
                'late',
            )
        with about('walls'):
            learner.run(5.0, step=1.0)
        first = first or node
    learner.wait_until(lambda: answers.data, timeout=1)
    expect(
        answers.data and answers.data[-1] == walls(rows),
        f'Server and reader in the namespace {space} gave {answers.data} for {rows}.',
        'walls',
    )
