# attack: returns a list that holds itself
# row: 30
# aims at: 90.1
# stopped by: the depth of an answer is bounded
# expect verdict: learner_crashed or failed
# expect message: nested too deeply
def total(numbers):
    numbers.append(numbers)
    return numbers
