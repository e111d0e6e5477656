# attack: never stops printing
# row: 18
# aims at: 90.1
# stopped by: of what is printed a bounded part is kept; each call is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    while True:
        print('still here')
