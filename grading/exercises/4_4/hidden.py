"""Hidden tests of exercise 4.4, find the bugs."""

import pytest
from std_srvs.srv import SetBool, Trigger

from helpers.checks.chapter_04.test_4_4 import (
    Room,
    check_default,
    check_other_room,
    check_own_lock,
    check_second_guard,
    people,
)
from helpers.runner import about, expect, waiting

pytestmark = [pytest.mark.exercise('4.4'), pytest.mark.wiring(type='open', namespace='names')]

NEVER = 'enter was never answered.'


def guard(learner, answer, *args, delay=0.0, namespace=''):
    lock = learner.serve(f'{namespace}/lock', SetBool, answer, delay)
    node = learner.start('DoorGuard', *args, remap={'__ns': namespace} if namespace else None)
    return lock, learner.client(f'{namespace}/enter', Trigger), learner.client(f'{namespace}/leave', Trigger), node


def told(call):
    expect(call.done, NEVER, 'one-thread')
    return call.response.success, call.response.message


@pytest.mark.weight(2)
@pytest.mark.rules('open', 'welcome', 'one-thread')
@about('welcome')
@waiting('one-thread')
def test_slow_lock(learner):
    """The lock is asked to open, and enter is answered when it has.

    The lock's client needs a callback group of its own, because enter awaits.
    """
    delay = learner.random.choice([62.7, 84.1])
    lock, enter, _, _ = guard(learner, {'success': True}, delay=delay)
    learner.run(0.4)
    call = enter.send()
    learner.run(delay + 1.0, step=10.0)
    expect(told(call) == (True, 'welcome'), f'The lock opened, and enter says {told(call)}.', 'welcome')
    expect(
        call.received == pytest.approx(0.4 + delay),
        f'The lock opened after {delay} s, enter was answered after {call.received - 0.4:g} s.',
        'welcome',
    )
    expect(
        [request.data for request in lock.requests] == [False],
        f'data=False means open; the lock was asked {[request.data for request in lock.requests]}.',
        'open',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('locked', 'one-thread', 'open')
@about('locked')
def test_jammed_lock(learner):
    """If the lock refuses, enter answers with locked, and nobody has come in.

    Return the response on every path, and count only after the lock has opened.
    """
    lock, enter, _, _ = guard(learner, {'success': False})
    for number in range(1, learner.random.randint(15, 19)):
        call = enter.send()
        learner.run(0.2)
        expect(
            told(call) != (False, 'full'),
            'The lock refused some times; then the guard says that the room is full, but '
            'nobody is in it: count only who has come in.',
            'locked',
        )
        expect(
            told(call) == (False, 'locked'),
            f"The lock refused, and enter says {told(call)}, expected (False, 'locked').",
            'locked',
        )
        expect(
            len(lock.requests) == number,
            f'enter was called {number} times, and the lock was asked {len(lock.requests)} times: ask it each time, '
            'also if it has refused before.',
            'open',
        )
    lock.answer = {'success': True}
    results = []
    for _ in range(3):
        call = enter.send()
        learner.run(0.2)
        results.append(told(call)[1])
    expect(
        results == ['welcome', 'welcome', 'full'],
        f'After the lock was repaired, three people were told {results}, expected welcome, welcome, full.',
        'locked',
    )


@pytest.mark.weight(3)
@pytest.mark.rules('capacity', 'full', 'one-thread')
@about('welcome')
@waiting('one-thread')
def test_all_at_once(learner):
    """However many call enter at the same time, no more than capacity get in.

    Between the look at self.inside and its change there is an await: no second enter may run there.
    """
    capacity, people = learner.random.choice([(1, 3), (2, 4), (3, 5)])
    lock, enter, _, _ = guard(learner, {'success': True}, capacity, delay=1.0)
    calls = [enter.send() for _ in range(people)]
    learner.run(people + 2.0)
    words = [told(call)[1] for call in calls]
    expect(
        words.count('welcome') <= capacity,
        f'{people} people called enter at the same time; {words.count("welcome")} of them got in, with the capacity '
        f'{capacity}. While one enter awaits the lock, the next one looks at the same count: enter must stay in a '
        'mutually exclusive group.',
        'capacity',
    )
    expect(
        sorted(words) == ['full'] * (people - capacity) + ['welcome'] * capacity,
        f'{people} people at the same time, capacity {capacity}: they were told {words}.',
        'capacity',
    )
    expect(
        len(lock.requests) == capacity,
        f'{people} people, capacity {capacity}: the lock was asked '
        f'{len(lock.requests)} times. If it is full, do not ask.',
        'full',
    )


@pytest.mark.rules('open', 'one-thread')
@about('welcome')
@waiting('one-thread')
def test_some_refused_at_once(learner):
    """A place that the lock refused goes to the next one who waits.

    Count after the answer, and let one enter end before the next one looks.
    """
    lock, enter, _, _ = guard(learner, iter([{'success': False}, {'success': True}, {'success': True}]), 1, delay=0.5)
    calls = [enter.send() for _ in range(3)]
    learner.run(4.0)
    words = [told(call)[1] for call in calls]
    expect(
        sorted(words) == ['full', 'locked', 'welcome'],
        f'Three at the same time, capacity 1, the lock refuses the first: they were told {words}, expected locked, '
        'welcome, full.',
        'open',
    )


@pytest.mark.rules('leave', 'one-thread', 'full')
@about('welcome')
@waiting('one-thread')
def test_leaving(learner):
    """Who leaves makes room; an empty room stays empty.

    The count never goes below 0.
    """
    lock, enter, leave, _ = guard(learner, {'success': True}, 1)

    def one_by_one(*clients):
        words = []
        for client in clients:
            call = client.send()
            learner.run(0.1)
            words.append(told(call)[0])
        return words

    words = one_by_one(enter, enter)
    expect(words == [True, False], f'enter and enter with the capacity 1 gave {words}.', 'full')
    words = one_by_one(leave, enter, leave, leave, enter, enter)
    expect(
        words == [True, True, True, True, True, False],
        f'One is inside; leave, enter, leave, leave, enter, enter with the capacity 1 gave {words}.',
        'leave',
    )
    expect(
        len(lock.requests) == 3,
        f'Three people came in, three times somebody left, and the lock was asked {len(lock.requests)} times, '
        'expected 3: only enter asks it.',
        'leave',
    )


@pytest.mark.given
@pytest.mark.rules('full')
@about('full')
@waiting('one-thread')
def test_no_place(learner):
    """A room of capacity 0 is full although nobody is inside.

    0 is a number like any other.
    """
    room = Room(learner, 0)
    for _ in range(2):
        room.enter('full', 'full', 'nobody inside')


@pytest.mark.rules('names', 'one-thread')
@about('welcome')
@waiting('one-thread')
def test_two_rooms(learner):
    """Each of two guards opens the lock of its own room.

    A relative name has no leading slash.
    """
    rooms = [guard(learner, {'success': True}, namespace=f'/room_{number}') for number in (1, 2)]
    expect(
        rooms[1][3].name == '/room_2/door_guard',
        f'Your node is called {rooms[1][3].name}, expected /room_2/door_guard.',
        'names',
    )
    call = rooms[1][1].send()
    learner.run(0.3)
    counts = [len(room[0].requests) for room in rooms]
    expect(
        counts == [0, 1],
        f'The guard of room 2 was asked; the locks of the rooms 1 and 2 got {counts} requests. A '
        'relative name has no leading slash.',
        'names',
    )
    expect(told(call) == (True, 'welcome'), f'enter in room 2 says {told(call)}.', 'names')
    leave = rooms[1][2]
    expect(leave.name in leave.theirs(), f'There is no service {leave.name}: no leading slash in its name.', 'names')
    lock, enter, leave, node = rooms[1]
    check_own_lock(learner, node, lock, enter, leave)


@pytest.mark.rules('capacity', 'one-thread')
@about('welcome')
@waiting('one-thread')
def test_without_an_argument(learner):
    """A guard that is made without an argument has a room for two."""
    lock, enter, leave, _ = guard(learner, {'success': True}, delay=0.2)
    check_default(learner, lock, enter, leave)


@pytest.mark.rules('full', 'welcome')
@about('welcome')
@waiting('one-thread')
def test_a_guard_counts_for_itself(learner):
    """Two guards in one program do not share their count.

    Keep the count in the object, not in the class.
    """
    lock, enter, _, first = guard(learner, {'success': True}, 1)
    call = enter.send()
    learner.run(0.3)
    expect(told(call) == (True, 'welcome'), f'The lock opened, and enter says {told(call)}.', 'welcome')
    check_second_guard(learner, first, lock, enter, 1)
    check_other_room(learner, first, lock, enter)


@pytest.mark.rules('welcome', 'leave')
@about('welcome')
@waiting('one-thread')
def test_all_day(learner):
    """Many people come and go, one after the other, and each of them finds a place.

    What a guard knows of the day is how many are inside now.
    """
    room = Room(learner, learner.random.randint(1, 3))
    visits = learner.random.randint(45, 60)
    for number in range(visits):
        room.enter('welcome', 'leave', f'nobody inside, {people(number)} came and left before')
        room.leave('the only one leaves')


@pytest.mark.rules('leave', 'locked')
@about('leave')
@waiting('one-thread')
def test_leave_meanwhile(learner):
    """Somebody leaves while the lock is slow, or has just refused: then there is one place more, and no other change.

    Between an await and the next line others may change self.inside: do not write back an older number.
    """
    capacity = learner.random.choice([3, 5])
    room = Room(learner, capacity)
    for number in range(capacity - 1):
        room.enter('welcome', 'welcome', f'{people(number)} inside')
    room.lock.answer = {'success': False}
    for _ in range(2):
        room.enter('locked', 'locked', f'{people(capacity - 1)} inside')
    room.lock.answer = room.opens
    room.enter('welcome', 'locked', f'{people(capacity - 1)} inside, and the lock has refused twice')
    room.enter('full', 'locked', f'{people(capacity)} inside, and the lock has refused twice before')
    room.leave_meanwhile()
