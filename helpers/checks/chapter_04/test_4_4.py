"""Visible tests of exercise 4.4, find the bugs."""

import itertools

import pytest
from std_srvs.srv import SetBool, Trigger

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.checks.chapter_04.names import check_names
from helpers.runner import about, expect, waiting

pytestmark = [pytest.mark.exercise('4.4'), pytest.mark.wiring(type='open', namespace='names')]

ANSWERS = 'welcome', 'locked', 'full'
NEVER = 'enter was never answered.'


def people(count):
    return f'{count} person' if count == 1 else f'{count} people'


class Room:
    """One guard, his lock and his visitors, one after the other."""

    def __init__(self, learner, capacity):
        self.learner, self.capacity, self.inside = learner, capacity, 0
        self.delay = learner.random.choice([0.2, 0.5])
        words = itertools.cycle(learner.random.sample(['', 'open', 'locked', 'full'], 4))
        # Whatever it says, if anything, enter has words of its own.
        self.opens = lambda request: {'success': True, 'message': next(words)}
        self.lock = learner.serve('/lock', SetBool, self.opens, self.delay)
        learner.start('DoorGuard', capacity)
        self.doors = {name: learner.client(f'/{name}', Trigger) for name in ('enter', 'leave')}

    def enter(self, wanted, rule, story):
        """One person enters; `wanted` is the message, `story` what has happened before."""
        before = len(self.lock.requests)
        call = self.doors['enter'].send()
        with about(rule), waiting('one-thread'):
            self.learner.run(self.delay + 0.3, step=10.0)
        asked = self.lock.requests[before:]
        story = f'Capacity {self.capacity}, {story}: '
        if wanted != 'full':
            expect(asked or call.done, f'{story}enter was called, and the lock was not asked.', 'open')
            expect(len(asked) < 2, f'{story}the lock was asked {len(asked)} times, expected once.', 'open')
            expect(call.done, NEVER, 'one-thread')
        expect(call.done, f'{story}enter was not answered.', rule)
        got = (call.response.success, call.response.message)
        expect(
            got == (wanted == 'welcome', wanted),
            f'{story}enter gives {got}, expected {(wanted == "welcome", wanted)}.',
            rule,
        )
        if wanted == 'full':
            expect(not asked, f'{story}the lock was asked although the room is full.', rule)
            expect(
                call.received == call.sent,
                f'{story}enter was answered {call.received - call.sent:g} s later: if '
                'the room is full, answer at once.',
                rule,
            )
        else:
            expect(
                [request.data for request in asked] == [False],
                f'{story}the lock got requests with data = {[request.data for request in asked]}, expected one '
                'with False, which means open.',
                'open',
            )
            expect(
                call.received - call.sent == pytest.approx(self.delay),
                f'{story}the lock answers after {self.delay} s, enter after {call.received - call.sent:g} s.',
                rule,
            )

    def enter_slowly(self):
        """From the full room one leaves; the next one waits long for the lock, which opens all the same."""
        self.leave('one leaves')
        quick, self.delay = self.delay, self.learner.random.choice([62.6, 91.4])
        self.lock.delay = self.delay
        story = f'{people(self.capacity - 1)} inside, the lock answers after {self.delay} s'
        self.enter('welcome', 'welcome', story)
        self.delay = self.lock.delay = quick

    def leave(self, story):
        """One person leaves."""
        before = len(self.lock.requests)
        with about('leave'):
            answer = self.doors['leave'].call()
            self.learner.settle()
        expect(answer.success, f'Capacity {self.capacity}, {story}: leave gives success=False.', 'leave')
        expect(
            len(self.lock.requests) == before,
            f'Capacity {self.capacity}, {story}: leave has asked the lock. Only enter asks it.',
            'leave',
        )

    def leave_meanwhile(self):
        """From the full room two leave; then one comes, and another one leaves while the lock is slow."""
        for _ in range(2):
            self.leave('two leave')
        enter = self.doors['enter'].send()
        self.learner.run(self.delay / 2, step=1.0)
        leave = self.doors['leave'].send()
        self.learner.run(self.delay + 0.3, step=1.0)
        expect(enter.done and leave.done, f'{people(1)} came, one left meanwhile, and not both were answered.', 'leave')
        story = 'inside, after one came in and another one left while the lock was slow'
        for number in range(self.capacity - 2, self.capacity):
            self.enter('welcome', 'leave', f'{people(number)} {story}')
        self.enter('full', 'leave', f'{people(self.capacity)} {story}')


@pytest.mark.rules('full', 'open', 'welcome', 'locked', 'leave', 'one-thread')
@about('welcome')
@waiting('one-thread')
def test_one_after_the_other(learner):
    """Each one gets the answer that is right: welcome, full or locked.

    Who never gets an answer: the guard, or the client of the lock? When does somebody count as inside?
    """
    capacity = learner.random.choice([3, 4])  # not the usual 2; and somebody is inside while the lock refuses
    room = Room(learner, capacity)
    for number in range(capacity):
        room.enter('welcome', 'welcome', f'{people(number)} inside')
    for _ in range(2):
        room.enter('full', 'full', f'{people(capacity)} inside')
    room.lock.answer = {'success': False, 'message': learner.random.choice(['', 'jammed', 'welcome'])}
    room.enter('full', 'full', f'{people(capacity)} inside')
    room.leave('one leaves')
    for number in range(capacity + 10):
        room.enter(
            'locked',
            'locked',
            f'{people(capacity - 1)} inside, the lock refuses, and has refused {number} times before',
        )
    room.lock.answer = room.opens
    room.enter(
        'welcome', 'locked', f'{people(capacity - 1)} inside, and some whom the lock refused, who have not come in'
    )
    room.enter('full', 'locked', f'{people(capacity)} inside, and the lock has refused some before')
    for _ in range(capacity + 2):
        room.leave('all leave, and leave is called twice more')
    for number in range(capacity):
        room.enter('welcome', 'leave', f'after more calls of leave than people were inside, {people(number)} inside')
    room.enter(
        'full',
        'leave',
        f'after more calls of leave than people were inside, {people(capacity)} came in. An empty room stays at 0',
    )
    room.enter_slowly()
    room.leave_meanwhile()


@pytest.mark.given
@pytest.mark.rules('full')
@about('full')
@waiting('one-thread')
def test_no_place(learner):
    """A room of capacity 0 is full although nobody is inside.

    0 is a number like any other: `capacity or 2` is 2.
    """
    Room(learner, 0).enter('full', 'full', 'nobody inside')


@pytest.mark.rules('welcome', 'full')
@about('welcome')
@waiting('one-thread')
def test_many_places(learner):
    """As many people come in as there are places, also if these are many.

    The number of places is the argument of the constructor.
    """
    room = Room(learner, learner.random.randint(44, 60))
    for number in range(room.capacity):
        room.enter('welcome', 'welcome', f'{people(number)} inside')
    room.enter('full', 'full', f'{people(room.capacity)} inside')


@pytest.mark.rules('names', 'open', 'capacity', 'full')
@about('welcome')
@waiting('capacity')
def test_all_at_once(learner):
    """In a namespace all names move with the guard; of many who come at the same time, no more than 2 get in.

    Between the look at self.inside and its change there is an await: no second enter may run there.
    """
    draw = learner.random
    space, visitors, delay = draw.choice(['/room_1', '/room_2', '/house/hall']), draw.randint(4, 6), 1.0
    node = learner.start('DoorGuard', remap={'__ns': space})
    expect(
        node.name == f'{space}/door_guard',
        f'In the namespace {space} your node is called {node.name}, expected {space}/door_guard.',
        'names',
    )
    lock = learner.serve(f'{space}/lock', SetBool, {'success': True}, delay)
    enter, leave = (learner.client(f'{space}/{name}', Trigger) for name in ('enter', 'leave'))
    learner.settle()
    check_names(learner, space, enter, leave, lock)
    check_default(learner, lock, enter, leave)
    lock.answer, before = iter([{'success': False}] + [{'success': True}] * visitors), len(lock.stamps)
    calls = [enter.send() for _ in range(visitors)]
    learner.run(visitors * delay + 1.0, step=1.0)
    _judge_visitors(calls, lock, before)
    check_second_guard(learner, node, lock, enter)
    check_other_room(learner, node, lock, enter)
    check_own_lock(learner, node, lock, enter, leave)


def _judge_visitors(calls, lock, before):
    """What people were told who came at the same time; `before`: so many requests the lock had had."""
    words = [call.response.message if call.done else 'no answer' for call in calls]
    story = (
        f'{len(calls)} people called enter at the same time, with the capacity 2, and the lock refused the first; '
        f'they were told {words}. '
    )
    others = [word for word in words if word not in (*ANSWERS, 'no answer')]
    expect(not others, f'{story}{others and others[0]!r} is none of the answers: {", ".join(ANSWERS)}.', 'welcome')
    together = any(later - earlier < lock.delay / 2 for earlier, later in itertools.pairwise(lock.stamps[before:]))
    expect(
        words.count('welcome') <= 2 or together,
        f'{story}They waited for one another, as they must, so the count is wrong: who is told welcome is one person '
        'more, and who is refused changes nothing.',
        'capacity',
    )
    expect(
        words.count('welcome') <= 2,
        f'{story}While one enter awaits the lock, the next one looks at the same '
        'count: enter must stay in a mutually exclusive group.',
        'capacity',
    )
    expect(
        words.count('welcome') == 2,
        f'{story}Somebody was told that the room is full when nobody was inside, or '
        'one: count who has come in, after the answer of the lock.',
        'open',
    )
    expect(
        sorted(words) == sorted(['locked', 'welcome', 'welcome'] + ['full'] * (len(calls) - 3)),
        f'{story}Expected locked, two times welcome, then full.',
        'capacity',
    )
    expect(
        len(lock.requests) == 3,
        f'{story}The lock was asked {len(lock.requests)} times, expected 3: somebody was told that the room is full '
        'after the lock had been asked to open for him.',
        'full',
    )


def check_default(learner, lock, enter, leave):
    """A guard made without an argument has two places for people who come one after the other; then all leave."""
    words = []
    for _ in range(4):
        call = enter.send()
        with about('one-thread'):
            learner.run(lock.delay + 0.3, step=1.0)
        expect(call.done, NEVER, 'one-thread')
        words.append(call.response.message)
    places = words.count('welcome')
    expect(
        words != ['welcome'] * places + ['full'] * (4 - places) or places == 2,
        f'DoorGuard() was made without an argument. Of 4 people, who came one after the other, {places} came in, '
        'expected 2: without an argument `capacity` is 2.',
        'capacity',
    )
    for _ in range(places):
        leave.send()
        learner.run(0.1)
    lock.requests.clear()


def check_second_guard(learner, node, lock, enter, inside=2):
    """The first guard's room is full; a second guard of a larger one begins with an empty room, and only he asks.

    Both hear the same call, so the requests to the lock tell who let somebody in.
    """
    larger, lock.answer = inside + learner.random.choice([1, 2, 3]), {'success': True}
    learner.start('DoorGuard', larger, beside=node)
    before = len(lock.requests)
    for _ in range(larger + 1):
        enter.send()
        learner.run(lock.delay + 0.5, step=1.0)
    asked = len(lock.requests) - before
    expect(
        asked == larger,
        f"The first guard's room is full: {inside} of {inside}. A second DoorGuard, in the same program, begins with "
        f'an empty room for {larger} people. {larger + 1} people called enter at both, one after the other, and the '
        f'lock was asked {asked} times, expected {larger} times, by the second guard. Each guard counts for itself, '
        'and has a capacity of its own: in attributes of the object (self.inside), not of the class.',
        'full',
    )


def check_other_room(learner, node, lock, enter):
    """A guard's full room stays full when a guard of another, empty room is made in the same program.

    The two guards of `check_second_guard` hear the same calls: two who share one count may ask as often as is right.
    """
    space, free = '/annex', learner.random.randint(3, 5)
    other = learner.serve(f'{space}/lock', SetBool, {'success': True})
    learner.start('DoorGuard', free, beside=node, remap={'__ns': space})
    visitor = learner.client(f'{space}/enter', Trigger)
    learner.settle()
    visitor.send()
    learner.run(0.5)
    before = len(lock.requests)
    enter.send()
    learner.run(lock.delay + 0.5, step=1.0)
    asked = len(other.requests), len(lock.requests) - before
    expect(
        asked == (1, 0),
        f'The room of the first guard is full. Another DoorGuard, in the same program and the namespace {space}, '
        f'begins with an empty room for {free} people. One person called enter at the empty room, and its lock was '
        f'asked {asked[0]} times, expected once; then one called enter at the full room, and its lock was asked '
        f'{asked[1]} times, expected 0. Each guard counts for itself: in attributes of the object (self.inside), not '
        'of the class.',
        'full',
    )


def check_own_lock(learner, node, lock, enter, leave):
    """A guard asks the lock of his own room when another one has been made in another namespace."""
    other = learner.serve(f'{OTHER}/lock', SetBool, {'success': True})
    learner.start('DoorGuard', beside=node, remap={'__ns': OTHER})
    learner.settle()
    leave.send()  # one place is free
    learner.run(0.3)
    lock.requests.clear()
    enter.send()
    learner.run(lock.delay + 0.5, step=1.0)
    story = 'Somebody called enter at the first one'
    check_own('DoorGuard', story, len(lock.requests), len(other.requests), 'lock', 'client', 'names')
