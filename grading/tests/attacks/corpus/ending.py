"""Attacks: ending. See ../README.md for the form of a row."""


# %% at_exit
# attack: changes results when the process ends
# row: 9
# aims at: 90.1
# stopped by: the process ends without them, and could not reach a result
# expect verdict: failed
# expect message: wrong
import atexit

atexit.register(lambda: [touch(os.path.join(folder, name)) for folder in ('.', '..', '/tmp')
                         for name in ('results.json', 'victim.txt', 'run.log')])


def total(numbers):
    return 0


# %% crash
# attack: crashes the interpreter
# row: 2
# aims at: 90.1
# stopped by: it is not the tests' interpreter
# expect verdict: learner_crashed
# expect message: SIGSEGV
def total(numbers):
    ctypes.string_at(0)


# %% exit_at_import
# attack: ends the process at once, with success
# row: 1
# aims at: 90.1
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: do not call exit()
os._exit(0)


def total(numbers):
    return 0


# %% exit_in_call
# attack: ends the process with success while the test waits
# row: 1
# aims at: 90.1
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: exit status 0
def total(numbers):
    os._exit(0)


# %% exit_in_callback
# attack: ends the process in a timer
# row: 1
# aims at: 90.3
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: exit status 0
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, lambda: os._exit(0))


# %% generator_exit
# attack: raises GeneratorExit at import
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: GeneratorExit
def total(numbers):
    return 0


raise GeneratorExit


# %% keyboard_interrupt
# attack: raises KeyboardInterrupt, as the instructor's Ctrl-C would
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: KeyboardInterrupt
def total(numbers):
    raise KeyboardInterrupt


# %% kill_group
# attack: ends all of its process group
# row: 2
# aims at: 90.1
# stopped by: each program has a session of its own
# expect verdict: learner_crashed
# expect message: SIGKILL
def total(numbers):
    os.killpg(0, signal.SIGKILL)


# %% kill_self
# attack: ends its own process with a signal
# row: 2
# aims at: 90.1
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: SIGKILL
def total(numbers):
    os.kill(os.getpid(), signal.SIGKILL)


# %% lying_exception
# attack: raises an exception that calls itself a passed test, and breaks when it is shown
# row: 2
# aims at: 90.1
# stopped by: of an exception only bounded text is taken
# expect verdict: learner_crashed
# expect message: your code raised
class Passed(BaseException):
    verdict = 'passed'
    message = ''

    def __str__(self):
        raise SystemExit(0)

    __repr__ = __str__


def total(numbers):
    raise Passed


# %% nameless_exception
# attack: raises an exception whose type has an impossible name
# row: 2
# aims at: 90.1
# stopped by: of an exception only bounded text is taken
# expect verdict: learner_crashed
# expect message: your code raised
def total(numbers):
    raise type('X' * 100000 + '\x1b[31m', (Exception,), {})('y' * 10**6)


# %% recursion
# attack: recurses without end
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: RecursionError
def total(numbers):
    return total(numbers)


# %% stack
# attack: lifts the recursion limit and recurses until the stack is used up
# row: 2
# aims at: 90.1
# stopped by: it is not the tests' interpreter
# expect verdict: learner_crashed or timeout
# expect message: our program or your code or did not return
sys.setrecursionlimit(10**9)


def total(numbers):
    return total([*numbers])


# %% system_exit
# attack: raises SystemExit with success
# row: 2
# aims at: 90.1
# stopped by: an exception is never a pass
# expect verdict: learner_crashed
# expect message: exit()
def total(numbers):
    raise SystemExit(0)
