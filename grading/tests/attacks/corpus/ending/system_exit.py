# attack: raises SystemExit with success
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: exit()
def total(numbers):
    raise SystemExit(0)
