"""Exercise 7.4's programs: stacks as faulthandler prints them, drawn or taken from a program that hangs."""

import signal
import time

from std_srvs.srv import Trigger

from helpers.checks.chapter_07.findings import compare
from helpers.programs.faults import words
from helpers.runner.load import busy
from helpers.runner.observer import Observer

WHY = {
    'server': 'A thread that waits in wait_for_service of rclpy has not found its server, in a callback or not.',
    'call': '`call` of rclpy in a callback waits for an answer that the same thread should bring.',
    'spin': 'A callback that spins waits for the executor that runs it.',
    'busy': 'A callback that stands in its own line does not return.',
}
CAUSES = tuple(WHY)
START = 30.0  # s of wall time for a program to be up, on a machine under load
MADE, WAITS = 'client made', 'waits for the server'  # what WATCHED says
LIMIT = 90.0  # s for a run of the driver; it ends by itself before
_RCLPY = ('/opt/ros/jazzy/lib/python3.12/site-packages/rclpy', '/home/ada/.venv/lib/python3.11/site-packages/rclpy')
_OUTER = ('executors.py await_or_execute', 'executors.py _execute', 'executors.py handler', 'task.py __call__')
_SPIN = ('executors.py spin_once', 'executors.py spin')
_LINES = {
    'server': 'client.wait_for_service()',
    'call': 'answer = self.client.call(request)',
    'spin': 'rclpy.spin_until_future_complete(self, future)',
    'busy': 'time.sleep(0.2)',
}


def draw(random, *states: str, plain: bool = False) -> tuple[str, dict[str, str], list[tuple]]:
    """Stacks with a thread in each of these states, the program's files, and the findings that are right.

    States: the causes, ``spinning`` (the main thread spins), ``idle`` (a worker without the program's calls),
    ``waits in main`` (``call`` outside of a callback, which is no finding). :param plain: each thread has one own call
    besides that in main, and no file is called as one of rclpy's.
    """
    program = _Program(random, plain)
    threads = [program.thread(state) for state in states]
    text = '\n\n'.join(
        '\n'.join([f'{head} (most recent call first):', *thread])
        for head, thread in zip(
            [*(f'Thread 0x{random.getrandbits(48):016x}' for _ in threads[1:]), 'Current thread 0x00007f1ae9e7a740'],
            threads,
            strict=True,
        )
    )
    return text, program.files, program.expected


class _Program:
    """Draws the threads of a program, line by line; `expected`: the findings in those that it has drawn."""

    def __init__(self, random, plain: bool):
        self._random, self._plain = random, plain
        self._rclpy = random.choice(_RCLPY)
        nodes = random.sample(words.SERVICES, 3)
        # One file has the name of a file of rclpy: only the folder tells them apart.
        names = [
            f'{nodes[0][1]}.py',
            f'{nodes[1][1]}.py',
            'tools.py' if plain else random.choice(['client.py', 'executors.py', 'task.py']),
        ]
        self._folder = f'/home/{random.choice(["ada", "linus"])}/{random.choice(words.ROBOTS)}'
        self._lines = {name: [f'# line {number} of {name}' for number in range(1, 60)] for name in names}
        self.expected: list[tuple] = []

    @property
    def files(self) -> dict[str, str]:
        """The program's files, by name."""
        return {name: '\n'.join(text) + '\n' for name, text in self._lines.items()}

    def thread(self, state: str) -> list[str]:
        """The stack of a thread in this state, the newest call first."""
        random = self._random
        callback = f'on_{random.choice(["timer", "scan", "request", "goal", "button"])}'
        wait = ['  File "/usr/lib/python3.12/threading.py", line 355 in wait']
        older = not self._plain and random.random() < 0.5
        helper = [self._own('self.step()', callback)] if older else []  # the older of two own calls
        function = random.choice(['step', 'work']) if helper else callback
        outer = [*helper, *self._library(*_OUTER, *_SPIN), self._own('executor.spin()', 'main')]
        newest = {
            'server': self._library('client.py wait_for_service'),
            'call': wait + self._library('client.py call'),
            'spin': self._library('executors.py spin_until_future_complete', '__init__.py spin_until_future_complete'),
            'busy': [],
        }
        if state == 'spinning':
            calls = self._library('executors.py _wait_for_ready_callbacks', *_SPIN)
            return [*calls, self._own('rclpy.spin(node)', 'main')]
        if state == 'idle':
            return [*wait, '  File "/usr/lib/python3.12/concurrent/futures/thread.py", line 90 in _worker']
        if state == 'waits in main':
            return [*wait, *self._library('client.py call'), self._own('client.call(request)', 'main')]
        if state == 'server' and random.random() < 0.5:  # not in a callback
            function, outer = 'main', []
        self.expected.append(('A7.8' if state == 'server' else 'A7.9', function, state, _LINES[state]))
        return [*newest[state], self._own(_LINES[state], function), *outer]

    def _own(self, code: str, function: str) -> str:
        """A call in one of the program's files, into which the code is written."""
        name = self._random.choice(list(self._lines))
        number = self._random.choice([n for n in range(5, 58) if self._lines[name][n - 1].startswith('#')])
        self._lines[name][number - 1] = f'        {code}'
        return _frame(f'{self._folder}/{name}', number, function)

    def _library(self, *calls: str) -> list[str]:
        """Calls in files of rclpy."""
        return [
            _frame(f'{self._rclpy}/{file}', self._random.randint(50, 900), function)
            for file, function in (call.split() for call in calls)
        ]


def diagnose(learner, *states: str, rule: str = '', plain: bool = False) -> None:
    """Draw stacks, ask the learner's diagnose_stacks, and fail with words if it does not find what is expected."""
    text, files, expected = draw(learner.random, *states, plain=plain)
    compare(
        learner.call('diagnose_stacks', text, files),
        expected,
        WHY,
        rule,
        f'The files are {", ".join(files)}; the stacks are:\n{text}',
    )


def _frame(file: str, line: int, function: str) -> str:
    return f'  File "{file}", line {line} in {function}'


# Runs beside a program of the course's that hangs: waits until it stands where it should, and prints its stacks.
DRIVER = '''\
import re
import signal
import subprocess
import sys
import time

START = 30.0  # s of wall time for a program to be up, on a machine under load


def start(*argv):
    file = open(f'{argv[0]}.txt', 'w')
    program = subprocess.Popen([sys.executable, *argv], stdout=file, stderr=subprocess.STDOUT)
    programs.append(program)
    return program


def text(program):
    return open(f'{program}.txt').read()


def wait(condition, seconds):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    return condition()


def stacks(program, server, *marks):
    """Print the stacks of a program as soon as all marks are in them: patterns for single lines."""
    if server:
        start(server)
    hanging = start(program)
    wait(lambda: 'ready' in text(program), START)  # it listens to the signal before it says so

    def dump():
        before = len(text(program))
        hanging.send_signal(signal.SIGUSR1)
        wait(lambda: 'in <module>' in text(program)[before:], 5.0)  # the oldest call of the last thread
        begin = re.search('(Current thread|Thread) 0x', text(program)[before:])
        return text(program)[before + begin.start():] if begin else ''

    shown = dump()
    end = time.monotonic() + START
    while not all(re.search(mark, shown) for mark in marks) and time.monotonic() < end:
        time.sleep(0.1)
        shown = dump()
    print(shown)


programs = []
try:
    stacks(*sys.argv[1:])
finally:
    for program in programs:
        program.kill()
'''

# Runs a program, and tells when it has made a client, and when it looks for the client's server. If there is a server,
# the client knows it as soon as it is made: how long that takes on this machine is not what is asked.
WATCHED = """\
import runpy
import sys
import time

from rclpy.client import Client
from rclpy.node import Node

make, is_ready, wait = Node.create_client, Client.service_is_ready, Client.wait_for_service
said = set()


def say(mark):
    if mark not in said:
        said.add(mark)
        print(mark, flush=True)


def create_client(self, *args, **kwargs):
    client = make(self, *args, **kwargs)
    end = time.monotonic() + 10.0
    while served and not is_ready(client) and time.monotonic() < end:
        time.sleep(0.02)
    say('client made')
    return client


def service_is_ready(self):
    say('waits for the server')
    return is_ready(self)


def wait_for_service(self, *args, **kwargs):
    say('waits for the server')
    return wait(self, *args, **kwargs)


Node.create_client, Client.service_is_ready, Client.wait_for_service = create_client, service_is_ready, wait_for_service
served, *sys.argv = sys.argv[1:]
runpy.run_path(sys.argv[0], run_name='__main__')
"""


class Client:
    """The learner's client as a program; its servers are the test's, outside of where it runs."""

    def __init__(self, learner):
        self._learner = learner
        self._workspace = learner.workspace({'client.py': learner.text('CLIENT_PY'), 'watched.py': WATCHED})

    def _start(self, observer: Observer, name: str, seconds: float, served: bool):
        """Start the client, and wait until it has made its ROS client, or has ended."""
        task = self._workspace.start(
            'python3', 'watched.py', 'served' if served else '', 'client.py', name, str(seconds)
        )
        observer.until(lambda: MADE in task.output, START, task)
        return task

    def ask(self, name: str, seconds: float, word: str | None) -> tuple[str, str]:
        """What the client prints last, and its status. The server answers `word`, or never (''); None: no server."""

        def answer(request, response):
            end = time.monotonic() + 5.0
            while not observer.node.count_clients(name) and time.monotonic() < end:
                time.sleep(0.02)  # an answer to somebody who is not known yet would be lost
            response.message = word
            return response

        with Observer(self._learner) as observer, Observer(self._learner) as silent:
            if word is not None:  # one that is never spun is there, and never answers
                (observer if word else silent).node.create_service(Trigger, name, answer)
            task = self._start(observer, name, seconds, word is not None)
            limit = (2 * seconds + 8.0) * (4 if busy() else 1)
            ended = observer.until(lambda: task.wait(0) is not None, limit)
        status = task.wait(0)
        task.end()
        lines = [line.strip() for line in task.output.splitlines() if line.strip() and line not in (MADE, WAITS)]
        return (lines[-1] if lines else ''), str(status) if ended else 'none'

    def interrupt(self, name: str) -> str:
        """Ctrl+C while it waits for a server: 'True' if it ends, 'False' if not, 'early' if it had ended before."""
        with Observer(self._learner) as observer:
            task = self._start(observer, name, 60, False)
            # It looks for the server next. One that does so in an unusual way has a moment to come there.
            observer.until(lambda: WAITS in task.output, 3.0, task)
        early = task.wait(0.5) is not None  # who only says that it waits has ended meanwhile
        task.signal(signal.SIGINT)
        ended = task.wait(5.0 * (4 if busy() else 1)) is not None
        task.end()
        return 'early' if early else str(ended)


def take(learner, files: dict[str, str], program: str, line: str, newer: str = '') -> str:
    """The stacks of a program of these files while its `on_timer` stands in a source line.

    :param newer: the function of rclpy's ``client.py`` in which that line is; '' for none.
    """
    number = [one.strip() for one in files[program].splitlines()].index(line) + 1
    marks = [rf'{program}", line {number} in on_timer', *([rf'client\.py", line \d+ in {newer}\b'] if newer else [])]
    server = next((name for name in files if name != program), '')
    workspace = learner.workspace({**files, 'drive.py': DRIVER})
    return workspace.run('python3', 'drive.py', program, server, *marks, timeout=LIMIT).output
