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
]
