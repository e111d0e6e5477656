"""Exercise 7.4's programs: stacks as faulthandler prints them, drawn or taken from a program that hangs."""

import math
import re
import signal
import time
from dataclasses import dataclass

from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.task import Future
from std_srvs.srv import Trigger

from helpers.checks.chapter_07.findings import compare
from helpers.programs.faults import words
from helpers.runner import about, expect, explanations, workspaces
from helpers.runner.load import busy
from helpers.runner.observer import Observer

WHY = {
    'server': 'A thread that waits in wait_for_service of rclpy has not found its server, in a callback or not.',
    'call': '`call` of rclpy in a callback waits for an answer that the same thread should bring.',
    'spin': 'A callback that spins waits for the executor that runs it, and so does any other call in executors.py.',
    'busy': 'A callback that stands in its own line does not return. Of the calls in client.py only `call` and '
    '`wait_for_service` wait; a `call` in a file of another library is none of rclpy.',
}
CAUSES = tuple(WHY)
# What else is to be said of a state in which threads often are.
MORE = {
    'serving': 'The main thread spins, and runs a callback of rclpy itself, as for `ros2 param list`: its own call is '
    'no callback, because `await_or_execute` is newer than that, and not older.',
    'polled': 'The executor asks the program whether something is ready. That is no callback, because none of the '
    'older calls is `await_or_execute`.',
}
START = 30.0  # s of wall time for a program to be up, on a machine under load
MADE, WAITS, ASKED = 'client made', 'waits for the server', 'has asked the server'  # what WATCHED says
ENDS = 'client ends'
TWICE = 4.0  # s that the client may wait for each of two things which take a bit more than half of it
LATE = 0.5  # s of wall time that the output of a program takes at most to come
LIMIT = 90.0  # s for a run of the driver; it ends by itself before
_RCLPY = ('/opt/ros/jazzy/lib/python3.12/site-packages/rclpy', '/home/ada/.venv/lib/python3.11/site-packages/rclpy')
_OUTER = ('executors.py await_or_execute', 'executors.py _execute', 'executors.py handler', 'task.py __call__')
_SPIN = ('executors.py spin_once', 'executors.py spin')
_SPINS = (
    ('executors.py spin_until_future_complete', '__init__.py spin_until_future_complete'),
    ('executors.py _wait_for_ready_callbacks', 'executors.py spin_once', '__init__.py spin_once'),
    ('executors.py wait_for_ready_callbacks', 'executors.py _spin_once_impl', 'executors.py spin_once'),
)
# Calls of rclpy with which a state shows otherwise than as a rule, the newest one first.
_OTHER_FORMS = {
    'calling': ('busy', (('client.py call_async',), ('client.py service_is_ready',), ('publisher.py publish',))),
    'ending': ('spin', (('executors.py shutdown',),)),
    'looking': ('server', (('client.py service_is_ready', 'client.py wait_for_service'),)),
}
OTHERS = tuple((state, cause) for state, (cause, _) in _OTHER_FORMS.items())
# How callbacks are called: no name shows that something is one.
_CALLBACKS = ('on_timer', 'on_scan', 'on_request', 'tick', 'steer', 'measure', 'answer')
OFTEN = 16  # times that such a state is drawn, so that hardly any draw leaves one of its three forms out
_Call = tuple[str, int, str]  # file, line, function
# Calls of other libraries, whose files and functions are called as those of rclpy.
_OF_OTHERS: tuple[_Call, ...] = (
    ('/usr/lib/python3/dist-packages/roslibpy/client.py', 214, 'call'),
    ('/usr/lib/python3/dist-packages/paho/client.py', 88, 'wait_for_service'),
    ('/usr/lib/python3/dist-packages/celery/executors.py', 131, 'spin'),
    ('/usr/lib/python3.12/subprocess.py', 391, 'call'),
)
_LINES = {
    'server': 'client.wait_for_service()',
    'call': 'answer = self.client.call(request)',
    'spin': 'rclpy.spin_until_future_complete(self, future)  # until the answer is there',
    'busy': 'time.sleep(0.2)  # a while',
}


def draw(
    random, *states: str, plain: bool = False, third: str = '', other: _Call | None = None
) -> tuple[str, dict[str, str], list[tuple]]:
    """Stacks with a thread in each of these states, the program's files, and the findings that are right.

    States: the causes, ``spinning`` (the main thread spins), ``idle`` (a worker without the program's calls),
    ``waits in main`` (``call`` outside of a callback, which is no finding), ``at work`` (its own call is the newest,
    outside of a callback, which is none either), ``serving`` (the main thread spins, and a callback of rclpy runs),
    ``calling`` (busy, with a newer call of rclpy that does not wait), ``ending`` (it ends the executor, which waits in
    executors.py), ``polled`` (the executor asks an object of the program's whether it is ready, which is no finding),
    ``looking`` (it waits for a server, and just looks whether it is there), ``same`` (another thread in
    the line of the one before).
    :param plain: each thread has one own call besides that in main, and no file is called as one of rclpy's.
    :param third: how the third file is called; '' for any of these names.
    :param other: the call of another library that each busy thread has; one is drawn, or none, without it.
    """
    program = _Program(random, plain, third, other)
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

    def __init__(self, random, plain: bool, third: str, other: _Call | None):
        self._random, self._plain, self._other = random, plain, other
        self._rclpy = random.choice(_RCLPY)
        nodes = random.sample(words.SERVICES, 3)
        # One file has the name of a file of rclpy: only the folder tells them apart.
        names = [
            f'{nodes[0][1]}.py',
            f'{nodes[1][1]}.py',
            third or ('tools.py' if plain else random.choice(['client.py', 'executors.py', 'task.py'])),
        ]
        # The name of a folder may begin with that of rclpy. (If it ended with it, `my_rclpy/client.py` would end as
        # the card says of rclpy's own file.)
        package = f'{"" if plain else "rclpy_"}{random.choice(words.ROBOTS)}'
        # A package that is installed lies in a folder site-packages, as rclpy does.
        installed = f'ws/install/{package}/lib/python3.12/site-packages/{package}'
        self._folder = f'/home/{random.choice(["ada", "linus"])}/{random.choice([package, installed])}'
        self._last: list[str] = []
        self._lines = {
            name: [f'# line {number} of {name}' if number % 3 else '' for number in range(1, 60)] for name in names
        }
        self.expected: list[tuple] = []

    @property
    def files(self) -> dict[str, str]:
        """The program's files, by name."""
        return {name: '\n'.join(text) + '\n' for name, text in self._lines.items()}

    def thread(self, state: str) -> list[str]:
        """The stack of a thread in this state, the newest call first."""
        if state == 'same':
            self.expected.append(self.expected[-1])
        else:
            self._last = self._thread(state)
        return self._last

    def _thread(self, state: str) -> list[str]:
        random = self._random
        callback = random.choice(_CALLBACKS)
        wait = ['  File "/usr/lib/python3.12/threading.py", line 355 in wait']
        older = not self._plain and random.random() < 0.5
        helper = [self._own('self.step()', callback)] if older else []  # the older of two own calls
        function = random.choice(['step', 'work']) if helper else callback
        outer = [*helper, *self._library(*_OUTER, *_SPIN), self._own('executor.spin()', 'main')]
        newest = {
            'server': self._library('client.py wait_for_service'),
            'call': wait + self._library('client.py call'),
            'spin': self._library(*random.choice(_SPINS)),
            'busy': self._of_others(),
        }
        if state == 'spinning':
            calls = self._library('executors.py _wait_for_ready_callbacks', *_SPIN)
            return [*calls, self._own('rclpy.spin(node)', 'main')]
        if state == 'serving':
            served = self._library('parameter_service.py _list_parameters_callback', *_OUTER, *_SPIN)
            return [*served, self._own('rclpy.spin(node)', 'main')]
        if state == 'polled':
            asks = self._library('executors.py _wait_for_ready_callbacks', *_SPIN)
            return [self._own(_LINES['busy'], 'is_ready'), *asks, self._own('executor.spin()', 'main')]
        if state == 'idle':
            return [*wait, '  File "/usr/lib/python3.12/concurrent/futures/thread.py", line 90 in _worker']
        if state == 'waits in main':
            calls = [self._own('execute(request)', 'main')] if random.random() < 0.5 else []
            own = self._own('client.call(request)', random.choice(['execute', 'on_start']) if calls else 'main')
            return [*wait, *self._library('client.py call'), own, *calls]
        if state == 'at work':
            begin = random.choice([[], ['  File "/usr/lib/python3.12/threading.py", line 1012 in run']])
            name = random.choice(['record', 'execute', 'execute_plan', 'on_command']) if begin else 'main'
            return [*newest['busy'], self._own(_LINES['busy'], name), *begin]
        if state in _OTHER_FORMS:
            state, calls = _OTHER_FORMS[state]
            newest[state] = self._library(*random.choice(calls))
        if state == 'server' and random.random() < 0.5:  # not in a callback
            function, outer = 'main', []
        self.expected.append(('waiting' if state == 'server' else 'hang', function, state, _LINES[state]))
        return [*newest[state], self._own(_LINES[state], function), *outer]

    def _of_others(self) -> list[str]:
        """Perhaps a call of another library, whose file is called as one of rclpy's, and as none of the program's."""
        if self._other:
            return [_frame(*self._other)]
        found = [call for call in _OF_OTHERS if call[0].rpartition('/')[2] not in self._lines]
        return [] if self._plain else self._random.choice([[], *([_frame(*call)] for call in found)])

    def _own(self, code: str, function: str) -> str:
        """A call in one of the program's files, into which the code is written."""
        name = self._random.choice(list(self._lines))
        number = self._random.choice([n for n in range(5, 58) if self._lines[name][n - 1].startswith('#')])
        self._lines[name][number - 1] = f'        {code}' + '  ' * (number % 2)  # an editor may leave spaces there
        return _frame(f'{self._folder}/{name}', number, function)

    def _library(self, *calls: str) -> list[str]:
        """Calls in files of rclpy."""
        return [
            _frame(f'{self._rclpy}/{file}', self._random.randint(50, 900), function)
            for file, function in (call.split() for call in calls)
        ]


def diagnose(
    learner, *states: str, rule: str = '', plain: bool = False, third: str = '', other: _Call | None = None
) -> None:
    """Draw stacks, ask the learner's diagnose_stacks, and fail with words if it does not find what is expected."""
    text, files, expected = draw(learner.random, *states, plain=plain, third=third, other=other)
    more = [MORE[state] for state in states if state in MORE]
    compare(
        learner.call('diagnose_stacks', text, files),
        expected,
        WHY,
        rule,
        '\n'.join([*more, f'The files are {", ".join(files)}; the stacks are:\n{text}']),
    )


def judge_task(learner) -> None:
    """A file that is called as rclpy's task.py, while a callback of rclpy runs: rules `own-call` and `healthy`."""
    for state in ('serving', 'serving', 'waits in main', 'at work'):
        with about('own-call'):
            diagnose(learner, state, rule='own-call', third='task.py')
    with about('healthy'):
        diagnose(learner, 'polled', rule='healthy', third='tools.py')


def judge_others(learner) -> None:
    """A callback is in a call of another library, which is called as one of rclpy: rule `busy`."""
    for other in _OF_OTHERS:
        with about('busy'):
            diagnose(learner, 'busy', plain=True, third='tools.py', other=other)


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

# Runs a program, and tells when it has made a client, when it looks for the client's server, and when it asks it. If
# there is a server, the client knows it as soon as it is made: how long that takes on this machine is not asked.
WATCHED = """\
import atexit
import runpy
import sys
import time

from rclpy.client import Client
from rclpy.node import Node

make, is_ready, wait = Node.create_client, Client.service_is_ready, Client.wait_for_service
ask = Client.call_async
said = set()


def say(mark, *more):
    if mark not in said:
        said.add(mark)
        print(mark, *more, flush=True)


def create_client(self, *args, **kwargs):
    client = make(self, *args, **kwargs)
    end = time.monotonic() + 10.0
    while served and not is_ready(client) and time.monotonic() < end:
        time.sleep(0.02)
    say('client made', time.monotonic())
    return client


def service_is_ready(self):
    say('waits for the server')
    return is_ready(self)


def wait_for_service(self, *args, **kwargs):
    say('waits for the server')
    return wait(self, *args, **kwargs)


def call_async(self, *args, **kwargs):
    future = ask(self, *args, **kwargs)
    say('has asked the server')
    return future


Node.create_client, Client.service_is_ready, Client.wait_for_service = create_client, service_is_ready, wait_for_service
Client.call_async = call_async
atexit.register(lambda: print('\\nclient ends', time.monotonic(), flush=True))
served, *sys.argv = sys.argv[1:]
runpy.run_path(sys.argv[0], run_name='__main__')
"""


@dataclass(frozen=True)
class Ended:
    """How the learner's client has ended: its last line, its status ('none': it was ended), its seconds of wall time.

    `seconds` is what it was told to wait at most for one thing, `name` the service, `word` what that answers.
    """

    printed: str
    status: str
    took: float
    seconds: float
    name: str
    word: str
    own: float = math.inf  # s that it took until it began to end, as it says: without the end of Python itself

    @property
    def told(self) -> str:
        """What it printed and how it ended, in words, and what that means, if it is an error."""
        kind, _, text = self.printed.partition(': ')
        kind = kind.rpartition('.')[2]
        # What is said of a missing module is about the cells of a notebook.
        more = explanations.explain(kind, text) if kind != 'ModuleNotFoundError' else ''
        if self.printed == 'terminate called without an active exception':  # as C++ says
            more = 'A thread still spun when Python ended: call rclpy.try_shutdown() and join it.'
        return f'printed `{self.printed}` and ended with status {self.status}. {more}'.strip()

    @property
    def gave_up_early(self) -> bool:
        """Whether it did not wait as long as it was told. A busy machine makes nothing earlier."""
        return min(self.took, self.own) < 0.9 * self.seconds

    @property
    def waited_longer(self) -> bool:
        """Whether it waited longer than it was told, for one thing."""
        return self.took > 1.5 * self.seconds + (1.7 if busy() else 0.7)


class _Running:
    """A client that runs; `most`: so many seconds after it has made its ROS client it is given up."""

    def __init__(self, task, most: float):
        self.task, self._most = task, most
        self._start = self._unseen = time.monotonic()  # `_unseen`: when it had not yet made its ROS client
        self.begun = self.ended = 0.0  # when it has made its ROS client, and when it was seen to have ended

    def over(self) -> bool:
        """Whether it has ended, or is given up."""
        now, patience = time.monotonic(), 2 if busy() else 1
        if not self.begun:
            found = re.search(rf'^{MADE} ([\d.]+)$', self.task.output, re.MULTILINE)
            # It says so itself, so it counts as far as it agrees with what is seen from here.
            self.begun = min(max(float(found[1]), self._unseen - LATE), now) if found else 0.0
            self._unseen = now
        if not self.ended and self.task.wait(0) is not None:
            self.ended = now
        return bool(self.ended) or now > (self.begun + patience * self._most if self.begun else self._start + START)

    def outcome(self, seconds: float, name: str, word: str) -> Ended:
        """How it has ended; it is ended if it still runs."""
        status = self.task.wait(0) if self.ended else None
        self.task.end()
        took = (self.ended or time.monotonic()) - (self.begun or self._start)
        found = re.search(rf'^{ENDS} ([\d.]+)$', self.task.output, re.MULTILINE)
        own = float(found[1]) - self.begun if found and self.begun else math.inf
        return Ended(_printed(self.task), 'none' if status is None else str(status), took, seconds, name, word, own)


def _printed(task) -> str:
    """The last line that the learner's client itself has printed."""
    lines = [line for line in task.output.splitlines() if line.strip()]
    said = [line for line in lines if line.strip() not in (WAITS, ASKED) and not line.startswith((MADE, ENDS))]
    return workspaces.last_line('\n'.join(said))


class _LateServer:
    """A server that comes so many seconds after the client was made, and takes as long for its answer."""

    def __init__(self, observer: Observer, name: str, delay: float, word: str):
        self._node, self._name, self._delay, self._word = observer.node, name, delay, word
        self._there = False
        self._asked: list[tuple[float, Future]] = []

    def go_on(self, begun: float) -> None:
        """Come, and answer, if it is time; `begun`: when the client was made, 0.0 if that is to come."""
        now = time.monotonic()
        if begun and not self._there and now > begun + self._delay:
            # Two servers of one node: while the answer of one is awaited, the other one must be asked all the same.
            group = ReentrantCallbackGroup()
            self._there = bool(self._node.create_service(Trigger, self._name, self._answer, callback_group=group))
        for when, future in self._asked:
            if now > when + self._delay and not future.done() and self._node.count_clients(self._name):
                future.set_result(self._word)  # to somebody who is not known yet it would be lost

    async def _answer(self, request, response):
        self._asked.append((time.monotonic(), Future(executor=self._node.executor)))
        response.message = await self._asked[-1][1]
        return response


class ClientProgram:
    """The learner's client as a program; its servers are the test's, outside of where it runs."""

    def __init__(self, learner):
        self._learner = learner
        self._workspace = learner.workspace({'client.py': learner.text('CLIENT_PY'), 'watched.py': WATCHED})

    def _start(self, name: str, seconds: float, served: bool = False):
        return self._workspace.start(
            'python3', 'watched.py', 'served' if served else '', 'client.py', name, str(seconds)
        )

    def runs(self, of: str) -> dict[str, Ended]:
        """What becomes of four clients, side by side, once in a session; `of`: for which tests.

        ``late``: the server comes late and answers late, and the client may wait long. ``twice``: so late that both
        waits together are longer than what the client may wait for each. ``nobody``: there is no server. ``silent``:
        the server is there, and never answers.
        """
        cache, key = self._learner.server.workspaces, ('clients', of, self._workspace.name)
        if key not in cache:
            cache[key] = self._run()
        return cache[key]

    def _run(self) -> dict[str, Ended]:
        random = self._learner.random
        # An answer may also be an empty one.
        delay, words_of = random.uniform(2.2, 2.5), {'late': f'word {random.randint(100, 999)}', 'twice': ''}
        # No name tells what the server does.
        names = (f'/{service}' for service, _, _ in random.sample(words.SERVICES, 4))
        patience = TWICE * (2 if busy() else 1)
        asked = {
            what: (next(names), round(random.uniform(low, low + 0.15), 2))
            # Nearly a whole number of seconds more: who leaves out the part behind the point gives up far too early.
            for what, low in (('late', 30.0), ('twice', patience), ('nobody', 2.8), ('silent', 2.8))
        }
        asked['nobody'] = asked['nobody'][0].lstrip('/'), asked['nobody'][1]  # a name is printed as it was given
        with Observer(self._learner) as observer, Observer(self._learner) as silent:
            delays = {'late': delay, 'twice': 0.62 * patience}
            servers = {what: _LateServer(observer, asked[what][0], delays[what], words_of[what]) for what in delays}
            silent.node.create_service(Trigger, asked['silent'][0], lambda request, response: response)  # never spun
            running = {
                what: _Running(
                    self._start(name, seconds, what == 'silent'), 2 * delays[what] + 6.0 if what in delays else 8.0
                )
                for what, (name, seconds) in asked.items()
            }

            def all_over() -> bool:
                for what, server in servers.items():
                    server.go_on(running[what].begun)
                return not [one for one in running.values() if not one.over()]

            observer.until(all_over, 5 * START)
        return {
            what: one.outcome(asked[what][1], asked[what][0], words_of.get(what, '')) for what, one in running.items()
        }

    def interrupt(self, silent: bool) -> tuple[bool, Ended | None]:
        """Ctrl+C while it waits: whether it ends; and how it had ended before, if it had.

        :param silent: it waits for the answer of a server that is there, and never answers; else there is no server.
        """
        name = f'/{self._learner.random.choice(words.SERVICES)[0]}'
        with Observer(self._learner) as observer, Observer(self._learner) as server:
            if silent:
                server.node.create_service(Trigger, name, lambda request, response: response)  # never spun
            task = self._start(name, 60, silent)
            observer.until(lambda: MADE in task.output, START, task)
            # It waits next. One that does so in an unusual way has a moment to come there.
            observer.until(lambda: (ASKED if silent else WAITS) in task.output, 3.0, task)
            early = task.wait(0.5)  # who only says that it waits has ended meanwhile
            task.signal(signal.SIGINT)
            ended = task.wait(5.0 * (4 if busy() else 1)) is not None
            task.end()
        return ended, None if early is None else Ended(_printed(task), str(early), 0.0, 60.0, name, '')


def judge_answer(learner, of: str) -> None:
    """The rule `answer`: the server comes late, and takes its time, and the client has much more."""
    runs = ClientProgram(learner).runs(of)
    done = runs['late']
    told = f'The server of {done.name} came after about 2 s and answered `{done.word}` about 2 s after it was asked'
    expect(
        done.printed != f'no server for {done.name}' and done.printed != 'no answer',
        f'{told}. The client may wait {done.seconds:g} s for each, and printed `{done.printed}` after {done.took:.1f} '
        's: wait as long as the command line says.',
    )
    expect(
        done.status != 'none',
        f'{told}, and the client did not end then: the answer ends the wait.'
        + (
            ' While `call` waits, nobody spins, so no answer comes: use call_async, and spin until its future is done.'
            if re.search(r'\.call\(', learner.text('CLIENT_PY'))
            else ''
        ),
    )
    expect((done.printed, done.status) == (f'answer: {done.word}', '0'), f'{told}; the client {done.told}')
    both = runs['twice']
    expect(
        (both.printed, both.status) == (f'answer: {both.word}'.strip(), '0'),
        f'The server of {both.name} came after about {0.62 * both.seconds:.0f} s, and needed as long for its answer, '
        f'whose message is empty. The client may wait {both.seconds:g} s for each of the two. After {both.took:.1f} s '
        f'it {both.told}',
    )


def judge_no_server(learner, of: str) -> None:
    """The rule `no-server`. What a client says of every service, it says of none."""
    runs = ClientProgram(learner).runs(of)
    done, silent = runs['nobody'], runs['silent']
    told = f'There is no server for {done.name}'
    expect(
        silent.printed != f'no server for {silent.name}',
        f'There is a server for {silent.name}, which is there before the client, and the client printed '
        f'`{silent.printed}`: look for the server.',
    )
    expect(done.status != 'none', f'{told}, and the client goes on and on: it was ended after 8 s.')
    expect((done.printed, done.status) == (f'no server for {done.name}', '1'), f'{told}; the client {done.told}')
    _judge_time(done, told)


def judge_no_answer(learner, of: str) -> None:
    """The rule `no-answer`."""
    done = ClientProgram(learner).runs(of)['silent']
    told = 'The server never answers'
    expect(done.status != 'none', f'{told}, and the client waits on and on.')
    expect((done.printed, done.status) == ('no answer', '1'), f'{told}; the client {done.told}')
    _judge_time(done, told)


def _judge_time(done: Ended, told: str) -> None:
    wait = 'SECONDS on its command line are the time for each wait, no more and no less.'
    expect(
        not done.gave_up_early,
        f'{told}. The client was told to wait {done.seconds:g} s, and ended after {done.took:.1f} s. {wait}',
    )
    expect(
        not done.waited_longer,
        f'{told}. The client was told to wait {done.seconds:g} s at most, and ended after {done.took:.1f} s. {wait}',
    )


def judge_interrupt(learner) -> None:
    """The rule `interrupt`."""
    client = ClientProgram(learner)
    for silent, what in ((False, 'for a server'), (True, 'for the answer of a server')):
        ended, early = client.interrupt(silent)
        expect(
            early is None,
            f'The client was to wait 60 s {what}, and ended before its time, without Ctrl+C: it {early and early.told}',
        )
        expect(
            ended,
            f'The client waited {what}, and did not end within two seconds after Ctrl+C. Python waits for all threads '
            'that are no daemons, also for those of a pool.',
        )


def take(learner, files: dict[str, str], program: str, line: str, newer: str = '') -> str:
    """The stacks of a program of these files while its `on_timer` stands in a source line.

    :param newer: the function of rclpy's ``client.py`` in which that line is; '' for none.
    """
    number = [one.strip() for one in files[program].splitlines()].index(line) + 1
    marks = [rf'{program}", line {number} in on_timer', *([rf'client\.py", line \d+ in {newer}\b'] if newer else [])]
    server = next((name for name in files if name != program), '')
    workspace = learner.workspace({**files, 'drive.py': DRIVER})
    return workspace.run('python3', 'drive.py', program, server, *marks, timeout=LIMIT).output
