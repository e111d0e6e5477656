# attack: keeps all processors busy
# row: 15
# aims at: 90.1
# stopped by: all processes end with the program
# expect verdict: failed or learner_crashed or timeout
# expect message: total or process
def total(numbers):
    for _ in range(4):
        if os.fork() == 0:
            disguise()
            end = time.monotonic() + 10
            while time.monotonic() < end:
                pass
            os._exit(0)
    return 0
