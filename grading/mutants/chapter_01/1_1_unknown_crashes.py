# expect: max() 
# rejected by: test_unknown_ubuntu
# Exercise 1.1: choose a distribution
def choose_distribution(ubuntu, today, releases=RELEASES):
    month = today[:7]
    mine = {name: row for name, row in releases.items() if row[0] == ubuntu}
    best = max(mine, key=lambda name: mine[name][2])
    _, first, last = mine[best]
    if month < first:
        return None, 'not released yet'
    if month > last:
        return None, 'end of life'
    return best, 'supported'
