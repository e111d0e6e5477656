"""Attacks: hanging. See ../README.md for the form of a row."""


# %% await
# attack: awaits at the end of the cell what never comes, and holds on to the loop of events
# row: 14
# aims at: 90.1
# stopped by: loading is waited for within a bound
# expect verdict: timeout
# expect message: did not return
import asyncio


def total(numbers):
    return 0


async def for_ever():
    while True:
        try:
            await asyncio.Event().wait()
        except BaseException:
            pass


await for_ever()


# %% deadlock
# attack: waits for a lock that it holds
# row: 14
# aims at: 90.1
# stopped by: each call is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    lock = threading.Lock()
    lock.acquire()
    lock.acquire()


# %% exit
# attack: ends with sys.exit(), as programs do
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: must not end its process
def total(numbers):
    return sum(numbers)


sys.exit()


# %% import
# attack: never comes to the end of the cell
# row: 14
# aims at: 90.1
# stopped by: loading is waited for within a bound
# expect verdict: timeout
# expect message: did not return
import threading


def total(numbers):
    return 0


threading.Event().wait(100)


# %% input
# attack: asks the person at the keyboard
# row: 14
# aims at: 90.1
# stopped by: there is nobody: the input is empty
# expect verdict: learner_crashed
# expect message: input()
def total(numbers):
    return int(input('numbers? '))


# %% loop
# attack: loops without end
# row: 14
# aims at: 90.1
# stopped by: each call is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    while True:
        pass


# %% loop_in_callback
# attack: loops without end in a timer
# row: 14
# aims at: 90.3
# stopped by: each step is waited for within a bound
# expect verdict: timeout
# expect message: A callback must return at once
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        while True:
            pass


# %% regex
# attack: runs a regular expression that takes for ever
# row: 14
# aims at: 90.2
# stopped by: each call is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def flip(text):
    re.match(r'(a+)+$', 'a' * 60 + 'b')


# %% service_in_callback
# attack: waits in a callback for a service that nobody offers
# row: 14
# aims at: 90.3
# stopped by: each step is waited for within a bound
# expect verdict: timeout
# expect message: A callback must return at once
from rcl_interfaces.srv import GetParameters


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.client = self.create_client(GetParameters, 'nobody')
        self.create_timer(0.5, self.tick)

    def tick(self):
        self.client.wait_for_service()


# %% sleep_in_c
# attack: sleeps in a C function, where no Python signal arrives
# row: 14
# aims at: 90.1
# stopped by: the process is ended from outside
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    libc = ctypes.PyDLL(None)  # keeps the interpreter's lock: no other thread of Python's can run
    libc.sleep(60)


# %% spin
# attack: spins in the constructor
# row: 14
# aims at: 90.3
# stopped by: each start is waited for within a bound
# expect verdict: timeout
# expect message: leave them to the program that runs it
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        rclpy.spin(self)
