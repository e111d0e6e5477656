"""Visible tests of exercise 4.3, one question, two sources."""

import itertools

import pytest
from std_srvs.srv import Trigger

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.checks.chapter_04.names import check_names
from helpers.runner import about, expect, waiting

pytestmark = [pytest.mark.exercise('4.3'), pytest.mark.wiring(type='same-time', namespace='names')]

WORDS = ('low', 'full', 'warm', 'old', 'new', 'cold', 'dirty')


@pytest.mark.rules('same-time', 'success', 'message', 'one-thread', 'fresh', 'names')
@about('message')
@waiting('one-thread')
def test_status(learner):
    """Each call asks both parts at the same time, and puts their answers together.

    An async callback may await an answer, if the client has a callback group of its own. Send both requests first.
    """
    draw = learner.random
    battery, lidar = (learner.serve(f'/{part}/check', Trigger, None) for part in ('battery', 'lidar'))
    status = learner.client('/status', Trigger)
    learner.start('StatusPanel')
    cases = list(itertools.product((True, False), repeat=2))
    draw.shuffle(cases)
    cases.sort(key=lambda good: good != (False, True))  # first one who may think that a second question is needless
    texts = [_texts(draw) for _ in range(2)]
    for number, good in enumerate(cases, 1):
        said = [mine[number - 1] for mine in texts]
        slow, quick = draw.choice([0.6, 0.9]), draw.choice([0.2, 0.4])
        battery.delay, lidar.delay = (slow, quick) if number % 2 else (quick, slow)
        battery.answer, lidar.answer = ({'success': ok, 'message': text} for ok, text in zip(good, said, strict=True))
        words = (
            f'The battery answers after {battery.delay} s with {good[0]}, {_part(said[0])}, the lidar after '
            f'{lidar.delay} s with {good[1]}, {_part(said[1])}. '
        )
        begin = learner.now / 1e9
        call = status.send()
        learner.run(slow + 0.1, step=1.0)  # the next call comes soon: an answer that is kept is none
        if not call.done:
            learner.run(2.0, step=1.0)
        _look_at_questions(call, begin, battery, lidar, number, words)
        _look_at_status(call, begin, slow, good, said, words)
    calls = 4 + draw.randint(7, 11)
    for number in range(5, calls):
        _call_again(learner, status, (battery, lidar), number)
    _wait_long(learner, status, (battery, lidar), calls)
    expect(len(battery.requests) == calls, 'The battery was asked although nobody had called status.', 'fresh')


def _call_again(learner, status, parts, number):
    """One call more, of many: each is like the first one."""
    draw = learner.random
    said, good = [f'{draw.randint(1, 99)} %' for _ in parts], draw.choices((True, False), k=2)
    for part, delay, text, ok in zip(parts, draw.sample([0.1, 0.3], 2), said, good, strict=True):
        part.delay, part.answer = delay, {'success': ok, 'message': text}
    begin = learner.now / 1e9
    call = status.send()
    learner.run(0.4, step=1.0)
    words = f'status was called {number - 1} times before. '
    _look_at_questions(call, begin, *parts, number, words)
    _look_at_status(call, begin, 0.3, good, said, words)


def _wait_long(learner, status, parts, number):
    """The last call, the one with this number: each part answers in the end, after more than a minute."""
    draw, said = learner.random, [f'{learner.random.randint(1, 99)} %' for _ in parts]
    slow = draw.choice([75.6, 93.4])
    for part, delay, text in zip(parts, draw.sample([slow, 61.4], 2), said, strict=True):
        part.delay, part.answer = delay, {'success': True, 'message': text}
    words = (
        f'The battery answers after {parts[0].delay} s with {said[0]!r}, the lidar after {parts[1].delay} s with '
        f'{said[1]!r}. '
    )
    begin = learner.now / 1e9
    call = status.send()
    learner.run(slow + 0.5, step=10.0)
    _look_at_questions(call, begin, *parts, number, words)
    wanted = f'battery: {said[0]}; lidar: {said[1]}'
    expect(
        call.response.message == wanted or call.received - begin > slow - 0.1,
        f'{words}{call.received - begin:g} s after the call the status said {call.response.message!r}, expected '
        f'{wanted!r} after {slow} s. Both always answer: wait for them.',
        'message',
    )
    _look_at_status(call, begin, slow, (True, True), said, words)


def _texts(draw) -> list[str]:
    """What a part says, one time after the other: whatever it is, it is handed on as it is."""
    many = ' Many  words, \n' + f'{draw.randint(1, 9)} or more, ' * draw.randint(20, 40)
    first, *others = draw.sample([f'{draw.randint(1, 99)} %', 'no Signal; 3 °C, für 東', many], 3)
    others.append('')
    draw.shuffle(others)
    return [first, *others]


def _part(text: str, other: str = '') -> str:
    """A text in quotes; of a long one, the part where it begins to differ from the other."""
    if len(text) <= 80:
        return repr(text)
    same = next((at for at, (one, two) in enumerate(zip(text, other, strict=False)) if one != two), len(other))
    begin = max(0, min(same, len(text)) - 20)
    end = begin + 50
    return f'{"…" * (begin > 0)}{text[begin:end]!r}{"…" * (end < len(text))} ({len(text)} letters)'


def _look_at_questions(call, begin, battery, lidar, number, words):
    """Both parts were asked once for this call, the one with this number, at once."""
    expect(
        call.done or battery.requests or lidar.requests,
        'status was called; neither battery/check nor lidar/check was asked.',
        'same-time',
        hint=True,
    )
    parts = ('battery', battery), ('lidar', lidar)
    for part, server in parts:
        others = sorted(set(server.theirs()) - {battery.name, lidar.name})
        expect(
            server.name in server.theirs() or not others,
            f'Your node has a client for {others and others[0]}, and none for {part}/check. Is the name written as on '
            'the card, letter by letter?',
            'names',
        )
    expect(call.done, f'{words}status was never answered.', 'one-thread')
    for part, server in parts:
        count = len(server.requests)
        expect(
            count == number,
            f'After {number} call{"s" * (number > 1)} of status {part}/check was asked {count} '
            f'time{"s" * (count != 1)}, expected {number}.',
            'fresh' if count else 'same-time',
        )
    asked = [round(server.stamps[-1] - begin, 3) for server in (battery, lidar)]
    expect(
        asked == [0.0, 0.0],
        f'{words}They were asked {asked[0]} and {asked[1]} s after the call. Ask both at '
        'the same time: first two call_async, then two await.',
        'same-time',
    )


def _look_at_status(call, begin, slow, good, said, words):
    """The status came with the slower answer, and is put together from `good` and `said`: both of each part."""
    expect(
        call.received - begin == pytest.approx(slow),
        f'{words}The status came after {call.received - begin:g} s, expected {slow} s.',
        'same-time',
    )
    wanted = f'battery: {said[0]}; lidar: {said[1]}'
    expect(
        call.response.message == wanted,
        f'{words}The message of the status is {_part(call.response.message, wanted)}, expected '
        f'{_part(wanted, call.response.message)}.',
        'message',
    )
    expect(
        call.response.success is all(good),
        f'{words}success of the status is {call.response.success}, expected {all(good)}.',
        'success',
    )


@pytest.mark.rules('names', 'callers')
@about('callers')
def test_two_callers(learner):
    """In a namespace all names move with the node; callers at the same time get an answer each.

    Relative names. What belongs to one call stays in local variables.
    """
    draw = learner.random
    space = draw.choice(['/robot_3', '/north/panel'])
    node = learner.start('StatusPanel', remap={'__ns': space})
    expect(
        node.name == f'{space}/status_panel',
        f'In the namespace {space} your node is called {node.name}, expected {space}/status_panel.',
        'names',
    )
    parts = [learner.serve(f'{space}/{part}/check', Trigger, None) for part in ('battery', 'lidar')]
    clients = [learner.client(f'{space}/status', Trigger) for _ in range(3)]
    learner.settle()
    check_names(learner, space, clients[0], *parts)
    delays = [(0.3, 0.2), (0.2, 0.3)]  # each of the parts is the first one to answer
    draw.shuffle(delays)
    for pair in delays:
        _look_at_three(learner, clients, parts, pair)
    check_own_parts(learner, node, clients[0], parts)


def check_own_parts(learner, node, client, parts):
    """A panel asks its own battery and lidar, its `parts`, when another one has been made in another namespace."""
    answer = {'success': True, 'message': ''}
    others = [learner.serve(f'{OTHER}/{part}/check', Trigger, answer) for part in ('battery', 'lidar')]
    learner.start('StatusPanel', beside=node, remap={'__ns': OTHER})
    learner.settle()
    for part in parts:
        part.answer, part.delay = answer, 0.0
        part.requests.clear()
    client.send()
    learner.run(0.5)
    for part, other, name in zip(parts, others, ('battery/check', 'lidar/check'), strict=True):
        counts = len(part.requests), len(other.requests)
        check_own('StatusPanel', 'The first one was asked for its status', *counts, name, 'clients', 'names')


def _why_mixed(told, said) -> str:
    """What to do if callers were `told` something else; `said`: what battery and lidar have answered."""
    pairs = {
        f'battery: {one}; lidar: {other}': (at, to)
        for at, one in enumerate(said[0])
        for to, other in enumerate(said[1])
    }
    mixed = [pairs[message] for message, _ in told if message in pairs]
    if sorted(mixed) == [(number, number) for number in range(len(said[0]))]:
        return 'success is True if both answers have it, and only then.'
    if len(mixed) < len(told):
        return 'The message is made of both answers, as the card says.'
    return 'What belongs to one call must stay in local variables.'


def _look_at_three(learner, clients, parts, delays):
    """Three callers ask, one of them a little later, and each is told what the parts have said to it."""
    words, counts = learner.random.sample(WORDS, 6), [len(part.requests) for part in parts]
    good = [True, False, True]
    said = [words[:3], words[3:]]
    for part, delay, texts in zip(parts, delays, said, strict=True):
        part.delay = delay
        part.answer = iter(
            [{'success': ok or part is parts[1], 'message': text} for ok, text in zip(good, texts, strict=True)]
        )
    calls = [client.send() for client in clients[:2]]
    learner.run(0.1)
    calls.append(clients[2].send())
    learner.run(2.5, step=1.0)
    story = 'Three callers asked, two of them at the same time and one 0.1 s later'
    expect(all(call.done for call in calls), f'{story}, and not all of them got an answer.', 'callers')
    asked = [len(part.requests) - count for part, count in zip(parts, counts, strict=True)]
    told = sorted((call.response.message, call.response.success) for call in calls)
    expect(
        asked == [3, 3],
        f'{story}: the battery was asked {asked[0]} times, the lidar {asked[1]} times, expected 3 and 3. They were '
        f'told {told}. Each request asks each part, also while another one is open.',
        'callers',
    )
    wanted = sorted((f'battery: {first}; lidar: {second}', ok) for first, second, ok in zip(*said, good, strict=True))
    expect(
        told == wanted,
        f'{story}. The battery answered {said[0]} (the second time without success), the lidar {said[1]}; they were '
        f'told {told}, expected {wanted}. {_why_mixed(told, said)}',
        'callers',
    )
