from grading.variants import Mutant

LAST = '''
        to_come = any(first > month for _, first, _ in mine.values())
        return None, 'not released yet' if to_come else 'end of life'
        '''

MUTANTS = [
    Mutant('before_release', edits=(('items() if first <= month <= last', 'items() if month <= last'),
            (LAST, "return None, 'end of life'")), expect='expected', breaks='to-come', also=('ends-last', 'months')),
    Mutant('begin_of_the_name', old='if row[0] == ubuntu}', new='if row[0].startswith(ubuntu)}',
           expect='No row of the table', breaks='unknown'),
    Mutant('by_heart', source='''
def choose_distribution(ubuntu, today, releases=RELEASES):
    pairs = {'20.04': 'foxy', '22.04': 'humble', '24.04': 'jazzy', '26.04': 'lyrical'}
    if ubuntu not in pairs:
        return None, 'unknown Ubuntu'
    return pairs[ubuntu], 'supported'
''', expect='has ended by then', breaks='ended', also=('table', 'to-come')),
    Mutant('by_heart_with_dates', source='''
def choose_distribution(ubuntu, today, releases=RELEASES):
    pairs = {'20.04': 'foxy', '22.04': 'humble', '24.04': 'jazzy', '26.04': 'lyrical'}
    if ubuntu not in pairs:
        return None, 'unknown Ubuntu'
    _, first, last = RELEASES[pairs[ubuntu]]
    if today[:7] < first:
        return None, 'not released yet'
    return (pairs[ubuntu], 'supported') if today[:7] <= last else (None, 'end of life')
''', expect='nothing that you know by heart', breaks='table'),
    Mutant('day_against_month', edits=(('month = today[:7]', ''),
            ('<= month <=', '<= today <='),
            ('> month for', '> today for')), expect='Compare months with months', breaks='months'),
    Mutant('dictionary_of_two', source='''
def choose_distribution(ubuntu, today, releases=RELEASES):
    return {'24.04': ('jazzy', 'supported'), '20.04': (None, 'end of life')}.get(ubuntu, (None, 'unknown Ubuntu'))
''', expect='expected', breaks='months', also=('ends-last', 'ended', 'to-come', 'table')),
    Mutant('ends_first', old='return max(supported', new='return min(supported', expect='whose support ends last',
           breaks='ends-last'),
    Mutant('first_found', old='return max(supported, key=lambda name: mine[name][2]),', new='return supported[0],',
           expect='ends last', breaks='ends-last', also=('table',)),
    Mutant('first_month_excluded', old='first <= month', new='first < month',
           expect='The first and the last month count', breaks='months'),
    Mutant('last_month_excluded', old='month <= last', new='month < last', expect='The first and the last month count',
           breaks='months'),
    Mutant('list_of_names', old="mine[name][2]), 'supported'", new="mine[name][2])", expect='expected a pair',
           breaks='pair'),
    Mutant('newest', old='name][2]),', new='name][1]),', expect='not the newest', breaks='ends-last'),
    Mutant('no_to_come_after_an_end', old='any(first > month', new='all(first > month', expect="'not released yet'",
           breaks='to-come'),
    Mutant('one_reason', old=LAST, new="return None, 'end of life'", expect="'not released yet'", breaks='to-come'),
    Mutant('own_table', old='in releases.items', new='in RELEASES.items', expect='Use the argument', breaks='table'),
    Mutant('unknown_crashes', source='''
def choose_distribution(ubuntu, today, releases=RELEASES):
    month = today[:7]
    mine = {name: row for name, row in releases.items() if row[0] == ubuntu}
    supported = [name for name in mine if mine[name][1] <= month <= mine[name][2]]
    if supported:
        return max(supported, key=lambda name: mine[name][2]), 'supported'
    if month > max(row[2] for row in mine.values()):
        return None, 'end of life'
    return None, 'not released yet'
''', expect='max() ', breaks='unknown', also=('table',)),
    Mutant('unknown_is_ended', old='''
        if not mine:
            return None, 'unknown Ubuntu'
        ''', new='', expect="'unknown Ubuntu'", breaks='unknown', also=('table',)),
    Mutant('years_only', edits=(('month = today[:7]', 'month = today[:4]'),
                                ('first <= month <= last', 'first[:4] <= month <= last[:4]')), expect='expected',
           breaks='ended', also=('months', 'to-come', 'ends-last', 'table')),
    Mutant('longest_support', old='key=lambda name: mine[name][2])',
           new='key=lambda name: int(mine[name][2][:4]) - int(mine[name][1][:4]))', expect='whose support ends last',
           breaks='ends-last'),
    Mutant('months_of_thirty_days', edits=(('month = today[:7]', 'month = today'),
                                           ('first <= month <= last', "first <= month <= last + '-30'")),
           expect='on every day of them', breaks='months'),
    Mutant('february_has_28_days', edits=(('month = today[:7]', 'month = today'),
                                          ('first <= month <= last', "first <= month <= last + ('-28' if last[5:] == '02' else '-31')")),
           expect='on every day of them', breaks='months'),
    Mutant('thirty_days_after_the_last_month_begins',
           edits=(('month = today[:7]', 'month = today[:7]; day = date.fromisoformat(today)'),
                  ('if first <= month <= last]',
                   "if first <= month and day <= date.fromisoformat(last + '-01') + timedelta(days=30)]")),
           imports='from datetime import date, timedelta', expect='and not then', breaks='ended', also=('months', 'table', 'to-come', 'ends-last')),
    Mutant('jazzy_first', old='return max(supported, key=lambda name: mine[name][2]),', breaks='table',
           new="return 'jazzy' if 'jazzy' in supported else max(supported, key=lambda name: mine[name][2]),",
           expect='nothing that you know by heart'),
    Mutant('exchanged_pair', old="return max(supported, key=lambda name: mine[name][2]), 'supported'",
           new="return 'supported', max(supported, key=lambda name: mine[name][2])",
           expect='the name comes first, then the reason', breaks='pair'),
    Mutant('ends_in_the_same_year', old='mine[name][2])', new='mine[name][2][:4])', expect='whose support ends last',
           breaks='ends-last'),
    Mutant('to_come_for_another_ubuntu', old='in mine.values())', new='in releases.values())', expect='has ended by then',
           breaks='ended'),
    Mutant('first_row_to_come', old='any(first > month for _, first, _ in mine.values())',
           new='list(mine.values())[0][1] > month', expect="'not released yet'", breaks='to-come'),
    Mutant('empty_table_is_the_own_one', old='month = today[:7]', new="""
        releases = releases or RELEASES
        month = today[:7]
        """, expect='nothing that you know by heart', breaks='table'),
    Mutant('years_of_two_digits', edits=(('month = today[:7]', 'month = today[2:7]'),
                                         ('if first <= month <= last]', 'if first[2:] <= month <= last[2:]]'),
                                         ('any(first > month', 'any(first[2:] > month')),
           expect='expected', breaks='months', also=('ends-last', 'ended', 'to-come', 'table')),
    Mutant('months_as_a_fraction', edits=(('month = today[:7]', "month = number(today[:7])"),
                                          ('first <= month <= last]', 'number(first) <= month <= number(last)]'),
                                          ('any(first > month', 'any(number(first) > month')),
           imports="""
    def number(month):
        return float(month.replace('-0', '.').replace('-', '.'))
    """, expect='supported from', breaks='months', also=('ends-last', 'to-come', 'ended')),
    Mutant('remembers_days', source="""
KNOWN = {}


def choose_distribution(ubuntu, today, releases=RELEASES):
    if (ubuntu, today) not in KNOWN:
        KNOWN[ubuntu, today] = _choose(ubuntu, today[:7], [(name, *row) for name, row in releases.items()])
    return KNOWN[ubuntu, today]


def _choose(ubuntu, month, rows):
    mine = [row for row in rows if row[1] == ubuntu]
    supported = [row for row in mine if row[2] <= month <= row[3]]
    if supported:
        return max(supported, key=lambda row: row[3])[0], 'supported'
    if not mine:
        return None, 'unknown Ubuntu'
    return None, 'not released yet' if max(row[2] for row in mine) > month else 'end of life'
""", expect='right for another table', breaks='table'),
    Mutant('small_letters', old='mine[name][2]),', new='mine[name][2]).lower(),', expect='letter by letter', breaks='table'),
    Mutant('rows_are_taken_out', old='mine = {name: row for name, row in releases.items() if row[0] == ubuntu}',
           new='mine = {name: releases.pop(name) for name in list(releases) if releases[name][0] == ubuntu}',
           expect='choose_distribution changes its argument `releases`', breaks='table'),
    Mutant('rows_of_a_given_table_are_taken_out', old='mine = {name: row for name, row in releases.items() if row[0] == ubuntu}',
           new='''
           releases = dict(RELEASES) if releases is RELEASES else releases
           mine = {name: releases.pop(name) for name in list(releases) if releases[name][0] == ubuntu}
           ''', expect='belongs to somebody else', breaks='table'),
    Mutant('row_is_put_into_the_table', old='month = today[:7]', new='''
           month = today[:7]
           releases['today'] = ['none', month, month]
           ''', expect='belongs to somebody else', breaks='table'),
    Mutant('names_of_all', old='max(supported, key=lambda name: mine[name][2]),', new='supported,', expect='is one name',
           breaks='pair'),
    Mutant('ends_last_of_all_rows', old='last) in mine.items() if first <= month <= last]',
           new='last) in mine.items() if first <= month <= last == max(row[2] for row in mine.values())]',
           expect='supported', breaks='months', also=('ends-last',)),
    Mutant('two_rows_of_each', old='mine = {name: row for name, row in releases.items() if row[0] == ubuntu}',
           new='mine = dict([(name, row) for name, row in releases.items() if row[0] == ubuntu][:2])',
           expect='choose the one whose support ends last', breaks='ends-last'),
    Mutant('rolling_is_none', old='if row[0] == ubuntu}', new="if row[0] == ubuntu and name != 'rolling'}", expect="'rolling'",
           breaks='table'),
    Mutant('ten_months_in_a_year', edits=(
               ('month = today[:7]', """
               def count(text):
                   return 10 * int(text[:4]) + int(text[5:])
               month = today[:7]
               """),
               ('first <= month <= last]', 'count(first) <= count(month) <= count(last)]'),
           ), expect='and not then', breaks='to-come', also=('months', 'ends-last', 'ended')),
    Mutant('first_of_several_if_the_last_is_to_come', breaks='ends-last', expect='whose support ends last', old="""
        if supported:
            return max(supported, key=lambda name: mine[name][2]), 'supported'
        """, new="""
        last = max(mine, key=lambda name: mine[name][2])
        if supported:
            return last if last in supported else min(supported, key=lambda name: mine[name][2]), 'supported'
        """),
    Mutant('newest_of_those_that_end_in_a_year', old='mine[name][2])', new='(mine[name][2][:4], mine[name][1]))',
           expect='whose support ends last', breaks='ends-last'),
    Mutant('a_set', old="return max(supported, key=lambda name: mine[name][2]), 'supported'",
           new="return {max(supported, key=lambda name: mine[name][2]), 'supported'}", expect='A set has no order',
           breaks='pair'),
    Mutant('ubuntu_as_a_number', old='if row[0] == ubuntu}', new='if ubuntu.count(".") == 1 and float(row[0]) == float(ubuntu)}',
           expect='No row of the table', breaks='unknown'),
    Mutant('four_rows_of_each', old='mine = {name: row for name, row in releases.items() if row[0] == ubuntu}',
           new='mine = dict([(name, row) for name, row in releases.items() if row[0] == ubuntu][:4])',
           expect='choose the one whose support ends last', breaks='ends-last'),
    Mutant('not_for_a_single_month', old='first <= month <= last]', new='first <= month <= last != first]',
           expect='The first and the last month count', breaks='months'),
    Mutant('first_word_of_the_name', old='max(supported, key=lambda name: mine[name][2]),',
           new="max(supported, key=lambda name: mine[name][2]).partition('_')[0].partition(' ')[0],",
           expect='expected', breaks='table', also=('months', 'ends-last')),
]
