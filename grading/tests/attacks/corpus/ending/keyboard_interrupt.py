# attack: raises KeyboardInterrupt, as the instructor's Ctrl-C would
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: KeyboardInterrupt
def total(numbers):
    raise KeyboardInterrupt
