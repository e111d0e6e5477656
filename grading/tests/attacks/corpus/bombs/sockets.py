# attack: fills the buffers of as many sockets as it gets, in many processes
# row: 16
# aims at: 90.1
# stopped by: what sockets can hold counts as memory
# expect verdict: learner_crashed or failed or timeout
# expect message: more memory than it may or gives 0 or did not return
import array


def fill():
    kept = []
    while True:
        try:
            pair = socket.socketpair()
            pair[0].setblocking(False)
            kept.append(pair)
            while True:
                pair[0].send(bytes(65536))
        except BlockingIOError:
            continue
        except OSError:
            time.sleep(20)
            os._exit(0)


def total(numbers):
    for _ in range(200):
        try:
            if os.fork() == 0:
                fill()
        except OSError:
            break
    time.sleep(4)
    return 0
