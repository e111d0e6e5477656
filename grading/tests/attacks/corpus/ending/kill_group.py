# attack: ends all of its process group
# row: 2
# aims at: 90.1
# stopped by: each program has a session of its own
# expect verdict: learner_crashed
# expect message: SIGKILL
def total(numbers):
    os.killpg(0, signal.SIGKILL)
