"""Roll calls and bridges between domains that nobody else uses: for exercise 1.3."""

import time
from collections.abc import Iterable
from contextlib import ExitStack, contextmanager
from random import Random

from rclpy.qos import ReliabilityPolicy
from std_msgs.msg import String

from helpers.kernel.domains import claim
from helpers.runner import about, expect, waiting
from helpers.runner.elsewhere import Elsewhere
from helpers.runner.load import busy
from helpers.runner.values import SetAsList, TupleAsList
from helpers.runner.verdicts import LearnerTimeout

DEFAULT = 3.0  # seconds that a listener is given, if nothing is said
BRIEF = 1.5  # seconds; where another test was stuck, a call may take no longer than DEFAULT
LONG = 8.0  # seconds, on a busy machine
AT_ONCE = 'It is done after `seconds`, however many listeners there are: all of them listen at the same time.'


@contextmanager
def domains(count: int):
    """So many domains that nobody else uses."""
    with ExitStack() as held:
        yield [held.enter_context(claim()) for _ in range(count)]


def check_kind(got, call: str) -> None:
    """What `who_hears` returned is a list of numbers: rule `sorted`."""
    expect(got is not None, f'{call} gives None: return the list. What is only printed, no program can use.', 'sorted')
    kind = {SetAsList: 'a set', TupleAsList: 'a tuple'}.get(type(got), repr(got))
    expect(
        isinstance(got, list) and not isinstance(got, SetAsList | TupleAsList),
        f'{call} gives {kind}, expected a sorted list of domains.',
        'sorted',
    )
    expect(
        all(isinstance(domain, int) for domain in got),
        f'{call} gives {got!r}: the list holds the domains as they were given, as numbers.',
        'sorted',
    )


def _who_hears(learner, ours: int, asked: list[int], wanted: list[int], seconds: float):
    """What `who_hears` returns of these, of whom not all can hear.

    A wrong answer of a busy machine is asked for once more, for longer, unless it has come before its time.
    """
    with about('measures'), waiting('in-time'):
        begin = time.monotonic()
        try:
            got = learner.call('who_hears', ours, asked, *([] if seconds == DEFAULT else [seconds]))
            took = time.monotonic() - begin
            if got != wanted:
                _check_not_too_soon(f'who_hears({ours}, {asked})', took, seconds, 'some of them')
            if got != wanted and busy():
                got = learner.call('who_hears', ours, asked, LONG)
        except LearnerTimeout as error:
            error.message += f' {AT_ONCE}'
            raise
    return got


def check_roll_call(learner) -> None:
    """`who_hears` speaks in its own domain, and finds a bridge that the tests have made."""
    with domains(3) as (ours, second, third), Elsewhere(ours) as here:
        heard = here.listen('/roll_call', String)
        asked, begin = learner.random.sample([ours, second, third], 3), time.monotonic()
        seconds = DEFAULT if learner.timeouts.call > DEFAULT + 1 else BRIEF
        got = _who_hears(learner, ours, asked, [ours], seconds)
        took = time.monotonic() - begin
        here.wait_until(lambda: heard, timeout=1)
        expect(
            here.met('/roll_call'),
            f'No speaker for the topic roll_call came into domain {ours}, or it left before others could find it: '
            f'who_hears({ours}, {asked}) gives {got!r}. Is the name of its topic roll_call? Each context has its own '
            'domain: rclpy.init(context=…, domain_id=…).',
            'measures',
        )
        check_kind(got, f'who_hears({ours}, {asked})')
        expect(
            len(set(got)) == len(got),
            f'who_hears({ours}, {asked}) names a domain more than once, in a list of {len(got)}: once for each message '
            'that came? It returns each domain once.',
            'sorted',
        )
        if got == [ours]:
            _check_not_too_soon(f'who_hears({ours}, {asked})', took, seconds, f'{second} and {third}')
            expect(
                took < seconds + 1.5 or busy(),  # it also makes contexts and nodes, and ends them
                f'who_hears({ours}, {asked}) took {took:.1f} s. Without a third argument it is done after {DEFAULT} s.',
                'in-time',
            )
        expect(
            heard,
            f'A speaker was in domain {ours}, and nobody there heard it; who_hears({ours}, {asked}) gives {got!r}. '
            'Discovery takes time: what is published before it is lost. Publish again and again.',
            'measures',
        )
        expect(
            got,
            f'The speaker of who_hears({ours}, {asked}) was heard in domain {ours} by a listener of the tests, and the '
            f'function gives {got!r}: no callback of its own listener was called. Is each listener spun, again and '
            'again while the speaker publishes? Its executor must have the same context as its node.',
            'measures',
        )
        expect(
            got == [ours],
            f'who_hears({ours}, {asked}) gives {got!r}, expected {[ours]}: a speaker is heard in its own domain only.',
            'measures',
        )


def _check_not_too_soon(call: str, took: float, seconds: float, missing: str) -> None:
    """A call of which a listener has not heard goes on for `seconds`: rule `in-time`."""
    expect(
        took > seconds - 0.1,
        f'{call} ended after {took:.1f} s, and {missing} had not heard. It is done when all have heard, or after '
        '`seconds`. Or does it compare numbers, and not listen?',
        'in-time',
    )


def check_bridged(learner) -> None:
    """`who_hears` finds a bridge that the tests have made."""
    # On a busy machine none of one digit may be free; one of three digits comes before most others as a text, too.
    with domains(11) as lowest, claim(highest=True) as highest:
        claimed = [*lowest, highest]
        # The bridge leads to a smaller number, so that the order in which listeners hear is not the sorted one; nor is
        # that of their texts, nor that of a set, if there are such domains.
        second, ours, third = sorted(claimed)[:3]
        numbers = [(low, high) for low in claimed for high in claimed if low < high and str(low) > str(high)]
        numbers = [pair for pair in numbers if list(set(pair)) != sorted(pair)] or numbers
        if numbers:
            second, ours = learner.random.choice(numbers)
            third = next(domain for domain in claimed if domain not in (second, ours))
        more = [domain for domain in claimed if domain not in (second, ours, third)][:2]  # the last listener hears, too
        with Elsewhere(second) as there, Elsewhere(ours) as here, Elsewhere(third) as silent:
            here.relay('/roll_call', String, to=there)
            mute = silent.node.create_publisher(String, '/roll_call', 10)  # it is there, and says nothing
            asked = learner.random.sample([ours, third, *more], 4) + [second]
            wanted = [second, ours]
            got = _who_hears(learner, ours, asked, wanted, 2.0)
            silent.node.destroy_publisher(mute)
        check_kind(got, f'who_hears({ours}, {asked})')
        expect(
            third not in got,
            f'A publisher of roll_call was in domain {third}, and silent. who_hears({ours}, {asked}) gives {got}: '
            'a listener has heard the speaker when its message comes, not when somebody could speak.',
            'measures',
        )
        expect(
            got != [ours],
            f'The tests have a bridge for roll_call from domain {ours} to {second}. Your function '
            f'says that only {ours} hears: does it compare numbers, and not listen? Or do only some of '
            'the listeners listen?',
            'measures',
        )
        said = f'With a bridge from {ours} to {second}, who_hears({ours}, {asked}) gives {got!r}, expected {wanted}.'
        as_texts = got == wanted[::-1] == sorted(wanted, key=str)
        expect(not as_texts, f'{said} The domains must be sorted, as numbers and not as texts.', 'sorted')
        expect(set(got) == set(wanted), said, 'measures')
        expect(got == wanted, f'{said} The domains must be sorted, each once.', 'sorted')


def check_cut(learner) -> None:
    """`who_hears` names no domain when no message gets through, not even the speaker's own one."""
    with domains(2) as claimed:
        ours, asked = claimed[0], learner.random.sample(claimed, 2)
        learner.mute('/roll_call')
        with about('measures'), waiting('in-time'):
            got = learner.call('who_hears', ours, asked, 0.6)
        learner.end_calls()
    check_kind(got, f'who_hears({ours}, {asked}, 0.6)')
    expect(
        not got,
        f'The tests have let no message of the speaker through, in any domain. who_hears({ours}, {asked}, 0.6) gives '
        f"{got}, expected []: a domain counts when its listener has heard, the speaker's own domain, too.",
        'measures',
    )


def check_time(learner) -> None:
    """`who_hears` returns soon if all have heard, long before `seconds`, and after `seconds` if one cannot hear."""
    with domains(1) as (ours,):
        begin = time.monotonic()
        with about('in-time'):
            got = learner.call('who_hears', ours, [ours], 60.0)
        check_kind(got, f'who_hears({ours}, {[ours]}, 60.0)')
        expect(got == [ours], f'who_hears({ours}, {[ours]}, 60.0) gives {got!r}, expected {[ours]}.', 'measures')
        expect(
            time.monotonic() - begin < 12,
            'All heard, and who_hears goes on much longer than it may. It is done when all have heard.',
            'in-time',
        )
    with domains(4) as (ours, *others):
        seconds = round(learner.random.uniform(1.6, 2.0), 1)
        for last in (False, False, True):  # a busy machine may need long to make the nodes, but not three times
            none, took = (_time(learner, ours, others, limit) for limit in (0.0, seconds))
            expect(
                took >= seconds - 0.1,
                f'who_hears({ours}, {others}, {seconds}) gave up after {took:.1f} s, and none had heard. It is done '
                'when all have heard, or after `seconds`.',
                'in-time',
            )
            if none < 2.5 and took - none < 1.8 * seconds:
                break
            expect(
                not last,
                f'who_hears({ours}, {others}, {seconds}) took {took:.1f} s, with 0.0 s instead {none:.1f} s. {AT_ONCE}',
                'in-time',
            )


def _time(learner, ours: int, others: list[int], seconds: float) -> float:
    """How long `who_hears` takes with listeners of which none can hear."""
    begin = time.monotonic()
    with about('in-time'):
        got = learner.call('who_hears', ours, others, seconds)
    took = time.monotonic() - begin
    expect(got == [], f'who_hears({ours}, {others}, {seconds}) gives {got!r}, expected an empty list.', 'measures')
    return took


def check_left(learner) -> None:
    """After the call, no node and no context of it is left in the domains."""
    _check_left_with_listeners(learner)
    _check_left_without_listeners(learner)


def _check_left_without_listeners(learner) -> None:
    with domains(1) as (ours,):
        contexts = learner.contexts
        with about('in-time'):
            got = learner.call('who_hears', ours, [], 60.0)
        expect(got == [], f'who_hears({ours}, [], 60.0) gives {got!r}: without a listener the list is empty.', 'sorted')
        expect(
            learner.contexts == contexts,
            f'After who_hears({ours}, []) a context of it is not shut down, also if there was nothing to do.',
            'leaves',
        )


def _check_left_with_listeners(learner) -> None:
    for _ in range(3):  # a goodbye may get lost on a busy machine; three in a row do not
        with domains(2) as (ours, other), Elsewhere(ours) as here, Elsewhere(other) as there:
            heard = here.listen('/roll_call', String)
            before, begin = learner.contexts, time.monotonic()
            with about('measures'), waiting('in-time'):
                got = learner.call('who_hears', ours, [ours, other], 1.0)
            took, alive = time.monotonic() - begin, learner.contexts - before
            check_kind(got, f'who_hears({ours}, {[ours, other]}, 1.0)')
            expect(
                got == [ours], f'who_hears({ours}, {[ours, other]}, 1.0) gives {got!r}, expected {[ours]}.', 'measures'
            )
            _check_not_too_soon(f'who_hears({ours}, {[ours, other]}, 1.0)', took, 1.0, str(other))
            expect(
                here.wait_until(lambda: heard, timeout=2),  # noqa: B023 - used at once
                f'who_hears({ours}, {[ours, other]}, 1.0) said nothing on roll_call in domain {ours}.',
                'measures',
            )
            if here.wait_until(lambda: not here.nodes(), timeout=1):  # noqa: B023
                there.wait_until(lambda: not there.nodes(), timeout=1)  # noqa: B023
                if not there.nodes():
                    expect(
                        not alive,
                        f'After the call {alive} of its contexts are not shut down. `leave` does it, or '
                        'rclpy.shutdown(context=…), for the speaker and for each listener.',
                        'leaves',
                    )
                    return
            left = here.nodes() or there.nodes()
    expect(
        False,
        f'After the call these nodes are left in its domains: {", ".join(left)}. Destroy them, and shut '
        'their contexts down.',
        'leaves',
    )


def _far(space: str) -> tuple[str, str]:
    """The topics on which a bridge may speak in the other domain: a namespace need not hold for both contexts."""
    return '/chatter', f'{space}/chatter'


def _best_effort(there: Elsewhere, space: str) -> bool:
    """Whether what a bridge has there may lose messages; the tests' own publishers do not."""
    found = [info for topic in _far(space) for info in there.node.get_publishers_info_by_topic(topic)]
    return any(info.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT for info in found)


def check_bridge(learner, count: int) -> None:
    """A Bridge in a namespace carries `count` drawn texts to the other domain, as they are, and nothing back."""
    random = learner.random
    space = f'/side{random.randint(2, 99)}'
    near = f'{space}/chatter'
    with domains(1) as (domain,), Elsewhere(domain) as there, Elsewhere(learner.context.get_domain_id()) as here:
        heard: list = []
        for topic in _far(space):
            there.listen(topic, String, heard)
        spoken = [there.node.create_publisher(String, topic, 100) for topic in _far(space)]
        talker = learner.talk(near, String, strict=False)
        node = _start_bridge(learner, domain, space)
        expect(there.wait_until(there.nodes, 5), f'No node of yours is in domain {domain}.', 'bridge')
        at_home = here.listen(near, String)  # only now: it is a subscription on chatter, too

        def arrived():
            talker.send(String(data='first'))
            _pass(learner)
            return bool(heard)

        first_came = there.wait_until(arrived, timeout=6)
        expect(
            first_came or not _best_effort(there, space),
            f'Your publisher of chatter in domain {domain} is BEST_EFFORT: a listener that asks for all messages hears '
            'none of it, and others may miss some. Give the depth 10 in the place of another profile.',
            'carries',
        )
        expect(
            first_came,
            f'Messages were published on chatter in the domain of the program, and none came in domain {domain}.'
            + _published_instead(there, _far(space)),
            'carries',
        )
        expect(
            heard[0].data == 'first',
            f"'first' was said here, and in the other domain came {heard[0].data[:60]!r}: texts are carried unchanged.",
            'carries',
        )
        inside = f'{space}/bridge' in there.full_names()  # who gives its context no arguments has no namespace there
        expect(
            not inside or there.node.count_publishers(near) > 1,  # the first is the tests'
            f'In the namespace {space} your bridge says on /chatter in domain {domain}: a relative name has no leading '
            'slash there, either.',
            'carries',
        )
        texts = _texts(random, count)
        texts = _say_all(learner, there, talker, heard, texts)
        _check_texts(_came(heard), texts)
        _check_quiet(learner, here, at_home, heard, ['first', *texts])
        _check_one_way(learner, there, here, spoken, at_home)
        _check_two(learner, there, heard, talker, node, space)


def _published_instead(there: Elsewhere, wanted: Iterable[str]) -> str:
    """What to say of topics on which a node of the learner's publishes texts in the other domain."""
    others = sorted(
        topic
        for topic, types in there.node.get_topic_names_and_types()
        if types == ['std_msgs/msg/String'] and topic not in wanted
        for info in there.node.get_publishers_info_by_topic(topic)
        if not info.node_name.startswith('_')
    )
    return f' Your node there publishes on {others[0]}: the name of the topic is chatter.' if others else ''


def _came(heard: list) -> list[str]:
    """The texts that have come after the first one, which is said until it has come."""
    return [message.data for message in heard if message.data != 'first']


def _say_all(learner, there: Elsewhere, talker, heard: list, texts: list[str]) -> list[str]:
    """Say the texts, as long as they come in the other domain; returns those that were said."""

    def all_came(number: int) -> bool:
        return there.wait_until(lambda: len([text for text in _came(heard) if text in texts]) >= number, timeout=5)

    for end in range(5, len(texts) + 5, 5):  # half of what the queue holds
        talker.send(*[String(data=text) for text in texts[end - 5 : end]])
        _pass(learner)
        if end % 50 == 0 and not all_came(end):  # the tests' own queue does not hold all of them
            return texts[:end]
    all_came(len(texts))
    return texts


def _texts(random: Random, count: int) -> list[str]:
    """Texts of all kinds, `count` short ones with blanks and other alphabets among them."""
    texts = [f'  {word} {random.randint(0, 999)} \n' for word in ('north', 'Süd', '東', *(count - 3) * ['EAST'])]
    texts += ['', texts[0], texts[0]]  # what was said before is said again, and twice in a row
    return [*texts, f'{random.random()} ' * random.randint(20, 200), *map(str, range(random.randint(270, 300)))]


def _check_texts(got: list[str], texts: list[str]) -> None:
    """What has come in the other domain is what was said, text by text, and nothing else."""
    own = [text for text in got if text not in texts]
    expect(
        not own or [text for text in got if text in texts] != texts,
        f'All that was said here came in the other domain, and your bridge said {own[:1]} by itself, too. It only '
        'carries what it hears.',
        'carries',
    )
    for number, (said, heard_there) in enumerate(zip(texts, got, strict=False), start=1):
        kind = ', an empty one' if not said else ', for the second time' if said in texts[: number - 1] else ''
        expect(
            not kind
            or heard_there == said
            or heard_there != next((text for text in texts[number:] if text != said), None),
            f'Text {number} of those that were said here was {said[:60]!r}{kind}, and in the other domain came only '
            'the ones after it: everything is carried, unchanged, once and in order.',
            'carries',
        )
        expect(
            heard_there == said,
            f'Text {number} of those that were said here was {said[:60]!r}, of {len(said)} characters, and in the '
            f'other domain came {heard_there[:60]!r}, of {len(heard_there)}: unchanged, once and in order.',
            'carries',
        )
    expect(
        len(got) == len(texts),
        f'{len(texts)} texts were said here; in the other domain came {len(got)}: each one, once.',
        'carries',
    )


def _pass(learner) -> None:
    """Let the bridge carry what was said; one that does so in a timer gets the time."""
    with about('carries'):
        learner.run(0.3)


def _check_quiet(learner, here: Elsewhere, at_home: list, heard: list, said: list[str]) -> None:
    """As long as nobody says anything, a bridge says nothing either: on both sides came only what was `said`."""
    for _ in range(2):
        with about('carries'):
            learner.run(2.5, step=1.0)
        here.wait_until(lambda: False, timeout=0.05)
    own = [message.data for message in (*at_home, *heard) if message.data not in said]
    expect(
        not own,
        f'Nobody spoke for 5 s, and your bridge said {own[:1]} on chatter by itself. It only carries what it hears.',
        'carries',
    )


def _check_two(learner, there: Elsewhere, heard: list, talker, node, space: str) -> None:
    """With a second bridge in the same program, to a third domain, both domains hear what is said."""
    with domains(1) as (domain,), Elsewhere(domain) as third:
        also: list = []
        for topic in _far(space):
            third.listen(topic, String, also)
        with about('bridge'):
            learner.start('Bridge', domain, beside=node)

        def came(messages: list) -> bool:
            return any(message.data == 'for both' for message in messages)

        def both():
            talker.send(String(data='for both'))
            _pass(learner)
            there.wait_until(lambda: came(heard), timeout=0.05)
            return came(heard) and came(also)

        third.wait_until(both, timeout=6)
        expect(
            came(heard),
            'A second Bridge, to another domain, was made in the same program. Since then the first one carries '
            'nothing: each bridge keeps a node and a publisher of its own (self), not of the class.',
            'carries',
        )
        expect(
            came(also),
            'A second Bridge, to another domain, was made in the same program, and nothing came in its domain.',
            'carries',
        )


def _start_bridge(learner, domain: int, space: str):
    """Start a Bridge to this domain in a namespace, and look at its name and its subscription."""
    near = f'{space}/chatter'
    with about('bridge'):
        node = learner.start('Bridge', domain, remap={'__ns': space})
    expect(node.name == f'{space}/bridge', f'The node is called {node.name}, expected {space}/bridge.', 'bridge')
    expect(
        learner.endpoints(near).subscriptions or not learner.endpoints('/chatter').subscriptions,
        f'In the namespace {space} your bridge listens on /chatter: a relative name has no leading slash.',
        'carries',
    )
    expect(
        learner.endpoints(near).subscriptions,
        'Your bridge does not listen on /chatter in the domain of the program.',
        'carries',
    )
    expect(
        learner.depths('subscription', near) == [10],
        'The queue of your subscription to chatter has not the depth 10.',
        'carries',
    )
    return node


def _check_one_way(learner, there: Elsewhere, here: Elsewhere, spoken: list, at_home: list) -> None:
    """What the publishers `spoken` say in the other domain does not come to this one, as `at_home` would show."""

    def listens_there():
        return any(there.node.count_subscribers(one.topic_name) > 1 for one in spoken)  # the first is the tests'

    there.wait_until(listens_there, timeout=0.3)
    back = listens_there()
    before = len(at_home)
    for publisher in spoken:
        publisher.publish(String(data='echo?'))
    for _ in range(5):
        with about('one-way'):
            learner.settle()
        here.wait_until(lambda: any(message.data == 'echo?' for message in at_home[before:]), timeout=0.05)
    expect(
        not back and not any(message.data == 'echo?' for message in at_home),
        'Your bridge also listens in the other domain. It must carry in one direction only: two directions make '
        'an endless echo.',
        'one-way',
    )
