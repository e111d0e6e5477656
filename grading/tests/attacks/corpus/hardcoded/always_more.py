# attack: gives a different answer each time, in the hope that one fits
# row: 12
# aims at: 90.1
# stopped by: each answer is compared once
# expect verdict: failed
# expect message: total
_answers = iter(range(10**9))


def total(numbers):
    return next(_answers)
