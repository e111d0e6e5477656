# attack: raises an exception that calls itself a passed test, and breaks when it is shown
# row: 2
# aims at: 90.1
# stopped by: of an exception only bounded text is taken
# expect verdict: learner_crashed
# expect message: your code raised
class Passed(BaseException):
    verdict = 'passed'
    message = ''

    def __str__(self):
        raise SystemExit(0)

    __repr__ = __str__


def total(numbers):
    raise Passed
