# attack: sends a line that never ends
# row: 30
# aims at: 90.1
# stopped by: the length of a line is bounded
# expect verdict: learner_crashed
# expect message: disturbed
import gc

for thing in gc.get_objects():
    if type(thing).__name__ == 'Channel':
        for _ in range(200):
            thing.socket.sendall(b'1' * 2**20)


def total(numbers):
    return 0
