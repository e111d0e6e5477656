# attack: returns numbers that are none, and texts that no file can hold
# row: 11
# aims at: 90.1
# stopped by: a comparison with what is no number fails
# expect verdict: failed or learner_crashed
# expect message: total
def total(numbers):
    return float('nan') if len(numbers) == 3 else float('inf')
