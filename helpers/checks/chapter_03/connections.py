"""Pairs of an offer and a request, and what keeps them apart: for exercise 3.5."""

from itertools import product

from helpers.runner import expect
from helpers.runner.first_call import FirstCall
from helpers.runner.values import SetAsList, TupleAsList

KEYS = ('topic', 'type', 'reliability', 'durability', 'deadline')
WEAK = {'reliability': 'BEST_EFFORT', 'durability': 'VOLATILE'}
STRONG = {'reliability': 'RELIABLE', 'durability': 'TRANSIENT_LOCAL'}
_TYPES = ('sensor_msgs/msg/LaserScan', 'sensor_msgs/msg/Image', 'std_msgs/msg/Bool', 'nav_msgs/msg/Odometry')
_TOPICS = ('/scan', '/image', '/front/scan', '/odom', '/stop')


def endpoint(random) -> dict:
    """An endpoint as the card describes it; everything is drawn."""
    return {
        'topic': random.choice(_TOPICS),
        'type': random.choice(_TYPES),
        'deadline': 0.0,
        'depth': random.randint(1, 50),
        **{key: random.choice((WEAK[key], STRONG[key])) for key in WEAK},
    }


def single_pairs(random) -> list[tuple[dict, dict]]:
    """Pairs (offered, requested) that differ in reliability and durability, or in one other key."""
    base = endpoint(random)
    pairs = [(base, dict(base))]
    for key in WEAK:
        pairs += [
            ({**base, key: first}, {**base, key: second})
            for first, second in product((WEAK[key], STRONG[key]), repeat=2)
        ]
    topic, kind = base['topic'], base['type']
    for key, other in (
        ('topic', topic.title()),
        ('topic', topic + '2'),
        ('topic', '/left' + topic),
        ('topic', topic[1:]),
        ('type', kind + 'Stamped'),
        ('type', kind.rpartition('/')[2]),
        ('type', kind.replace('/msg/', '/')),
    ):
        pairs += [({**base, key: other}, base), (base, {**base, key: other})]
    short = round(random.uniform(0.01, 3.0), 4)
    for long in (round(short + random.uniform(0.001, 0.01), 4), round(random.uniform(20.0, 5000.0), 1)):
        for first, second in ((short, long), (long, short), (long, long), (0.0, 0.0), (0.0, long), (long, 0.0)):
            pairs.append(({**base, 'deadline': first}, {**base, 'deadline': second}))
    plain = max(0.1, round(short, 1))  # which stays what it is when it is rounded
    # Hardly longer, and longer than any.
    for first, second in ((short + 1e-6, short), (plain + 1e-6, plain), (0.0, 1e12)):
        pairs.append(({**base, 'deadline': first}, {**base, 'deadline': second}))
    few, many = random.randint(1, 9), random.randint(100, 200)
    for one, other in ((few, many), (0, few)):  # 0: the system's default
        pairs += [
            ({**base, 'depth': one}, {**base, 'depth': other}),
            ({**base, 'depth': other}, {**base, 'depth': one}),
        ]
    return pairs


def mixed_pairs(random, count: int) -> list[tuple[dict, dict]]:
    """Pairs with several reasons: all five, and `count` others."""
    pairs = []
    for number in range(count + 1):
        offered = endpoint(random)
        requested = dict(offered)
        reasons = KEYS if not number else random.sample(KEYS, random.randint(2, 4))
        for key in reasons:
            if key in WEAK:
                offered[key], requested[key] = WEAK[key], STRONG[key]
            elif key == 'deadline':
                offered[key], requested[key] = random.choice(((2.5, 0.4), (0.0, 1.5)))
            else:
                requested[key] = offered[key] + 's'
        if 'deadline' not in reasons:
            offered['deadline'], requested['deadline'] = random.choice(((0.1, 0.0), (0.2, 0.7), (0.0, 0.0)))
        keys = list(requested)
        random.shuffle(keys)  # the order of the keys in a dictionary means nothing
        pairs.append((offered, {key: requested[key] for key in keys}))
    return pairs


def reasons(offered: dict, requested: dict) -> list[str]:
    """What prevents the connection."""
    found = [key for key in ('topic', 'type') if offered[key] != requested[key]]
    found += [key for key in WEAK if offered[key] == WEAK[key] and requested[key] == STRONG[key]]
    endless = float('inf')
    if (offered['deadline'] or endless) > (requested['deadline'] or endless):
        found.append('deadline')
    return found


def check_pairs(learner, pairs: list[tuple[dict, dict]]) -> None:
    """`why_no_data` is right for these pairs; single reasons should come first."""
    first = FirstCall(learner, 'why_no_data', 'list')
    for offered, requested in pairs:
        got = learner.call('why_no_data', offered, requested)
        wanted = reasons(offered, requested)
        if got != wanted:
            first.check_again()
        first.note(got, offered, requested)
        different = (
            ', '.join(
                f'{key} {offered[key]} → {requested[key]}' for key in (*KEYS, 'depth') if offered[key] != requested[key]
            )
            or 'all keys equal'
        )
        said = f'With {different} (offered → requested) why_no_data gives {got!r}, expected {wanted!r}.'
        expect(
            not isinstance(got, SetAsList),
            f'With {different} (offered → requested) why_no_data gives a set, which has no order; expected {wanted!r}.',
            'list',
        )
        expect(
            not isinstance(got, TupleAsList),
            f'With {different} (offered → requested) why_no_data gives a tuple, expected the list {wanted!r}.',
            'list',
        )
        expect(isinstance(got, list), f'{said} It must return a list, also when all fits.', 'list')
        extra = [key for key in got if key not in wanted]
        missing = [key for key in wanted if key not in got]
        for key in (*extra, *missing):
            rule, why = _explained(key, offered, requested, key in missing, len(wanted) > 1)
            expect(False, f'{said} {why}', rule)
        expect(len(got) == len(wanted), f'{said} Name each key once.', 'list')
        expect(got == wanted, f'{said} Keep the order of the specification.', 'order')


def _explained(key: str, offered: dict, requested: dict, missing: bool, several: bool) -> tuple[str, str]:
    """The rule that a wrong answer breaks, and a sentence on it."""
    if key not in (*KEYS, 'depth'):
        return 'list', f'{key!r} is none of the keys.'
    if key == 'depth':
        return 'depth', 'Depth is a private matter of each side, and never a reason.'
    if missing and several:
        return 'all', 'Name every key that does not fit.'
    if key in ('topic', 'type'):
        return 'names', 'They fit only if they are equal, letter by letter.'
    if key == 'deadline':
        equal = ' Two that are equal fit.' if offered[key] == requested[key] else ''
        if offered[key] and requested[key]:
            return 'deadline', f'The offered period must not be longer than the requested one.{equal}'
        return 'no-deadline', f'0.0 is an endless period.{equal}'
    if missing:
        return key, 'An offer must be at least as strong as the request.'
    return key, 'Different is not incompatible: an offer that is stronger than the request fits.'
