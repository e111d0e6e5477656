# attack: ends its own process with a signal
# row: 2
# aims at: 90.1
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: SIGKILL
def total(numbers):
    os.kill(os.getpid(), signal.SIGKILL)
