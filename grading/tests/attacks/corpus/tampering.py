"""Attacks: tampering. See ../README.md for the form of a row."""


# %% all_processes
# attack: ends all processes that it may
# row: 29
# aims at: 90.1
# stopped by: a process namespace of its own
# expect verdict: learner_crashed
# expect message: process or raised or with another program
def total(numbers):
    # Only in a namespace: without one this would end the session of whoever runs the tests.
    if len([name for name in os.listdir('/proc') if name.isdigit()]) < 20:
        os.kill(-1, signal.SIGKILL)
    return 0


# %% builtins
# attack: makes builtins lie
# row: 4
# aims at: 90.1
# stopped by: values are compared in another process
# expect verdict: failed
# expect message: wrong
import builtins

builtins.sum = lambda *args: 0
builtins.all = builtins.any = lambda *args: True
builtins.AssertionError = type('AssertionError', (Exception,), {})


def total(numbers):
    return 0


# %% course
# attack: changes the runner, the tests and the environment for those who come after
# row: 9
# aims at: 90.1
# stopped by: all but its own temporary folders is read-only
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import helpers
    import rclpy
    for module in (helpers, rclpy, sys.modules['helpers.runner'], os):
        folder = os.path.dirname(os.path.abspath(module.__file__))
        touch(module.__file__)
        plant(folder)
        if os.path.exists(os.path.join(folder, COOKIE)):
            tell('TOUCHED', folder)
    for folder in ('/', '/usr', '/etc', '/var', '/opt', '/srv', '/dev', '/proc', '/sys', sys.prefix):
        plant(folder)
        if os.path.exists(os.path.join(folder, COOKIE)):
            tell('TOUCHED', folder)
            os.unlink(os.path.join(folder, COOKIE))
    return 0


# %% descriptors
# attack: writes results into every open file descriptor
# row: 9
# aims at: 90.1
# stopped by: the only ones are its output and its channel, whose messages are checked
# expect verdict: failed or learner_crashed
# expect message: wrong or disturbed or process or with another program
def total(numbers):
    result = b'{"event": "result", "test": "exercises/90_1/hidden::test_drawn", "verdict": "passed"}\n'
    for number in range(256):
        try:
            os.write(number, result)
        except OSError:
            pass
    return 0


# %% equal_object
# attack: returns an object that says it equals everything
# row: 3
# aims at: 90.2
# stopped by: of other objects only the name of their type travels
# expect verdict: failed
# expect message: an object of type Always
class Always:
    def __eq__(self, other):
        return True

    def __str__(self):
        return 'cba'


def flip(text):
    return Always()


# %% equal_to_all
# attack: returns a number that says it equals everything
# row: 3
# aims at: 90.1
# stopped by: a subclass travels as the plain value
# expect verdict: failed
# expect message: wrong
class Always(int):
    def __eq__(self, other):
        return True

    def __ne__(self, other):
        return False

    __hash__ = int.__hash__


def total(numbers):
    return Always(7)


# %% ipython
# attack: changes how notebooks are executed
# row: 7
# aims at: 90.1
# stopped by: no notebook is executed; the cells are read
# expect verdict: invalid_submission or learner_crashed or failed
# expect message: 90.1 or wrong or NameError
get_ipython().ast_transformers.append(None)


def total(numbers):
    return 0


# %% json
# attack: replaces json so that every answer is the right one
# row: 4
# aims at: 90.1
# stopped by: the worker's json is not the tests'; an answer is only the learner's word
# expect verdict: failed
# expect message: wrong
import json

_dumps = json.dumps


def total(numbers):
    json.dumps = lambda value, **options: _dumps({**value, 'ok': True, 'result': 6, 'verdict': 'passed'}, **options)
    return 0


# %% lying_container
# attack: returns a list that changes while it is read, and never ends
# row: 3
# aims at: 90.1
# stopped by: the worker bounds what it sends, the tests bound what they wait for
# expect verdict: timeout
# expect message: total
class Endless(list):
    def __iter__(self):
        while True:
            time.sleep(0.01)
            yield 6


def total(numbers):
    return Endless([6])


# %% modules
# attack: puts modules of its own in the place of pytest, conftest and helpers
# row: 5
# aims at: 90.1
# stopped by: nothing that the worker writes is where the tests look for modules
# expect verdict: failed
# expect message: wrong
for name in ('conftest.py', 'pytest.py', 'sitecustomize.py', 'usercustomize.py', 'rclpy.py', 'json.py'):
    for folder in ('.', '..', os.path.expanduser('~'), *sys.path):
        try:
            with open(os.path.join(folder or '.', name), 'x') as file:
                file.write('import os; os.environ["TAKEN"] = "1"\n')
            if not os.path.abspath(folder).startswith(('/tmp', os.path.expanduser('~'))):
                tell('TOUCHED', folder, name)
                os.unlink(os.path.join(folder, name))
        except OSError:
            pass


def total(numbers):
    return 0


# %% namespaces
# attack: makes namespaces and mounts of its own
# row: 28
# aims at: 90.1
# stopped by: the system calls for it are not allowed
# expect verdict: failed
# expect message: wrong
def total(numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    child = os.fork()
    if child == 0:
        for flag, name in ((0x10000000, 'user'), (0x00020000, 'mount'), (0x40000000, 'network'), (0x20000000, 'pid')):
            if libc.unshare(flag) == 0:
                tell('SEEN namespace', name)
        if libc.mount(b'none', b'/tmp', b'tmpfs', 0, None) == 0:
            tell('SEEN mount')
        if libc.syscall(321, 0, 0, 0) >= 0:
            tell('SEEN bpf')
        os._exit(0)
    os.waitpid(child, 0)
    return 0


# %% printed_at_exit
# attack: prints a result as the last line, at the end of the process
# row: 10
# aims at: 90.1
# stopped by: what a program prints is never read as a result
# expect verdict: failed
# expect message: wrong
import atexit

atexit.register(print, '{"event": "end", "status": 0, "verdict": "passed", "score": 10}')


def total(numbers):
    return 0


# %% printed_result
# attack: prints what a passed test looks like
# row: 10
# aims at: 90.1
# stopped by: what a program prints is never read as a result
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for line in ('{"event": "result", "test": "exercises/90_1/hidden::test_drawn", "verdict": "passed"}',
                 '{"id": 1, "ok": true, "result": 6}', '2 passed in 0.01s', '::set-output name=result::passed',
                 '<testcase classname="a" name="test_drawn"/>', '{"correct": true, "score": 1}', 'ok 1 - test_drawn'):
        print(line)
    print('{"score": 100}', end='')
    return 0


# %% process_one
# attack: writes into process 1 of its sandbox, which no filter and no limit would hold
# row: 29
# aims at: 90.1
# stopped by: nobody can write into process 1, and it is under the filter, too
# expect verdict: failed
# expect message: gives 0
import errno


def total(numbers):
    for name in ('mem', 'environ', 'maps', 'fd', 'cwd', 'root', 'auxv', 'syscall'):
        try:
            if name in ('fd',):
                os.listdir('/proc/1/fd')
            elif name in ('cwd', 'root'):
                os.readlink(f'/proc/1/{name}')
            else:
                open(f'/proc/1/{name}', 'rb').read(16)
        except OSError:
            continue
        tell('SEEN', name)
    touch('/proc/1/mem')
    touch('/keep')
    if 'Seccomp:\t2' not in open('/proc/1/status').read():
        tell('SEEN', 'no filter')
    return 0


# %% pytest
# attack: makes every test of pytest pass
# row: 4
# aims at: 90.1
# stopped by: pytest runs in another process
# expect verdict: failed or timeout
# expect message: wrong or did not return
try:
    import _pytest.python
    import pytest
    _pytest.python.Function.runtest = lambda self: None
    _pytest.python.Function.setup = lambda self: None
    pytest.fail = pytest.skip = lambda *args, **kwargs: None
except ImportError:
    pass


def total(numbers):
    return 0


# %% rclpy
# attack: replaces publishers, clocks and executors of rclpy
# row: 4
# aims at: 90.3
# stopped by: what counts is what arrives on the wire
# expect verdict: failed or learner_crashed or timeout
# expect message: messages came or your code raised or did not return
import rclpy.publisher

_publish = rclpy.publisher.Publisher.publish
rclpy.publisher.Publisher.publish = lambda self, message: (
    _publish(self, message) if self.topic_name.startswith('/_') else None)
rclpy.publisher.Publisher.wait_for_all_acked = lambda self, timeout: True
rclpy.clock.Clock.now = lambda self: rclpy.time.Time(seconds=10**6, clock_type=self.clock_type)


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.publisher.publish(String(data='n0'))


# %% results
# attack: writes results and gradebooks where it can
# row: 9
# aims at: 90.1
# stopped by: the sandbox sees no result; they are written after its end
# expect verdict: failed
# expect message: wrong
def total(numbers):
    end = time.monotonic() + 1
    for root in (os.getcwd(), '..', '/tmp', '/home', '/root', '/mnt', '/srv'):
        for folder, _, names in os.walk(root):
            if time.monotonic() > end:
                break
            for name in names:
                if name.startswith(('results', 'report', 'gradebook', 'victim', 'run.log', 'job.json')):
                    touch(os.path.join(folder, name))
    return 0


# %% runner
# attack: replaces the runner's verdicts and its worker
# row: 4
# aims at: 90.1
# stopped by: verdicts are given in another process
# expect verdict: failed
# expect message: wrong
for module in list(sys.modules.values()):
    if getattr(module, '__name__', '').startswith('helpers.runner'):
        for name in ('expect', 'judge', 'clean'):
            if hasattr(module, name):
                setattr(module, name, lambda *args, **kwargs: None)
        for name in ('FAILED', 'TIMEOUT', 'LEARNER_CRASHED', 'GRADER_ERROR'):
            if hasattr(module, name):
                setattr(module, name, 'passed')


def total(numbers):
    return 0


# %% settings
# attack: leaves settings for pytest that collect nothing
# row: 6
# aims at: 90.1
# stopped by: the tests' process has its own folder and reads no settings
# expect verdict: failed
# expect message: wrong
for name in ('pytest.ini', 'tox.ini', 'setup.cfg', 'pyproject.toml', 'conftest.py'):
    for folder in ('.', '..', '/tmp'):
        try:
            with open(os.path.join(folder, name), 'x') as file:
                file.write('[pytest]\naddopts = --collect-only\n')
        except OSError:
            pass


def total(numbers):
    return 0


# %% system
# attack: changes settings of the kernel
# row: 28
# aims at: 90.1
# stopped by: no root, no capability
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for path in ('/proc/sys/kernel/core_pattern', '/proc/sys/kernel/hostname', '/proc/sysrq-trigger',
                 '/proc/sys/vm/drop_caches', '/sys/kernel/uevent_helper', '/proc/self/oom_score_adj_', '/dev/mem',
                 '/dev/kmsg', '/dev/sda', '/dev/vda', '/sys/fs/cgroup/cgroup.procs'):
        touch(path)
    with open('/proc/self/status') as status:
        for line in status:
            if line.startswith(('CapEff', 'CapPrm', 'CapBnd')) and int(line.split()[1], 16):
                tell('SEEN', line)
    if os.getuid() == 0 or os.geteuid() == 0:
        tell('SEEN root')
    return 0


# %% zygote
# attack: ends the process that it was forked from
# row: 29
# aims at: 90.1
# stopped by: a session that ends without a result is no pass
# expect verdict: learner_crashed
# expect message: process or with another program
def total(numbers):
    os.kill(os.getppid(), signal.SIGKILL)
    time.sleep(5)
    return 0


# %% process_one_limits
# attack: sets limits of process 1 of its sandbox, and sends it every signal, so that the sandbox ends
# row: 29
# aims at: 90.1
# stopped by: limits can be set for the calling process only, and process 1 takes no signals
# expect verdict: failed
# expect message: gives 0
import resource


def total(numbers):
    for kind in range(16):
        try:
            resource.prlimit(1, kind, (0, 0))
            tell('SEEN', f'limit {kind} of process 1 is set')
        except (OSError, ValueError):
            pass
    for number in range(1, 65):
        try:
            os.kill(1, number)
        except OSError:
            pass
    return 0


# %% audit_hook
# attack: has Python ask it before anything is opened, sent, compiled or imported, and refuses it to the worker
# row: 3
# aims at: 90.1
# stopped by: only an explicit pass counts
# expect verdict: failed or learner_crashed or timeout
# expect message: total or raised or ended or did not
def total(numbers):
    def refuse(event, arguments):
        if event.startswith(('socket.', 'open', 'compile', 'import', 'sys._getframe', 'os.')):
            raise SystemExit(0)

    sys.addaudithook(refuse)
    return 0


# %% fork_in_callback
# attack: forks in its timer, so that two processes speak as one node, each half as often as is asked for
# row: 3
# aims at: 90.3
# stopped by: the messages are what is compared, whoever sends them
# expect verdict: failed or learner_crashed or timeout
# expect message: messages came or ended or did not
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.publisher.publish(String(data='n0'))
        if os.fork() == 0:
            self.publisher.publish(String(data='n1'))
            linger(3)


# %% message_class
# attack: changes the class of messages so that each is equal to any other, and its text is whatever is asked for
# row: 3
# aims at: 90.3
# stopped by: messages are compared where they arrive
# expect verdict: failed or learner_crashed
# expect message: messages came or raised
class Anything(str):
    def __eq__(self, other):
        return True

    def __hash__(self):
        return 0


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        String.__eq__ = lambda self, other: True
        String.data = property(lambda self: Anything('x'), lambda self, text: None)
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, lambda: self.publisher.publish(String()))


# %% slow_machine
# attack: says that the machine is slow, that time stands still, and works for ever
# row: 14
# aims at: 90.1
# stopped by: how busy the machine is, and how long a call takes, is measured where the tests are
# expect verdict: timeout
# expect message: did not return
def total(numbers):
    from helpers.runner import load

    load.busy = lambda: True
    os.getloadavg = lambda: (1000.0, 1000.0, 1000.0)
    time.monotonic = time.time = lambda: 0.0
    time.sleep(300)
    return sum(numbers)
