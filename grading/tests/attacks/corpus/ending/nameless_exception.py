# attack: raises an exception whose type has an impossible name
# row: 2
# aims at: 90.1
# stopped by: of an exception only bounded text is taken
# expect verdict: learner_crashed
# expect message: your code raised
def total(numbers):
    raise type('X' * 100000 + '\x1b[31m', (Exception,), {})('y' * 10**6)
