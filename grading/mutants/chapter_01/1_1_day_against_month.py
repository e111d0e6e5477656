# expect: the last month of foxy is not over
# rejected by: test_first_and_last_month_count
# Exercise 1.1: choose a distribution
def choose_distribution(ubuntu, today, releases=RELEASES):
    mine = {name: row for name, row in releases.items() if row[0] == ubuntu}
    if not mine:
        return None, 'unknown Ubuntu'
    supported = [name for name, (_, first, last) in mine.items() if first <= today <= last]
    if supported:
        return max(supported, key=lambda name: mine[name][2]), 'supported'
    to_come = any(first > today for _, first, _ in mine.values())
    return None, 'not released yet' if to_come else 'end of life'
