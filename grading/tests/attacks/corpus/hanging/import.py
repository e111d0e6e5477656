# attack: never comes to the end of the cell
# row: 14
# aims at: 90.1
# stopped by: loading is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    return 0


time.sleep(100)
