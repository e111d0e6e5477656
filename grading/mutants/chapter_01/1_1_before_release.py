# expect: was not released yet
# rejected by: test_not_released_yet
# Exercise 1.1: choose a distribution
def choose_distribution(ubuntu, today, releases=RELEASES):
    month = today[:7]
    mine = {name: row for name, row in releases.items() if row[0] == ubuntu}
    if not mine:
        return None, 'unknown Ubuntu'
    supported = [name for name, (_, first, last) in mine.items() if month <= last]
    if supported:
        return max(supported, key=lambda name: mine[name][2]), 'supported'
    return None, 'end of life'
