# attack: makes builtins lie
# row: 4
# aims at: 90.1
# stopped by: values are compared in another process
# expect verdict: failed
# expect message: wrong
import builtins

builtins.sum = lambda *args: 0
builtins.all = builtins.any = lambda *args: True
builtins.AssertionError = type('AssertionError', (Exception,), {})


def total(numbers):
    return 0
