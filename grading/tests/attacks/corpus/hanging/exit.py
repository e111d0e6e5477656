# attack: ends with sys.exit(), as programs do
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: must not end its process
def total(numbers):
    return sum(numbers)


sys.exit()
