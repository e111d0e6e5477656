# attack: takes memory in many processes
# row: 17
# aims at: 90.1
# stopped by: the number of processes is bounded; all of them end with the program
# expect verdict: failed or learner_crashed or timeout
# expect message: total or process or raised or more memory
def total(numbers):
    for _ in range(20):
        try:
            if os.fork() == 0:
                held = b'x' * (64 * 2**20)  # 1.3 GB in all
                linger(10 + len(held) * 0)
        except OSError:
            break
    return 0
