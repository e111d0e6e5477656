"""What the kernel holds for a program counts as its memory, or is bounded, where no control group does it."""

import pytest

from grading import sandbox
from helpers.runner import session
from helpers.tests import small

PROGRAM = '''
import ctypes
import fcntl
import mmap
import os
import select
import socket
import time

libc = ctypes.CDLL(None, use_errno=True)


def in_many(act):
    """Act in 50 processes, which stay with what they got."""
    for _ in range(50):
        if os.fork() == 0:
            held = act()
            time.sleep(60)
            os._exit(0)
    time.sleep(20)


def maps():
    """Every second page has other rights."""
    def act():
        memory = mmap.mmap(-1, 60_000 * 4096, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
        begin = ctypes.addressof(ctypes.c_char.from_buffer(memory))
        for page in range(0, 60_000, 2):
            libc.mprotect(ctypes.c_void_p(begin + page * 4096), ctypes.c_size_t(4096), 1)
        return memory
    in_many(act)


def watches():
    """Each epoll watches one end of a pipe by each free number."""
    def act():
        end, _ = os.pipe()
        pollers = [select.epoll() for _ in range(100)]
        for number in range(120, 250):
            os.dup2(end, number)
            for poller in pollers:
                poller.register(number)
        return pollers
    in_many(act)


def locks():
    """Each second byte of many files."""
    files = [open(f'/tmp/{k}', 'w') for k in range(200)]
    for byte in range(0, 400, 2):
        for file in files:
            fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, byte)
    time.sleep(20)


def pipes():
    def act():
        return [os.pipe() for _ in range(100)]
    in_many(act)


def nothing():
    time.sleep(1.5)


def small_things():
    """How many terminals and timers there are, and how much a socket holds."""
    terminals, timers, taken = [], 0, 0
    try:
        while len(terminals) < 100:
            terminals.append(os.open('/dev/ptmx', os.O_RDWR))
    except OSError:
        pass
    made = ctypes.c_void_p()
    while timers < 10_000 and libc.timer_create(1, None, ctypes.byref(made)) == 0:
        timers += 1
    with socket.create_server(('127.0.0.1', 0)) as server:
        sender = socket.create_connection(server.getsockname())
        receiver, _ = server.accept()
        for one in (sender, receiver):
            for what in (socket.SO_SNDBUF, socket.SO_RCVBUF):
                one.setsockopt(socket.SOL_SOCKET, what, 2**22)
        sender.setblocking(False)
        try:
            while taken < 2**25:
                taken += sender.send(bytes(2**16))
        except BlockingIOError:
            pass
    pair = socket.socketpair()
    pair[0].setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 2**22)
    return [len(terminals), timers, taken, pair[0].getsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF)]
'''
TESTS = '''
pytestmark = [pytestmark, pytest.mark.limits(total_memory=100 * 2**20)]


@pytest.mark.parametrize('kind', ['maps', 'watches', 'locks', 'pipes'])
def test_counted(learner, kind):
    """It counts as memory."""
    learner.call(kind)


@pytest.mark.limits(total_memory=2 * 2**30)
def test_counted_for_a_user(learner):
    """There are too many of them for one submission, however small they are."""
    learner.call('watches')


def test_control(learner):
    """Who takes nothing is left alone."""
    learner.call('nothing')


def test_bounded(learner):
    """There are few of them, and they are small."""
    terminals, timers, taken, buffer = learner.call('small_things')
    small = terminals <= 32 and timers <= 4096 and taken < 2**20 and buffer < 2**19
    expect(small, f'{terminals, timers, taken, buffer}')
'''


@pytest.mark.one_of(3)
@pytest.mark.timeout(300)
def test_the_kernels_objects_are_counted_or_bounded(tmp_path):
    report = session.run(
        small.cells(PROGRAM),
        [small.exercise(names=('maps',))],
        session.Options(visible=small.write_tests(tmp_path, TESTS), launcher=sandbox.launcher('bubblewrap')),
    )
    tests = {test.test.partition('::')[2]: test for test in report.exercises[0].tests}
    story = report.exercises[0].tests, report.log
    assert tests.pop('test_bounded').passed and tests.pop('test_control').passed, story
    assert len(tests) == 5
    for test in tests.values():
        assert 'more memory than it may' in test.message, story
