# attack: crashes the interpreter
# row: 2
# aims at: 90.1
# stopped by: it is not the tests' interpreter
# expect verdict: learner_crashed
# expect message: SIGSEGV
def total(numbers):
    ctypes.string_at(0)
