# attack: ends the process at once, with success
# row: 1
# aims at: 90.1
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: do not call exit()
os._exit(0)


def total(numbers):
    return 0
