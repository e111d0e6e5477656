# attack: recurses without end
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: RecursionError
def total(numbers):
    return total(numbers)
