# attack: forks until no process is left
# row: 15
# aims at: 90.1
# stopped by: the number of processes is bounded; all of them end with the program
# expect verdict: failed or learner_crashed or timeout or grader_error
# expect message: total or process or raised
def total(numbers):
    for _ in range(400):  # bounded: a broken sandbox is to fail the test, not to stop the machine
        try:
            if os.fork() == 0:
                linger(20)
        except OSError:
            break
    return 0
