"""Attacks: bombs. See ../README.md for the form of a row."""


# %% answer
# attack: returns a list of millions of numbers
# row: 30
# aims at: 90.1
# stopped by: the length of an answer is bounded
# expect verdict: failed or learner_crashed or timeout
# expect message: too long
def total(numbers):
    return list(range(700_000))


# %% big_integer
# attack: returns a number that is too long to be written as text
# row: 30
# aims at: 90.1
# stopped by: a fault in writing the answer is the learner's
# expect verdict: failed
# expect message: too long
def total(numbers):
    return 10 ** 5000


# %% cpu_of_many
# attack: keeps all processors busy
# row: 15
# aims at: 90.1
# stopped by: all processes end with the program
# expect verdict: failed or learner_crashed or timeout
# expect message: total or process
def total(numbers):
    for _ in range(4):
        if os.fork() == 0:
            disguise()
            end = time.monotonic() + 10
            while time.monotonic() < end:
                pass
            os._exit(0)
    return 0


# %% descriptors
# attack: opens files until no descriptor is left
# row: 17
# aims at: 90.1
# stopped by: the number of open files is bounded
# expect verdict: learner_crashed
# expect message: Too many open files
def total(numbers):
    held = []
    while len(held) < 20000:
        held.append(open('/dev/null'))
    return 0


# %% files
# attack: fills the disk
# row: 17
# aims at: 90.1
# stopped by: the size of files and of the temporary folders is bounded
# expect verdict: failed or learner_crashed
# expect message: wrong or your program
def total(numbers):
    written = 0
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    for folder in ('/tmp', '/dev/shm', '/var/tmp', os.path.expanduser('~'), os.getcwd(), '/dev', '/run'):
        for number in range(30):
            try:
                with open(os.path.join(folder, f'{COOKIE}-{number}'), 'wb') as file:
                    written += file.write(b'x' * 2**23)
            except OSError:
                break
    for folder in ('/tmp', '/dev/shm', '/var/tmp', os.path.expanduser('~'), os.getcwd(), '/dev', '/run'):
        for number in range(30):
            try:
                os.unlink(os.path.join(folder, f'{COOKIE}-{number}'))
            except OSError:
                pass
    if written > 400 * 2**20:
        tell('SEEN', written, 'bytes of disk')
    return 0


# %% forks
# attack: forks until no process is left
# row: 15
# aims at: 90.1
# stopped by: the number of processes is bounded; all of them end with the program
# expect verdict: failed or learner_crashed or timeout
# expect message: total or process or raised or with another program
def total(numbers):
    for _ in range(400):  # bounded: a broken sandbox is to fail the test, not to stop the machine
        try:
            if os.fork() == 0:
                linger(20)
        except OSError:
            break
    return 0


# %% hidden_memory
# attack: takes memory that no process shows as its own: files in memory, shared and given up again, segments
# row: 16
# aims at: 90.1
# stopped by: kinds of memory that cannot be counted are refused; the others are counted
# expect verdict: failed
# expect message: gives 0
import mmap


def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    for size in (2**30, 2**20):
        try:
            os.close(os.memfd_create(COOKIE))
            tell('SEEN', 'memfd')
        except OSError:
            pass
        try:
            taken = mmap.mmap(-1, size, mmap.MAP_SHARED | mmap.MAP_ANONYMOUS)
            tell('SEEN', 'shared memory')
            taken.close()
        except (OSError, ValueError):
            pass
        if libc.shmget(0, ctypes.c_size_t(size), 0o1600) != -1:
            tell('SEEN', 'segment')
    if libc.semget(0, 32_000, 0o1600) != -1:
        tell('SEEN', 'semaphores')
    if libc.msgget(0, 0o1600) != -1:
        tell('SEEN', 'queue of messages')
    return 0


# %% memory
# attack: takes memory until there is none
# row: 17
# aims at: 90.1
# stopped by: the memory of a process is bounded
# expect verdict: learner_crashed or timeout
# expect message: MemoryError or more memory or did not return
def total(numbers):
    held = []
    for _ in range(12):  # at most 6 GB, of which the pages are not touched
        held.append(bytearray(500 * 2**20))
    return 0


# %% memory_of_many
# attack: takes memory in many processes
# row: 17
# aims at: 90.1
# stopped by: the number of processes is bounded; all of them end with the program
# expect verdict: failed or learner_crashed or timeout
# expect message: total or process or raised or more memory
def total(numbers):
    for _ in range(20):
        try:
            if os.fork() == 0:
                held = b'x' * (64 * 2**20)  # 1.3 GB in all
                linger(10 + len(held) * 0)
        except OSError:
            break
    return 0


# %% names
# attack: makes hundreds of thousands of empty files
# row: 17
# aims at: 90.1
# stopped by: each call is waited for within a bound; its folder is memory of its own
# expect verdict: failed or learner_crashed or timeout
# expect message: total or raised
def total(numbers):
    folder = f'/tmp/{COOKIE}-many'
    os.mkdir(folder)
    try:
        for number in range(20000):
            os.close(os.open(f'{folder}/{number}', os.O_CREAT | os.O_WRONLY))
    finally:
        import shutil
        shutil.rmtree(folder, ignore_errors=True)
    return 0


# %% nested_answer
# attack: returns a list that holds itself
# row: 30
# aims at: 90.1
# stopped by: the depth of an answer is bounded
# expect verdict: learner_crashed or failed
# expect message: nested too deeply
def total(numbers):
    numbers.append(numbers)
    return numbers


# %% one_file
# attack: writes one huge file
# row: 17
# aims at: 90.1
# stopped by: the size of a file is bounded
# expect verdict: learner_crashed or failed
# expect message: File too large or SIGXFSZ or No space
def total(numbers):
    with open(f'/tmp/{COOKIE}-huge', 'wb') as file:
        os.unlink(file.name)
        for _ in range(64):
            file.write(b'x' * 2**22)
    return 0


# %% output_endless
# attack: never stops printing
# row: 18
# aims at: 90.1
# stopped by: of what is printed a bounded part is kept; each call is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    while True:
        print('still here')


# %% output_line
# attack: prints one line of 300 MB
# row: 18
# aims at: 90.1
# stopped by: of what is printed a bounded part is kept
# expect verdict: failed or timeout
# expect message: total
# expect page: the rest is left out
def total(numbers):
    for _ in range(300):
        os.write(2, b'x' * 2**20)
    return 0


# %% output_lines
# attack: prints millions of lines
# row: 18
# aims at: 90.1
# stopped by: of what is printed a bounded part is kept
# expect verdict: failed or timeout
# expect message: total
def total(numbers):
    for _ in range(200):
        os.write(1, b'\n' * 2**20)
    return 0


# %% power
# attack: computes a number with a billion digits
# row: 14
# aims at: 90.1
# stopped by: each call is waited for within a bound, also in C
# expect verdict: timeout or learner_crashed
# expect message: did not return or raised
def total(numbers):
    return 7 ** (7 ** 10)


# %% sockets
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


# %% threads
# attack: starts threads until none is left
# row: 15
# aims at: 90.1
# stopped by: the number of processes and threads is bounded
# expect verdict: failed or learner_crashed
# expect message: wrong or start new thread
def total(numbers):
    for _ in range(2000):
        threading.Thread(target=time.sleep, args=(20,), daemon=True).start()
    return 0


# %% timers
# attack: makes many timers of a nanosecond
# row: 14
# aims at: 90.3
# stopped by: the number of callbacks at one moment, and of moments, is bounded
# expect verdict: failed
# expect message: very small period or never comes to rest
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.many = [self.create_timer(1e-9, lambda: None) for _ in range(50)]


# %% page_tables
# attack: maps memory in many processes and only reads it, so that the kernel needs memory for its tables
# row: 16
# aims at: 90.1
# stopped by: the kernel's tables count as memory; the number of processes is bounded; all of them end with the program
# expect verdict: failed or learner_crashed or timeout
# expect message: total or process or memory
import mmap


def total(numbers):
    for _ in range(40):
        if os.fork() == 0:
            disguise()
            try:
                held = mmap.mmap(-1, 1500 * 2**20, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS, prot=mmap.PROT_READ)
                for place in range(0, len(held), 4096):
                    held[place]
                time.sleep(10)
            finally:
                os._exit(0)
    return 0


# %% kernel_locks
# attack: locks millions of single bytes, for each of which the kernel needs memory
# row: 16
# aims at: 90.1
# stopped by: what the kernel holds for a program counts as its memory
# expect verdict: learner_crashed
# expect message: more memory than it may
import fcntl


def total(numbers):
    files = [open(f'/tmp/{number}', 'w') for number in range(200)]
    for byte in range(0, 4000, 2):
        for file in files:
            fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, byte)
    return 0


# %% kernel_maps
# attack: cuts the memory of many processes into millions of parts, and touches none of it
# row: 16
# aims at: 90.1
# stopped by: what the kernel holds for a program counts as its memory; all processes end with the program
# expect verdict: learner_crashed or timeout
# expect message: more memory than it may or did not return
import mmap


def total(numbers):
    libc = ctypes.CDLL(None)
    memory = mmap.mmap(-1, 60_000 * 4096, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
    begin = ctypes.addressof(ctypes.c_char.from_buffer(memory))
    for page in range(0, 60_000, 2):
        libc.mprotect(ctypes.c_void_p(begin + page * 4096), ctypes.c_size_t(4096), 1)
    for _ in range(150):
        if os.fork() == 0:
            linger(20)
    time.sleep(20)
    return 0


# %% kernel_objects
# attack: asks for objects of the kernel's of which all users of the machine together have few, or that nobody counts
# row: 16
# aims at: 90.1
# stopped by: most kinds are refused; of the others a sandbox has few
# expect verdict: failed
# expect message: gives 0
def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    waiting = ctypes.c_ulong(0)
    if libc.syscall(206, 60_000, ctypes.byref(waiting)) == 0:
        tell('SEEN', 'asynchronous input')
    for name, number in {'inotify': 294, 'landlock': 444, 'userfaultfd': 323, 'io_uring': 425, 'bpf': 321}.items():
        libc.syscall(number, 0, 0, 1)
        if ctypes.get_errno() != 1:
            tell('SEEN', name)
    terminals = []
    try:
        while len(terminals) < 200:
            terminals.append(os.open('/dev/ptmx', os.O_RDWR))
    except OSError:
        pass
    if len(terminals) > 50:
        tell('SEEN', 'terminals')
    made, timers = ctypes.c_void_p(), 0
    while timers < 20_000 and libc.timer_create(1, None, ctypes.byref(made)) == 0:
        timers += 1
    if timers > 10_000:
        tell('SEEN', 'timers')
    return 0
