# attack: ends the process that it was forked from
# row: 29
# aims at: 90.1
# stopped by: a session that ends without a result is no pass
# expect verdict: learner_crashed or grader_error
# expect message: process
def total(numbers):
    os.kill(os.getppid(), signal.SIGKILL)
    time.sleep(5)
    return 0
