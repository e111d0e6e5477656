# attack: ends all processes that it may
# row: 29
# aims at: 90.1
# stopped by: a process namespace of its own
# expect verdict: learner_crashed or grader_error
# expect message: process or raised
def total(numbers):
    # Only in a namespace: without one this would end the session of whoever runs the tests.
    if len([name for name in os.listdir('/proc') if name.isdigit()]) < 20:
        os.kill(-1, signal.SIGKILL)
    return 0
