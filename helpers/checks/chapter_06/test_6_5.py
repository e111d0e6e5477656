"""Visible tests of exercise 6.5, follow, but not blindly."""

import math

import pytest

from helpers.checks.chapter_06.frame_comparisons import explain, words
from helpers.checks.chapter_06.pursuit import (
    LONG,
    NEAR,
    Pursuit,
    check_first,
    check_gaps,
    check_limit,
    check_long_silence,
    check_lost_again,
    check_places,
    check_topic,
    gaps,
    zeros,
)
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('6.5'), pytest.mark.wiring(type='topic', qos='topic')]
LEADER = 5.5, 5.5  # m, where it is at first
GOOD = 'Up to 0.5 s a transform is good enough.'


@pytest.mark.rules('name', 'topic', 'rate', 'place', 'newest', 'unknown', 'old', 'no-wait', 'again')
@about('unknown')
def test_life(learner):
    """Two turtles become known, move, fall silent, and come again; transforms are some tenths of a second old.

    Every 0.1 s: look up the leader in the frame `me`, look at the stamp, publish what chase says.
    """
    draw = learner.random
    leader, me = draw.sample(['anna', 'ben', 'chris', 'dora', 'emil'], 2)
    there = Pursuit(learner, leader, me, (*LEADER, draw.uniform(2, 3)), (2.0, draw.uniform(2, 4), -0.4), threads=True)
    expect(there.node.name == '/follower', f'Your node is called {there.node.name}, expected /follower.', 'name')
    check_topic(there)
    learner.run(0.7)  # so that what comes before the check of the ages is within one second of the clock
    known, other = draw.sample(there.names, 2)
    there.tell([known])
    learner.run(0.6)
    learner.run(LONG, step=1.0)
    there.tell([other])  # there is no time of which both are known
    learner.run(0.2)
    _tell_two_trees(there, known, other)
    unknown = len(there.commands)
    with about('rate'):
        before = _check_command(there)
    _check_unknown(there, unknown)
    _check_place(there, before)
    _check_silence(there)
    for quiet in draw.sample(there.names, 2):
        _check_age(there, quiet)
    check_places(there)
    check_lost_again(there)
    check_limit(there)


def _tell_two_trees(there, known, other):
    """One turtle is known in `world`, the other one in `map`, and nobody says where `map` is."""
    there.tell_elsewhere(other)
    with about('unknown'):
        there.learner.run(0.6)  # so also half a second ago they were not both known in one tree
        there.tell([known])
        there.learner.run(0.3)


def _check_command(there):
    """Both are known: commands come every 0.1 s. In the end the leader moves; returns where it was before."""
    there.tell()
    there.learner.run(0.1)
    begin = len(there.commands)
    for _ in range(4):
        there.tell()
        there.learner.run(0.1)
    before = there.place()
    turn = there.me.theta - 0.6  # to the right; before it was to the left
    there.leader.x, there.leader.y = there.me.x + 2.2 * math.cos(turn), there.me.y + 2.2 * math.sin(turn)
    there.tell()
    there.learner.run(0.1)
    count, apart = len(there.commands) - begin, gaps(there, begin)
    expect(count, f'Both turtles said where they are for 0.5 s, and no command came on /{there.names[1]}/cmd_vel.')
    expect(
        abs(count - 5) <= 1 and all(gap == pytest.approx(0.1, abs=NEAR) for gap in apart),
        f'Both turtles said where they are every 0.1 s, for 0.5 s. {count} command{"s" * (count > 1)} came'
        f'{", with these seconds between them: " * bool(apart)}{", ".join(f"{gap:.2f}" for gap in apart)}; '
        'expected one every 0.1 s.',
    )
    return before


def _check_unknown(there, count):
    """The first `count` commands came before both were known."""
    expect(
        count,
        'For more than 13 s the place of one turtle or of both was unknown, and no command came. Then, too, publish a '
        'Twist of zeros every 0.1 s, and do not wait for a transform.',
    )
    drives = [command for command in there.commands.messages[:count] if not zeros(command)]
    in_the_world = drives and there.is_for(drives[0], *LEADER)
    expect(
        not drives,
        'The place of one turtle or of both was unknown, and a command drives.'
        + (' It is for where the leader is in the world.' if in_the_world else ''),
    )
    pauses = [there.commands.stamps[0] - there.begin, *gaps(there, 0, count + 1)]
    check_first(there)
    longest, few = max(pauses), sum(pause > 0.1 + NEAR for pause in pauses) == 1
    expect(
        longest < 1.0 or not few,
        f'The place of one turtle or of both was unknown for more than 13 s, and in the end {longest:.1f} s passed '
        'without a command. Publish zeros every 0.1 s, however long it takes.',
        'unknown',
    )
    expect(
        longest < 0.1 + NEAR,
        f'While tf2 did not know the transform, {longest:.2f} s passed without a command. '
        'Does your look-up have a timeout? It must not wait.',
        'no-wait',
    )
    shortest = min(gaps(there, 0, count), default=0.1)
    expect(
        shortest > 0.1 - NEAR,
        f'While tf2 did not know the transform, two commands came {shortest:.2f} s one after the other; expected one '
        'every 0.1 s.',
        'rate',
    )


def _check_place(there, before):
    """The last command is for the place that came last."""
    command, place, back = there.commands.messages[-1], there.place(), there.seen_back()
    told = (
        f'The leader is at {words(place)} in the frame `{there.names[1]}`. The command is linear.x '
        f'{command.linear.x:.2f}, angular.z {command.angular.z:.2f}'
    )
    expect(
        not zeros(command),
        f'{told}: it stands. The transforms are 0.1 s old. For the time now() there is never '
        'a transform yet, and for an earlier time there may be none: ask for the newest, by the names that Follower '
        'got. Its age is the time of the clock of the node minus the whole stamp, with its nanoseconds, and '
        'a small age is good.',
        'newest',
    )
    expect(
        not there.is_for(command, *before[:2]),
        f'{told}: this is for where the leader was 0.2 s ago. Ask for the newest transform.',
        'newest',
    )
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


def _check_silence(there):
    """Both say nothing for 0.8 s: zeros. They come again: the follower goes on."""
    count = len(there.commands)
    there.learner.run(0.8)
    expect(
        len(there.commands) - count >= 7,
        f'Both turtles said nothing for 0.8 s, and in this time only {len(there.commands) - count} commands came. '
        'Publish zeros: a robot goes on with its last command.',
        'old',
    )
    expect(
        there.stands,
        'Both turtles have said nothing for 0.8 s, and the commands still drive. A look-up with '
        'Time() gives the newest transform, however old it is: look at its stamp.',
        'old',
    )
    check_gaps(there, count, 'Both turtles said nothing for 0.8 s')
    check_long_silence(there)
    count = len(there.commands)
    for _ in range(3):
        there.tell()
        there.learner.run(0.1)
    check_gaps(there, count, 'Transforms came again after 0.8 s of silence')
    expect(not there.stands, 'Transforms come again after 0.8 s of silence, and the follower still stands.', 'again')


def _check_age(there, quiet):
    """The transforms of one turtle are 0.4 to 0.6 s old; those of the other one are new."""
    loud = [name for name in there.names if name != quiet]
    there.learner.run(0.3)
    for _ in range(5):
        there.tell([quiet], there.learner.now / 1e9 - there.learner.random.uniform(0.32, 0.38))
        there.tell(loud)
        count, newest = len(there.commands), min(there.stamps.values())
        there.learner.run(0.2)
        for stamp, command in zip(there.commands.stamps[count:], there.commands.messages[count:], strict=True):
            age = stamp - newest
            who = 'leader' if quiet == there.names[0] else 'follower'
            told = (
                f'At {stamp:.2f} s, the transform of the {who} had the stamp {newest:.2f} s, so it was {age:.2f} s old'
            )
            expect(
                age > 0.49 or not zeros(command),
                f'{told}, and the command is zeros. {GOOD} Ask for the newest one, whatever its time; in its age count '
                'the nanoseconds, too.',
                'old',
            )
            expect(
                age < 0.51 or zeros(command),
                f'{told}, and the command drives. {GOOD} The age is counted from its stamp, not from when it came, '
                'with the nanoseconds.',
                'old',
            )
