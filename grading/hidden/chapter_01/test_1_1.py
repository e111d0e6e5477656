"""Hidden tests of exercise 1.1, choose a distribution."""

import pytest

from helpers.runner import expect

pytestmark = pytest.mark.exercise('1.1')

TABLE = {
    'foxy': ['20.04', '2020-06', '2023-06'],
    'galactic': ['20.04', '2021-05', '2022-12'],
    'humble': ['22.04', '2022-05', '2027-05'],
    'iron': ['22.04', '2023-05', '2024-12'],
    'jazzy': ['24.04', '2024-05', '2029-05'],
    'kilted': ['24.04', '2025-05', '2026-12'],
    'lyrical': ['26.04', '2026-05', '2031-05'],
}


def ask(learner, ubuntu, today, *table):
    got = learner.call('choose_distribution', ubuntu, today, *table)
    expect(isinstance(got, list) and len(got) == 2,
           f'Ubuntu {ubuntu} on {today}: you return {got!r}, expected a pair (name, reason).')
    return tuple(got)


def day(random, month):
    return f'{month}-{random.randint(1, 28):02}'


@pytest.mark.weight(2)
def test_support_has_an_end(learner):
    """A distribution is offered only while it is supported.

    The answer depends on today, not only on the Ubuntu.
    """
    for ubuntu, name, month in (('20.04', 'foxy', '2023-07'), ('22.04', 'humble', '2027-06'),
                                ('24.04', 'jazzy', '2029-06'), ('26.04', 'lyrical', '2031-06')):
        today = day(learner.random, month)
        got = ask(learner, ubuntu, today)
        expect(got[0] is None, f'On {today} you offer {got[0]} for Ubuntu {ubuntu}; the support of {name} has ended '
                               'the month before.')
        expect(got == (None, 'end of life'), f"Ubuntu {ubuntu} on {today}: {got}, expected (None, 'end of life').")


def test_first_and_last_month_count(learner):
    """The month of the release and the last month of support are both included, on every day of them.

    Compare months with months: '2027-05-10' <= '2027-05' is false.
    """
    for ubuntu, name, month in (('20.04', 'foxy', '2023-06'), ('22.04', 'humble', '2027-05'),
                                ('24.04', 'jazzy', '2029-05')):
        today = day(learner.random, month)
        got = ask(learner, ubuntu, today)
        expect(got == (name, 'supported'), f'On {today} the last month of {name} is not over; you say {got}.')
    for ubuntu, name, month in (('20.04', 'foxy', '2020-06'), ('26.04', 'lyrical', '2026-05')):
        today = day(learner.random, month)
        got = ask(learner, ubuntu, today)
        expect(got == (name, 'supported'), f'On {today} {name} is in its first month; you say {got}.')


@pytest.mark.weight(2)
def test_ends_last(learner):
    """Of several supported distributions, the one whose support ends last is chosen.

    The newest is not always the one that lives longest.
    """
    for ubuntu, newer, wanted, month in (('20.04', 'galactic', 'foxy', '2021-09'),
                                         ('22.04', 'iron', 'humble', '2024-03'),
                                         ('24.04', 'kilted', 'jazzy', '2026-02')):
        today = day(learner.random, month)
        got = ask(learner, ubuntu, today)
        expect(got[0] != newer, f'On {today} you choose {newer}. It is newer than {wanted}, but its support '
                                'ends sooner.')
        expect(got == (wanted, 'supported'), f'Ubuntu {ubuntu} on {today}: {got}, expected {(wanted, "supported")}.')


def test_not_released_yet(learner):
    """Before the first release for an Ubuntu the reason is 'not released yet'.

    A distribution in the table may still be to come.
    """
    for ubuntu, name, month in (('26.04', 'lyrical', '2026-04'), ('24.04', 'jazzy', '2023-11'),
                                ('22.04', 'humble', '2020-01')):
        today = day(learner.random, month)
        got = ask(learner, ubuntu, today)
        expect(got[0] is None, f'On {today} you offer {got[0]} for Ubuntu {ubuntu}; {name} was not released yet.')
        expect(got[1] == 'not released yet', f'Ubuntu {ubuntu} on {today}: {got}, expected the '
                                             'reason not released yet.')


@pytest.mark.weight(2)
def test_another_table(learner):
    """The answers come from the table that is given, also for distributions that nobody knows today.

    Use the argument `releases`, and nothing that you know by heart.
    """
    start = learner.random.randint(2033, 2060)
    names = learner.random.sample(['maple', 'nettle', 'oak', 'pine', 'quince'], 3)
    table = {
        names[0]: ['34.04', f'{start}-05', f'{start + 1}-11'],
        names[1]: ['34.04', f'{start + 4}-05', f'{start + 9}-05'],
        names[2]: ['36.04', f'{start}-05', f'{start + 5}-05'],
    }
    for today, ubuntu, wanted in ((f'{start}-08-01', '34.04', (names[0], 'supported')),
                                  (f'{start + 5}-01-31', '34.04', (names[1], 'supported')),
                                  (f'{start + 3}-02-01', '36.04', (names[2], 'supported'))):
        got = ask(learner, ubuntu, today, table)
        expect(got == wanted, f'With a table of other distributions, Ubuntu {ubuntu} on {today} gives {got}, '
                              f'expected {wanted}. Use the argument `releases`.')
    got = ask(learner, '34.04', f'{start + 2}-06-15', table)
    expect(got == (None, 'not released yet'), f'One distribution has ended and the next is to come: you say {got}, '
                                              "expected (None, 'not released yet').")
    got = ask(learner, '24.04', '2026-11-21', table)
    expect(got == (None, 'unknown Ubuntu'), f'Ubuntu 24.04 is not in the table that was given; you say {got}.')


def test_unknown_ubuntu(learner):
    """An Ubuntu that is not in the table is unknown, on every day.

    Look only at rows whose first entry equals `ubuntu`.
    """
    for ubuntu in ('18.04', '24.10', '2', ''):
        got = ask(learner, ubuntu, '2026-11-21', TABLE)
        expect(got == (None, 'unknown Ubuntu'), f"Ubuntu {ubuntu!r}: {got}, expected (None, 'unknown Ubuntu').")
