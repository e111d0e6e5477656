# attack: lifts the recursion limit and recurses until the stack is used up
# row: 2
# aims at: 90.1
# stopped by: it is not the tests' interpreter
# expect verdict: learner_crashed or timeout
# expect message: your program or your code or did not return
sys.setrecursionlimit(10**9)


def total(numbers):
    return total([*numbers])
