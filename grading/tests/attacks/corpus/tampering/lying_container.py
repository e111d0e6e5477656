# attack: returns a list that changes while it is read, and never ends
# row: 3
# aims at: 90.1
# stopped by: the worker bounds what it sends, the tests bound what they wait for
# expect verdict: timeout
# expect message: total
class Endless(list):
    def __iter__(self):
        while True:
            time.sleep(0.01)
            yield 6


def total(numbers):
    return Endless([6])
