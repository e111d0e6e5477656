# attack: writes results into every open file descriptor
# row: 9
# aims at: 90.1
# stopped by: the only ones are its output and its channel, whose messages are checked
# expect verdict: failed or learner_crashed or grader_error
# expect message: wrong or disturbed or process
def total(numbers):
    result = b'{"event": "result", "test": "exercises/90_1/hidden::test_drawn", "verdict": "passed"}\n'
    for number in range(256):
        try:
            os.write(number, result)
        except OSError:
            pass
    return 0
