# Exercise 1.1: choose a distribution
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
