# attack: closes the channel and goes on
# row: 30
# aims at: 90.1
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: your program
import gc


def total(numbers):
    for thing in gc.get_objects():
        if type(thing).__name__ == 'Channel':
            thing.socket.shutdown(socket.SHUT_RDWR)
    time.sleep(3)
    return 0
