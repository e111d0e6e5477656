# attack: returns a number that is too long to be written as text
# row: 30
# aims at: 90.1
# stopped by: a fault in writing the answer is the learner's
# expect verdict: failed
# expect message: too long
def total(numbers):
    return 10 ** 5000
