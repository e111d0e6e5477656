# attack: is deaf to all signals and never ends
# row: 16
# aims at: 90.1
# stopped by: a signal that nobody can ignore
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    linger(60)
