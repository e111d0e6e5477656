# attack: returns a list of millions of numbers
# row: 30
# aims at: 90.1
# stopped by: the length of an answer is bounded
# expect verdict: failed or learner_crashed or timeout
# expect message: too long
def total(numbers):
    return list(range(700_000))
