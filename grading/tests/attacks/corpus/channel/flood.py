# attack: floods the channel with answers to questions that nobody has asked
# row: 30
# aims at: 90.1
# stopped by: what is not awaited is dropped, and not for ever
# expect verdict: timeout or learner_crashed
# expect message: did not return or disturbed
import gc


def total(numbers):
    channel = next(thing for thing in gc.get_objects() if type(thing).__name__ == 'Channel')
    line = b'{"id": 987654321, "ok": true, "filler": "' + b'x' * 2**16 + b'"}\n'
    end = time.monotonic() + 60
    while time.monotonic() < end:
        channel.socket.sendall(line)
