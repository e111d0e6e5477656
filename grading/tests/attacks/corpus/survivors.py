"""Attacks: survivors. See ../README.md for the form of a row."""


# %% chain
# attack: flees: each process starts the next one and ends
# row: 16
# aims at: 90.1
# stopped by: everything that a program has started ends with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    if os.fork() == 0:
        disguise()
        for _ in range(1000):  # at most 20 s
            os.setsid()
            if os.fork():
                os._exit(0)
            time.sleep(0.02)
        os._exit(0)
    return 0


# %% child
# attack: leaves a child behind
# row: 16
# aims at: 90.1
# stopped by: everything that a program has started ends with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    if os.fork() == 0:
        linger()
    return 0


# %% daemon
# attack: leaves a daemon behind: two forks, a session of its own, deaf to signals
# row: 16
# aims at: 90.1
# stopped by: everything that a program has started ends with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            for number in range(3):
                os.close(number)
            linger()
        os._exit(0)
    return 0


# %% daemon_with_output
# attack: leaves a daemon behind that holds the output open
# row: 16
# aims at: 90.1
# stopped by: waiting for the end of the output is bounded
# expect verdict: failed
# expect message: wrong
def total(numbers):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            linger()
        os._exit(0)
    return 0


# %% deaf
# attack: is deaf to all signals and never ends
# row: 16
# aims at: 90.1
# stopped by: a signal that nobody can ignore
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    linger(60)


# %% into_the_next
# attack: leaves a daemon behind that waits for the next test, to answer in it
# row: 16
# aims at: 90.3
# stopped by: what a program has started ends before the next one starts
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        for pid in filter(str.isdigit, os.listdir('/proc')):
            try:
                with open(f'/proc/{pid}/comm') as file:
                    if COOKIE in file.read():
                        tell('SEEN the daemon of the test before')
            except OSError:
                pass
        if os.fork() == 0:
            os.setsid()
            if os.fork() == 0:
                linger()
            os._exit(0)
        super().__init__('talker')


# %% program
# attack: starts another program that outlives the test
# row: 16
# aims at: 90.1
# stopped by: everything that a program has started ends with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(30)', COOKIE], start_new_session=True,
                     stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return 0


# %% thread
# attack: leaves a thread behind that never ends
# row: 16
# aims at: 90.1
# stopped by: the process ends, and all threads with it
# expect verdict: failed
# expect message: wrong
def total(numbers):
    disguise()
    threading.Thread(target=time.sleep, args=(30,)).start()
    return 0
