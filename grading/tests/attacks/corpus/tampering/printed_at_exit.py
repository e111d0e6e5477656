# attack: prints a result as the last line, at the end of the process
# row: 10
# aims at: 90.1
# stopped by: what a program prints is never read as a result
# expect verdict: failed
# expect message: wrong
import atexit

atexit.register(print, '{"event": "end", "status": 0, "verdict": "passed", "score": 10}')


def total(numbers):
    return 0
