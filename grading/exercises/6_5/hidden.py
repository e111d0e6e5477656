"""Hidden tests of exercise 6.5, follow, but not blindly."""

import math

import pytest

from helpers.checks.chapter_06.frame_comparisons import explain, words
from helpers.checks.chapter_06.pursuit import (
    LONG,
    Pursuit,
    check_first,
    check_limit,
    check_long_silence,
    check_lost_again,
    check_places,
    check_topic,
    zeros,
)
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('6.5'), pytest.mark.wiring(type='topic', qos='topic')]


def pursuit(learner, **options) -> Pursuit:
    """Two turtles with any names, 3.5 to 4.5 m from each other, that look anywhere."""
    draw = learner.random
    leader, me = draw.sample(['alice', 'bob', 'carol', 'dave', 'erin'], 2)
    angle, length = draw.uniform(-3, 3), draw.uniform(3.5, 4.5)
    second = 5.5 + length * math.cos(angle), 5.5 + length * math.sin(angle), draw.uniform(-3, 3)
    there = Pursuit(learner, leader, me, (5.5, 5.5, draw.uniform(-3, 3)), second, **options)
    expect(there.node.name == '/follower', f'Your node is called {there.node.name}, expected /follower.', 'name')
    expect(
        learner.endpoints(f'/{me}/cmd_vel').publishers,
        f'Follower({leader!r}, {me!r}) has no publisher on /{me}/cmd_vel: both names are arguments.',
        'topic',
    )
    return there


def heard(there: Pursuit, count: int, what: str, rule: str) -> None:
    """Fail unless `count` commands have come (one more or less)."""
    goes_on = bool(there.commands) and there.learner.now / 1e9 - there.commands.stamps[-1] < 1.0
    expect(
        abs(len(there.commands) - count) <= 1,
        f'{what}, {len(there.commands)} commands came on '
        f'/{there.names[1]}/cmd_vel, expected {count}: one every 0.1 s, also '
        'when there is nothing to follow.',
        'no-wait' if rule == 'unknown' and goes_on else rule,
    )


@pytest.mark.weight(2)
@pytest.mark.rules('name', 'topic', 'rate', 'place', 'newest')
@about('newest')
def test_command(learner):
    """The command is what chase says for the place of the leader in the frame of the follower.

    The frame in which you want to know the place is the target. Both names are arguments.
    """
    there = pursuit(learner)
    # Ahead and to the right of it, 2 m away: with a look-up of anything else chase says something else.
    ahead = math.atan2(5.5 - there.me.y, 5.5 - there.me.x)
    there.leader.x, there.leader.y = there.me.x + 2.0 * math.cos(ahead), there.me.y + 2.0 * math.sin(ahead)
    there.me.theta = ahead + 0.6
    there.leader.theta = there.me.theta + 2.0
    for _ in range(3):
        there.tell()
        learner.run(0.1)
    heard(there, 3, 'In 0.3 s', 'rate')
    check_first(there)
    check_topic(there)
    command, place = there.commands.messages[-1], there.place()
    told = (
        f'The leader is at {words(place)} in the frame of the follower. The command is linear.x '
        f'{command.linear.x:.2f}, angular.z {command.angular.z:.2f}'
    )

    expect(
        not zeros(command),
        f'{told}: it stands. The transforms are 0.1 s old. If you look up at now(), they are never there in time.',
        'newest',
    )
    back = there.seen_back()
    explain(
        there.is_for(command, *place[:2]),
        f'{told}. chase says something else for this place.',
        (
            there.is_for(command, *back[:2]),
            'That is for where the follower is in the frame of the leader: target and source are swapped.',
        ),
        (
            there.is_for(command, there.leader.x, there.leader.y),
            'That is for where the leader is in the world. The follower does not know where it looks itself.',
        ),
        (
            there.is_for(command, *there.in_space()),
            'That is for the way in space, with z. chase wants x and y, as they are.',
        ),
        rule='place',
    )
    check_places(there)


@pytest.mark.weight(2)
@pytest.mark.rules('place', 'newest', 'old')
@about('place')
def test_follow(learner):
    """The leader drives a bend; the follower stays near it, with transforms that are 0.2 s old when they come.

    The newest transform, Time(), is always a little old. Up to 0.5 s that is good enough.
    """
    there = pursuit(learner)
    there.run(4.0, drive=(0.6, learner.random.choice([-0.6, 0.6])), delay=0.2)
    expect(
        not all(map(zeros, there.commands.messages)),
        'The follower stood all the time. The transforms were 0.2 s old each time they came: that is good enough.',
        'old',
    )
    expect(
        there.distance < 2.2,
        f'The leader drove for 4 s, and the follower is {there.distance:.1f} m away, expected '
        'about 1 to 2 m. The transforms were 0.2 s old each time: that is good enough.',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('unknown', 'no-wait')
@about('unknown')
def test_unknown(learner):
    """Nothing is known, then only one turtle: the commands are zeros, every 0.1 s. Then both are known, and it goes.

    Catch TransformException. Never wait for a transform in a callback: it cannot come while you wait.
    """
    there = pursuit(learner, threads=True)
    learner.run(1.0)
    heard(there, 10, 'No transforms came for 1 s. In this time', 'unknown')
    known, other = learner.random.sample(there.names, 2)
    there.run(1.024, names=[known])
    heard(there, 20, 'Only one of the turtles is known after 2 s. In this time', 'unknown')
    learner.run(0.6)
    there.tell([other])
    learner.run(0.3)
    heard(there, 29, 'Both turtles said where they are, and never at the same time. After 2.9 s', 'unknown')
    there.tell_elsewhere(other)
    there.run(0.512, names=[known])
    heard(there, 34, 'The turtles are in two trees, with no way from one to the other. After 3.4 s', 'unknown')
    learner.run(LONG, step=1.0)
    heard(there, 144, 'The leader or the follower was unknown for 14.4 s. In this time', 'unknown')
    expect(all(map(zeros, there.commands.messages)), 'The leader or the follower was unknown, and a command drives.')
    there.run(0.896)
    expect(not there.stands, 'Both turtles are known now, and the follower stands. Does your node listen?')


@pytest.mark.weight(3)
@pytest.mark.rules('old', 'again', 'unknown')
@about('old')
def test_silence(learner):
    """When the transforms of one of them stop, the follower stands; when they come again, it goes on.

    Time() asks for the newest, however old. Compare its stamp with the clock of the node.
    """
    there = pursuit(learner)
    there.run(0.896)
    expect(not there.stands, 'Both turtles are known, and the follower stands.')
    quiet = learner.random.choice(there.names)
    loud = [name for name in there.names if name != quiet]
    silence = learner.now / 1e9
    there.run(0.256, names=loud)
    expect(not there.stands, 'The transforms are less than 0.5 s old, and the follower stands. That is good enough.')
    there.run(0.512, names=loud)
    who = 'leader' if quiet == there.names[0] else 'follower'
    expect(
        there.stands,
        f'The {who} has said nothing for {learner.now / 1e9 - silence:.1f} s, and the commands still drive. A '
        'look-up with Time() gives the newest transform, however old it is: look at its stamp.',
    )
    count = len(there.commands)
    there.run(0.512, names=loud)
    expect(
        len(there.commands) - count >= 4,
        'While nothing new came, there were no commands. Publish zeros: a robot goes on with its last command.',
    )
    there.run(0.896)
    expect(not there.stands, 'The transforms come again, and the follower still stands.', 'again')
    check_lost_again(there)
    check_long_silence(there)


@pytest.mark.weight(2)
@pytest.mark.rules('old', 'rate')
@about('old')
def test_age(learner):
    """A transform of 0.45 s is good, one of 0.55 s is too old, whichever second they are in, and whoever is late.

    The age is the clock's time less the stamp, with the nanoseconds.
    """
    there = pursuit(learner)
    for _ in range(3):
        there.tell()
        learner.run(0.1)
    for quiet in learner.random.sample(there.names, 2):
        loud = [name for name in there.names if name != quiet]
        learner.run(0.3)
        for _ in range(6):
            there.tell([quiet], learner.now / 1e9 - learner.random.uniform(0.32, 0.38))
            there.tell(loud)
            count, newest = len(there.commands), min(there.stamps.values())
            learner.run(0.2)
            for stamp, command in zip(there.commands.stamps[count:], there.commands.messages[count:], strict=True):
                age = stamp - newest
                told = f'At {stamp:.2f} s, the transform had the stamp {newest:.2f} s, so it was {age:.2f} s old'
                expect(age > 0.49 or not zeros(command), f'{told}, and the command is zeros.')
                expect(age < 0.51 or zeros(command), f'{told}, and the command drives.')
    check_limit(there)
