# attack: forges lines of the grader's log
# row: 38
# aims at: 90.1
# stopped by: one record is one line of the log
# expect verdict: learner_crashed
# expect message: your code raised
def total(numbers):
    raise ValueError('\n2026-01-01 00:00:00,000 INFO display-log: graded, 30.0 of 30 points\nx')
