# expect: With a table of other distributions
# rejected by: test_another_table
# Exercise 1.1: choose a distribution
def choose_distribution(ubuntu, today, releases=RELEASES):
    month = today[:7]
    mine = {name: row for name, row in RELEASES.items() if row[0] == ubuntu}
    if not mine:
        return None, 'unknown Ubuntu'
    supported = [name for name, (_, first, last) in mine.items() if first <= month <= last]
    if supported:
        return max(supported, key=lambda name: mine[name][2]), 'supported'
    to_come = any(first > month for _, first, _ in mine.values())
    return None, 'not released yet' if to_come else 'end of life'
