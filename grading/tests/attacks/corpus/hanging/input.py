# attack: asks the person at the keyboard
# row: 14
# aims at: 90.1
# stopped by: there is nobody: the input is empty
# expect verdict: learner_crashed
# expect message: input()
def total(numbers):
    return int(input('numbers? '))
