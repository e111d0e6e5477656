# attack: loops without end
# row: 14
# aims at: 90.1
# stopped by: each call is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    while True:
        pass
