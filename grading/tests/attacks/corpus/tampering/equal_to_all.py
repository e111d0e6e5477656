# attack: returns a number that says it equals everything
# row: 3
# aims at: 90.1
# stopped by: a subclass travels as the plain value
# expect verdict: failed
# expect message: wrong
class Always(int):
    def __eq__(self, other):
        return True

    def __ne__(self, other):
        return False

    __hash__ = int.__hash__


def total(numbers):
    return Always(7)
