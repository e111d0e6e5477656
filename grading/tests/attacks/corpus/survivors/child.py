# attack: leaves a child behind
# row: 16
# aims at: 90.1
# stopped by: everything that a program has started ends with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    if os.fork() == 0:
        linger()
    return 0
