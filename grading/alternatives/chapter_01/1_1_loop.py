# Exercise 1.1: choose a distribution
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
