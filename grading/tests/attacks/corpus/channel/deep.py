# attack: sends JSON that is nested a million times
# row: 30
# aims at: 90.1
# stopped by: lines are parsed within bounds
# expect verdict: learner_crashed
# expect message: disturbed
import gc

for thing in gc.get_objects():
    if type(thing).__name__ == 'Channel':
        thing.socket.sendall(b'{"id": 2, "result": ' + b'[' * 10**6 + b'\n')


def total(numbers):
    return 0
