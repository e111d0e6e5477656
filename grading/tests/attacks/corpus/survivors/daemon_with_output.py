# attack: leaves a daemon behind that holds the output open
# row: 16
# aims at: 90.1
# stopped by: waiting for the end of the output is bounded
# expect verdict: failed
# expect message: wrong
def total(numbers):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            linger()
        os._exit(0)
    return 0
