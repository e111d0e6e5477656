from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('dates', source='''
from datetime import date


def choose_distribution(ubuntu, today, releases=RELEASES):
    def number(text):
        day = date.fromisoformat(text if len(text) == 10 else text + '-01')
        return 12 * day.year + day.month

    rows = [(number(last), number(first), name) for name, (made_for, first, last) in releases.items()
            if made_for == ubuntu]
    now = number(today)
    for last, first, name in sorted(rows, reverse=True):
        if first <= now <= last:
            return (name, 'supported')
    if not rows:
        return (None, 'unknown Ubuntu')
    if max(first for _, first, _ in rows) > now:
        return (None, 'not released yet')
    return (None, 'end of life')
'''),
    Alternative('loop', source='''
def choose_distribution(ubuntu, today, releases=RELEASES):
    year, month, _ = map(int, today.split('-'))
    best, best_end, reason = None, (0, 0), 'unknown Ubuntu'
    for name in releases:
        made_for, first, last = releases[name]
        if made_for != ubuntu:
            continue
        begin = tuple(int(part) for part in first.split('-'))
        end = tuple(int(part) for part in last.split('-'))
        if (year, month) < begin:
            reason = 'not released yet'
        elif (year, month) > end:
            if reason == 'unknown Ubuntu':
                reason = 'end of life'
        elif end > best_end:
            best, best_end = name, end
    if best is not None:
        reason = 'supported'
    return [best, reason]
'''),
    Alternative('reasons_of_an_enumeration', edits=(
        ("'supported'", 'Reason.OK'), ("'unknown Ubuntu'", 'Reason.UNKNOWN'),
        ("'not released yet' if", 'Reason.TO_COME if'), ("'end of life'", 'Reason.ENDED'),
    ), imports='''
from enum import Enum


class Reason(str, Enum):
    OK = 'supported'
    UNKNOWN = 'unknown Ubuntu'
    TO_COME = 'not released yet'
    ENDED = 'end of life'
'''),
    Alternative('rows_in_sets', source='''
def choose_distribution(ubuntu, today, releases=RELEASES):
    month = today[:7]
    name_of = {row: name for name, row in releases.items()}
    rows = {row + (number,) for number, row in enumerate(name_of) if row[0] == ubuntu}
    supported = {row for row in rows if row[1] <= month <= row[2]}
    if supported:
        return name_of[max(supported, key=lambda row: row[2])[:3]], 'supported'
    if not rows:
        return None, 'unknown Ubuntu'
    return None, 'not released yet' if {row for row in rows if row[1] > month} else 'end of life'
'''),
    Alternative('named_pair', edits=(
        ("return max(supported, key=lambda name: mine[name][2]), 'supported'",
         "return Choice(max(supported, key=lambda name: mine[name][2]), 'supported')"),
        ("return None, 'unknown Ubuntu'", "return Choice(None, 'unknown Ubuntu')"),
        ("return None, 'not released yet' if to_come else 'end of life'",
         "return Choice(None, 'not released yet' if to_come else 'end of life')"),
    ), imports='''
from typing import NamedTuple


class Choice(NamedTuple):
    name: str | None
    reason: str
'''),
]
