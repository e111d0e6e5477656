"""Tables of distributions, and which one is chosen from them: for exercise 1.1."""

from calendar import isleap, monthrange
from dataclasses import dataclass
from random import Random

from helpers.runner import about, expect
from helpers.runner.first_call import FirstCall
from helpers.runner.values import SentAsTuple, SetAsList

RELEASES = {
    'foxy': SentAsTuple(('20.04', '2020-06', '2023-06')),
    'galactic': SentAsTuple(('20.04', '2021-05', '2022-12')),
    'humble': SentAsTuple(('22.04', '2022-05', '2027-05')),
    'iron': SentAsTuple(('22.04', '2023-05', '2024-12')),
    'jazzy': SentAsTuple(('24.04', '2024-05', '2029-05')),
    'kilted': SentAsTuple(('24.04', '2025-05', '2026-12')),
    'lyrical': SentAsTuple(('26.04', '2026-05', '2031-05')),
}
BOTH_SUPPORTED = [('24.04', '2026-08'), ('22.04', '2024-03'), ('20.04', '2021-09')]
_LETTERS = ('Cedar', 'black gum', 'Elm_2', 'fir.1', 'GINKGO', 'holly-b')  # names of other kinds
_NAMES = (
    *('maple', 'nettle', 'oak', 'pine', 'quince', 'rowan', 'spruce', 'thuja', 'umber', 'viburnum'),
    *('willow', 'yew', 'zelkova', 'acacia', 'beech'),
)
_WHY = {
    'ends-last': 'Of several supported ones, choose the one whose support ends last, not the newest.',
    'months': 'The first and the last month count, on every day of them. Compare months with months.',
    'ended': 'The support of all of them has ended by then.',
    'to-come': 'None is supported by then, and one comes later.',
    'unknown': 'No row of the table is for this Ubuntu.',
    'table': 'The table that is given has no row for this Ubuntu.',
}


@dataclass(frozen=True)
class Question:
    """One question, and the rule that a wrong answer breaks."""

    rule: str
    ubuntu: str
    month: str
    table: dict | None = None  # None: the course's own
    before: dict | None = None  # a table for which the same was asked before


def chosen(ubuntu: str, today: str, table: dict) -> list:
    """The right answer."""
    month = today[:7]
    rows = {name: row for name, row in table.items() if row[0] == ubuntu}
    supported = [name for name, (_, first, last) in rows.items() if first <= month <= last]
    if supported:
        return [max(supported, key=lambda name: rows[name][2]), 'supported']
    if not rows:
        return [None, 'unknown Ubuntu']
    return [None, 'not released yet' if any(first > month for _, first, _ in rows.values()) else 'end of life']


def cases(random: Random) -> list[Question]:
    """Questions about the course's table."""
    asked = {
        'ends-last': BOTH_SUPPORTED,
        'months': [
            ('20.04', '2023-06'),
            ('22.04', '2027-05'),
            ('24.04', '2029-05'),
            ('26.04', '2026-05'),
            ('20.04', '2020-06'),
        ],
        'ended': [('20.04', '2026-11'), ('22.04', '2027-06'), ('24.04', '2029-06'), ('26.04', '2040-01')],
        'to-come': [('26.04', '2026-04'), ('24.04', '2023-11'), ('22.04', '2020-12')],
        'unknown': [
            *(('23.10', '2026-11'), ('18.04', '2020-06'), ('24', '2025-06'), ('', '2026-01')),
            ('24.040', '2025-06'),  # nearly one of the table, and another text
        ],
    }
    return [
        Question(rule, ubuntu, month)
        for rule, pairs in asked.items()
        for ubuntu, month in random.sample(pairs, len(pairs))
    ]


def drawn_cases(random: Random) -> list[Question]:
    """Questions about a table of which nobody knows anything by heart."""
    # A century begins in it: who compares two digits of the years is found out.
    year = random.choice([random.randint(1993, 1998), random.randint(2093, 2098)])
    long, gap, late, far, near, same = random.sample(['34.04', '36.04', '38.04', '40.04', '44.04', '46.04'], 6)
    leap = next(one for one in range(year + 2, year + 12) if isleap(one))
    rows = _drawn_rows(random, year, leap, (long, gap, late, far, near, same))
    table = dict(zip(random.sample(_NAMES, len(rows)), map(SentAsTuple, rows), strict=True))
    asked = [
        ('ends-last', long, f'{year + 1}-08'),
        ('ends-last', late, f'{year + 2}-10'),
        ('ends-last', near, f'{year + 2}-07'),
        ('ends-last', same, f'{year + 3}-07'),
        ('months', gap, f'{year + 1}-12'),
        ('months', late, f'{year - 6}-03'),
        ('months', gap, f'{year + 4}-05'),
        ('months', '42.04', f'{leap}-02'),
        ('ended', '42.04', f'{leap}-03'),
        ('to-come', gap, f'{year + 2}-06'),
        ('to-come', gap, f'{year + 2}-01'),  # the month after a December
        ('to-come', late, f'{year - 7}-12'),
        ('ended', gap, f'{year + 9}-06'),
        ('ended', late, f'{year + 12}-01'),
        ('table', '24.04', '2026-11'),
        ('unknown', long + '.1', f'{year + 1}-08'),
    ]
    turned = dict(reversed(table.items()))  # what comes first in a table means nothing
    # Names that many know, in rows of others.
    known = dict(
        zip(['galactic', 'foxy', 'iron', 'humble', 'kilted', 'jazzy', 'lyrical'], RELEASES.values(), strict=True)
    )
    # The name of what has no end in ROS. Here it is a row like any other.
    rolling = {'jazzy': RELEASES['jazzy'], 'rolling': SentAsTuple(('24.04', '2020-06', '2030-01'))}
    return [
        *[Question(rule, ubuntu, month, table) for rule, ubuntu, month in asked],
        *[Question(rule, ubuntu, month, turned) for rule, ubuntu, month in asked if rule in ('to-come', 'ends-last')],
        Question('table', '24.04', '2026-11', {}),
        Question('table', '24.04', '2026-11', rolling),
        *[Question('table', ubuntu, month, known) for ubuntu, month in BOTH_SUPPORTED],
    ]


def _drawn_rows(random: Random, year: int, leap: int, systems: tuple[str, ...]) -> list[list[str]]:
    """The rows of a table: of several distributions for one Ubuntu those that end sooner come first, older or newer."""
    long, gap, late, far, near, same = systems
    rows = [
        [long, f'{year + 1}-05', f'{year + 2}-11'],
        [late, f'{year - 6}-03', f'{year + 8}-02'],  # supported for longer than the other, which ends in the same year
        [long, f'{year}-05', f'{year + 9}-05'],
        [late, f'{year + 1}-09', f'{year + 8}-10'],
        [long, f'{year}-09', f'{year + 10}-02'],  # the third one for this Ubuntu
        [near, f'{year}-03', f'{year + 4}-06'],
        [near, f'{year - 1}-05', f'{year + 6}-08'],
        [near, f'{year + 5}-01', f'{year + 11}-02'],  # ends last of the three, and has not begun when it is asked
        [same, f'{year - 2}-04', f'{year + 7}-11'],  # the older one ends later in the same year
        [same, f'{year + 1}-04', f'{year + 7}-03'],
    ]
    rows.insert(random.randint(0, len(rows)), [far, f'{year + 13}-05', f'{year + 18}-05'])  # what is to come for others
    for row in ([gap, f'{year}-05', f'{year + 1}-12'], [gap, f'{year + 4}-05', f'{year + 9}-05']):
        rows.insert(random.randint(0, len(rows)), row)
    rows.insert(random.randint(0, len(rows)), ['42.04', f'{year}-08', f'{leap}-02'])  # to the 29th
    return rows


def crowded_cases(random: Random) -> list[Question]:
    """A table with seven distributions for one Ubuntu, one that is supported for a month, and names of all kinds."""
    year = random.randint(2051, 2088)
    ends = [3, 4, 2, 5, 9, 6, 7]  # from both ends of the table, some come before the one that ends last
    rows = {
        name: ['48.04', f'{year + random.randint(-3, 0)}-{random.randint(1, 9):02}', f'{year + end}-06']
        for name, end in zip(random.sample(_NAMES, len(ends)), ends, strict=True)
    }
    month = f'{year + 1}-{random.randint(1, 12):02}'
    for number, name in enumerate(_LETTERS):
        rows[name] = [f'{50 + 2 * number}.10', month if number == 0 else f'{year}-02', month]
    table = {name: SentAsTuple(row) for name, row in rows.items()}
    asked = [('months', f'{50 + 2 * number}.10') for number in range(len(_LETTERS))]
    return [Question(rule, ubuntu, month, table) for rule, ubuntu in [('ends-last', '48.04'), *asked]]


def border_cases(random: Random) -> list[Question]:
    """The months on both sides of each border in a drawn table, and the same with other names in the same rows."""
    systems = random.sample(['27.04', '29.10', '31.04', '33.10'], 3)
    rows: list[list[str]] = []
    asked: list[tuple[str, str]] = []
    for number, system in enumerate(2 * systems):
        first = 12 * random.randint(2091, 2098) + (9 if number in (0, 5) else random.randrange(12))  # 9: October
        last = first + random.randint(2, 70)
        while any(row[0] == system and row[2] == _month(last) for row in rows):
            last += 1
        rows.append([system, _month(first), _month(last)])
        asked += [(system, _month(month)) for month in (first - 1, first, last, last + 1)]
    names = random.sample((*_NAMES, *_LETTERS), len(rows))
    table, renamed = (dict(zip(names[turn:] + names[:turn], map(SentAsTuple, rows), strict=True)) for turn in (0, 1))
    return [
        Question(_rule(system, month, table), system, month, now, before)
        for system, month in asked
        for now, before in ((table, None), (renamed, table))
    ]


def _month(number: int) -> str:
    return f'{number // 12}-{number % 12 + 1:02}'


def _rule(system: str, month: str, table: dict) -> str:
    """The rule that a wrong answer to this question breaks."""
    name, reason = chosen(system, month + '-01', table)
    if name:
        return 'months' if month in table[name][1:] else 'ends-last'
    return {'not released yet': 'to-come', 'end of life': 'ended'}[reason]


def check(learner, asked: list[Question]) -> None:
    """`choose_distribution` answers these questions rightly."""
    first = FirstCall(learner, 'choose_distribution', 'table')
    for case in asked:
        last = monthrange(*map(int, case.month.split('-')))[1]
        # The last day that counts, and the first one after it: months have 28 to 31 days.
        days = {'months': (1, last), 'ended': (1, learner.random.randint(2, last))}
        for day in days.get(case.rule, (learner.random.randint(1, last),)):
            _check_day(learner, case, f'{case.month}-{day:02}', first)


def _check_day(learner, case: Question, today: str, first: FirstCall) -> None:
    given = [] if case.table is None else [case.table]
    with about(case.rule if case.before is None else 'table'):
        got = learner.call('choose_distribution', case.ubuntu, today, *given)
    if got != chosen(case.ubuntu, today, RELEASES if case.table is None else case.table):
        first.check_again()
    first.note(got, case.ubuntu, today, *given)
    where = f'Ubuntu {case.ubuntu!r} on {today}' + (f' with the table {case.table}' if given else '')
    expect(
        not isinstance(got, SetAsList),
        f'{where} gives a set. A set has no order, so nobody could say which of its two is the name: return a tuple.',
        'pair',
    )
    expect(isinstance(got, list) and len(got) == 2, f'{where} gives {got!r}; expected a pair (name, reason).', 'pair')
    expect(
        isinstance(got[0], str | None),
        f'{where} gives {tuple(got)!r}: the first of the pair is one name, or None.',
        'pair',
    )
    table = RELEASES if case.table is None else case.table
    wanted = chosen(case.ubuntu, today, table)
    expect(
        got == wanted or got != wanted[::-1],
        f'{where} gives {tuple(got)!r}, expected {tuple(wanted)!r}: the name comes first, then the reason.',
        'pair',
    )
    by_heart = bool(given) and got == chosen(case.ubuntu, today, RELEASES)
    rule, why = ('table', 'Use the argument `releases`, and nothing that you know by heart.')
    if not by_heart:
        rule, why = _explained(case, got, wanted, table)
    expect(got == wanted, f'{why} {where} gives {tuple(got)!r}, expected {tuple(wanted)!r}.', rule)
    first.check_unchanged()


def _explained(case: Question, got: list, wanted: list, table: dict) -> tuple[str, str]:
    """The rule that a wrong answer breaks, and a sentence on it."""
    name, right = got[0] or '', wanted[0] or ''
    if right and name != right and name.lower() == right.lower():
        return 'table', f'The name is {right!r}, letter by letter, as in the table.'
    if case.before is not None and got == chosen(case.ubuntu, f'{case.month}-01', case.before):
        return 'table', 'This was right for another table, in a call before. Only the table that is given counts.'
    if name in table and table[name][0] != case.ubuntu:
        return case.rule, f'{name} is for Ubuntu {table[name][0]!r}. {_WHY[case.rule]}'
    supported = [
        name
        for name, (made_for, first, last) in table.items()
        if made_for == case.ubuntu and first <= case.month <= last
    ]
    if name in table and name not in supported:
        _, first, last = table[name]
        why = '' if right else ' ' + _WHY[case.rule]
        rule = 'ends-last' if right and case.month not in table[right][1:] else case.rule
        return rule, f'{name} is supported from {first} to {last}, and not then.{why}'
    if not right or case.rule == 'table' or name in supported:
        return case.rule, _WHY[case.rule]
    _, first, last = table[right]
    if first < case.month < last:
        return 'ends-last', f'{right} is supported from {first} to {last}, whatever the other rows say.'
    return 'months', f'Its support goes from {first} to {last}. {_WHY["months"]}'
