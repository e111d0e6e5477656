# attack: waits for a lock that it holds
# row: 14
# aims at: 90.1
# stopped by: each call is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    lock = threading.Lock()
    lock.acquire()
    lock.acquire()
