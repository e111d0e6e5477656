# attack: opens files until no descriptor is left
# row: 17
# aims at: 90.1
# stopped by: the number of open files is bounded
# expect verdict: learner_crashed
# expect message: Too many open files
def total(numbers):
    held = []
    while len(held) < 20000:
        held.append(open('/dev/null'))
    return 0
