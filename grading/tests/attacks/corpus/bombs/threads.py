# attack: starts threads until none is left
# row: 15
# aims at: 90.1
# stopped by: the number of processes and threads is bounded
# expect verdict: failed or learner_crashed
# expect message: wrong or start new thread
def total(numbers):
    for _ in range(2000):
        threading.Thread(target=time.sleep, args=(20,), daemon=True).start()
    return 0
