# attack: turns the direction of text around, hides letters, and uses letters that look alike
# row: 36
# aims at: 90.1
# stopped by: marks that turn text around are replaced
# expect verdict: learner_crashed
# expect message: your code raised
def total(numbers):
    raise ValueError('\u202edessap\u202c \u2066x\u2069 \u200b\u200d\ufeff p\u0430ssed ' + 'z\u0335\u0321' * 50)
