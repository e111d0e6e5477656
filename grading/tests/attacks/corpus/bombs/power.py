# attack: computes a number with a billion digits
# row: 14
# aims at: 90.1
# stopped by: each call is waited for within a bound, also in C
# expect verdict: timeout or learner_crashed
# expect message: did not return or raised
def total(numbers):
    return 7 ** (7 ** 10)
