# attack: raises GeneratorExit at import
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: GeneratorExit
def total(numbers):
    return 0


raise GeneratorExit
