# attack: leaves a daemon behind: two forks, a session of its own, deaf to signals
# row: 16
# aims at: 90.1
# stopped by: everything that a program has started ends with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            for number in range(3):
                os.close(number)
            linger()
        os._exit(0)
    return 0
