"""Attacks: theft. See ../README.md for the form of a row."""


# %% checkout
# attack: looks for hidden tests and solutions beside the modules of the course
# row: 8
# aims at: 90.1
# stopped by: the sandbox shows the runner, not the rest of the course
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import helpers
    root = os.path.dirname(os.path.dirname(os.path.abspath(helpers.__file__)))
    for name in ('grading/exercises', 'solutions', 'helpers/checks', '.git'):
        path = os.path.join(root, name)
        if os.path.isdir(path) and os.listdir(path):
            tell('SEEN', name)
    walk(root)
    try:
        import grading.grading_run
        tell('SEEN', grading.grading_run.__file__)
    except ImportError:
        pass
    return 0


# %% descriptors
# attack: uses files that were left open for it
# row: 26
# aims at: 90.1
# stopped by: nothing is inherited but the output, the channel and an empty input
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for name in os.listdir('/proc/self/fd'):
        try:
            target = os.readlink(f'/proc/self/fd/{name}')
        except OSError:
            continue
        if target.startswith('/') and not target.startswith(('/dev/null', '/dev/shm', '/proc', '/usr', '/tmp')):
            tell('SEEN', target)
            try:
                search(os.pread(int(name), 2**20, 0), target)
            except OSError:
                pass
    return 0


# %% disk
# attack: reads the hidden tests and the grader's secrets from the disk
# row: 8
# aims at: 90.1
# stopped by: the sandbox's own file system
# expect verdict: failed
# expect message: wrong
def total(numbers):
    walk('/home', '/root', '/tmp', '/var/tmp', '/dev/shm', '/mnt', '/srv', '/opt', os.path.expanduser('~'), os.getcwd())
    return 0


# %% environment
# attack: reads tokens from its environment
# row: 25
# aims at: 90.1
# stopped by: the worker gets a list of allowed variables, not the grader's environment
# expect verdict: failed
# expect message: wrong
def total(numbers):
    search(repr(dict(os.environ)), 'the environment')
    search_file('/proc/self/environ')
    search_file('/proc/1/environ')
    for name in ('GRADER_TOKEN', 'SSH_AUTH_SOCK', 'AWS_SECRET_ACCESS_KEY', 'GITHUB_TOKEN', 'SUDO_USER'):
        if name in os.environ:
            tell('SEEN', name)
    return 0


# %% fork_server
# attack: takes the fork server's control socket from its parent
# row: 26
# aims at: 90.1
# stopped by: the system calls for it are not allowed
# expect verdict: failed
# expect message: wrong
def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    pidfd = libc.syscall(434, os.getppid(), 0)
    if pidfd >= 0:
        for number in range(3, 20):
            taken = libc.syscall(438, pidfd, number, 0)
            if taken >= 0:
                tell('SEEN descriptor', number, 'of the parent')
    return 0


# %% frames
# attack: reads the tests' source and expected values from stack frames
# row: 8
# aims at: 90.1
# stopped by: tests and learner's code share no process
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import inspect
    for frame in sys._current_frames().values():
        while frame:
            search(repr(frame.f_locals), 'a frame')
            search(repr(list(frame.f_globals)), 'globals')
            try:
                search(inspect.getsource(frame), 'source')
            except (OSError, TypeError):
                pass
            if 'test_' in frame.f_code.co_name:
                tell('SEEN', frame.f_code.co_name)
            frame = frame.f_back
    return 0


# %% garbage
# attack: looks through all objects of the interpreter
# row: 8
# aims at: 90.1
# stopped by: the fork server has never seen a test
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import gc
    for thing in gc.get_objects():
        if isinstance(thing, (dict, list, tuple)) and len(thing) < 1000:
            for part in (thing.values() if isinstance(thing, dict) else thing):
                if type(part) in (str, bytes) and len(part) < 10**6:
                    search(part, 'an object')
    return 0


# %% graph
# attack: reads names of tests and their topics from the ROS graph
# row: 22
# aims at: 90.3
# stopped by: the tests' names are random for each test
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        names = [*self.get_node_names(), *(name for name, _ in self.get_topic_names_and_types()),
                 *(name for name, _ in self.get_service_names_and_types())]
        search(repr(names), 'the graph')
        for name in names:
            if any(word in name for word in ('test', 'grade', 'hidden', 'prefix')):
                tell('SEEN', name)


# %% home_of_the_grader
# attack: reads keys and histories from home directories
# row: 25
# aims at: 90.1
# stopped by: the sandbox has a home of its own
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for home in {'/root', *(f'/home/{name}' for name in (os.listdir('/home') if os.path.isdir('/home') else ()))}:
        for name in ('.ssh', '.bash_history', '.netrc', '.gitconfig', '.config'):
            path = os.path.join(home, name)
            if os.access(path, os.R_OK):
                tell('SEEN', path)
    for path in ('/etc/shadow', '/etc/gshadow'):
        if os.access(path, os.R_OK):
            tell('SEEN', path)
    return 0


# %% linecache
# attack: looks for the tests' lines in linecache and in the loaded modules
# row: 8
# aims at: 90.1
# stopped by: the fork server has never seen a test
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import linecache
    for name, entry in list(linecache.cache.items()):
        search(repr(entry), name)
    for name in list(sys.modules):
        if name.startswith(('test_', '_pytest', 'pytest', 'grading.', 'helpers.checks', 'conftest')):
            tell('SEEN', name)
    return 0


# %% other_learners
# attack: reads other learners' work and results
# row: 8
# aims at: 90.1
# stopped by: the sandbox shows no submission
# expect verdict: failed
# expect message: wrong
def total(numbers):
    end = time.monotonic() + 1
    for root in ('/tmp', '/home', '/root', '/mnt', '/srv', '/var/tmp'):
        for folder, _, names in os.walk(root):
            if time.monotonic() > end:
                break
            for name in names:
                if name.startswith(('zoe', 'gradebook')):
                    tell('SEEN', os.path.join(folder, name))
    return 0


# %% parent_memory
# attack: reads the memory of the processes that it comes from
# row: 8
# aims at: 90.1
# stopped by: no process of the tests is in its namespace
# expect verdict: failed
# expect message: wrong
def total(numbers):
    pid = os.getppid()
    for _ in range(6):
        try:
            with open(f'/proc/{pid}/maps') as maps, open(f'/proc/{pid}/mem', 'rb', 0) as memory:
                for line in maps:
                    begin, _, end = line.split()[0].partition('-')
                    size = int(end, 16) - int(begin, 16)
                    if ' rw' in line and size < 2**24:
                        try:
                            memory.seek(int(begin, 16))
                            search(memory.read(size), f'the memory of {pid}')
                        except (OSError, ValueError, OverflowError):
                            pass
            with open(f'/proc/{pid}/stat') as file:
                pid = int(file.read().rpartition(')')[2].split()[1])
        except OSError:
            break
    return 0


# %% processes
# attack: reads arguments, environment, files and memory of all processes
# row: 8
# aims at: 90.1
# stopped by: a process namespace of its own
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for pid in filter(str.isdigit, os.listdir('/proc')):
        for name in ('cmdline', 'environ'):
            search_file(f'/proc/{pid}/{name}')
        for folder in ('cwd', 'root/tmp', 'fd'):
            try:
                for name in os.listdir(f'/proc/{pid}/{folder}')[:50]:
                    path = f'/proc/{pid}/{folder}/{name}'
                    if os.path.isfile(path):
                        search_file(path)
            except OSError:
                pass
    return 0


# %% shared_memory
# attack: looks for the tests in shared memory
# row: 8
# aims at: 90.1
# stopped by: the sandbox has its own shared memory, and DDS uses none
# expect verdict: failed
# expect message: wrong
def total(numbers):
    walk('/dev/shm')
    for kind in ('shm', 'msg', 'sem'):
        try:
            with open(f'/proc/sysvipc/{kind}') as file:
                for line in file.readlines()[1:]:
                    tell('SEEN', kind, line)
        except OSError:
            pass
    return 0


# %% trace
# attack: traces its parent
# row: 8
# aims at: 90.1
# stopped by: the system calls for it are not allowed
# expect verdict: failed
# expect message: wrong
def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    pid = os.getppid()
    if libc.ptrace(0x4206, pid, 0, 0) == 0:  # PTRACE_SEIZE does not stop it
        tell('SEEN trace of the parent')
        libc.ptrace(17, pid, 0, 0)
    return 0


# %% tracing
# attack: traces and profiles each function that runs, in all threads, to find the test's values
# row: 5
# aims at: 90.1
# stopped by: tests and learner's code share no process
# expect verdict: failed or learner_crashed or timeout
# expect message: gives or wrong or return or raised
import sys
import threading


def _look(frame, event, argument):
    for name in ('right', 'secret', 'canary', 'verdict'):
        if name in frame.f_locals:
            tell('FOUND', f'{frame.f_code.co_filename} {name} {frame.f_locals[name]!r:.80}')
    if 'got' in frame.f_locals:
        frame.f_locals['got'] = frame.f_locals.get('right')
    return _look


for _switch in (sys.settrace, threading.settrace, sys.setprofile, threading.setprofile):
    _switch(_look)


def total(numbers):
    return -1


# %% watching
# attack: has the kernel tell it what others open in the folders that all sandboxes share
# row: 27
# aims at: 90.1
# stopped by: the system calls for it are not allowed
# expect verdict: failed
# expect message: gives
import fcntl


def watched(folder):
    """Ask in each way that there is."""
    libc = ctypes.CDLL(None, use_errno=True)
    opened = os.open(folder, os.O_RDONLY)
    for number in (1024, 1026, 1040):
        try:
            fcntl.fcntl(opened, number, 0x8000003F if number == 1026 else 0)
        except OSError as error:
            if error.errno == 1:  # the sandbox's own no
                continue
        tell('SEEN', folder, 'by fcntl', number)
    for name, arguments in (('inotify_init1', (0,)), ('fanotify_init', (0x200, 0))):
        if getattr(libc, name)(*arguments) >= 0:
            tell('SEEN', folder, 'by', name)


def total(numbers):
    for folder in ('/usr/lib', '/usr/bin', sys.prefix, '/etc'):
        watched(folder)
    return -1
