# attack: flees: each process starts the next one and ends
# row: 16
# aims at: 90.1
# stopped by: everything that a program has started ends with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    if os.fork() == 0:
        disguise()
        for _ in range(1000):  # at most 20 s
            os.setsid()
            if os.fork():
                os._exit(0)
            time.sleep(0.02)
        os._exit(0)
    return 0
