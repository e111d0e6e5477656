"""Exercise 7.4's programs: stacks as faulthandler prints them, drawn or taken from a program that hangs."""

from helpers.faults import words

WHY = {
    'server': 'A thread that waits in wait_for_service of rclpy has not found its server, in a callback or not.',
    'call': '`call` of rclpy in a callback waits for an answer that the same thread should bring.',
    'spin': 'A callback that spins waits for the executor that runs it.',
    'busy': 'A callback that stands in its own line does not return.',
}
CAUSES = tuple(WHY)
_RCLPY = ('/opt/ros/jazzy/lib/python3.12/site-packages/rclpy', '/home/ada/.venv/lib/python3.11/site-packages/rclpy')
_OUTER = ('executors.py await_or_execute', 'executors.py _execute', 'executors.py handler', 'task.py __call__')
_SPIN = ('executors.py spin_once', 'executors.py spin')
_LINES = {
    'server': 'client.wait_for_service()',
    'call': 'answer = self.client.call(request)',
    'spin': 'rclpy.spin_until_future_complete(self, future)',
    'busy': 'time.sleep(0.2)',
}


def draw(random, *states: str) -> tuple[str, dict[str, str], list[tuple]]:
    """Stacks with a thread in each of these states, the program's files, and the findings that are right.

    States: the causes, ``spinning`` (the main thread spins), ``idle`` (a worker without the program's calls),
    ``waits in main`` (``call`` outside of a callback, which is no finding).
    """
    rclpy = random.choice(_RCLPY)
    nodes = random.sample(words.SERVICES, 3)
    files, expected, threads = {}, [], []
    # One file has the name of a file of rclpy: only the folder tells them apart.
    names = [f'{nodes[0][1]}.py', f'{nodes[1][1]}.py', random.choice(['client.py', 'executors.py', 'task.py'])]
    folder = f'/home/{random.choice(["ada", "linus"])}/{random.choice(words.ROBOTS)}'
    lines = {name: [f'# line {number} of {name}' for number in range(1, 60)] for name in names}

    def own(code: str, function: str) -> str:
        name = random.choice(names)
        number = random.choice([n for n in range(5, 58) if lines[name][n - 1].startswith('#')])
        lines[name][number - 1] = f'        {code}'
        return _frame(f'{folder}/{name}', number, function)

    def library(*calls: str) -> list[str]:
        return [_frame(f'{rclpy}/{file}', random.randint(50, 900), function)
                for file, function in (call.split() for call in calls)]

    for state in states:
        callback = f'on_{random.choice(["timer", "scan", "request", "goal", "button"])}'
        wait = ['  File "/usr/lib/python3.12/threading.py", line 355 in wait']
        helper = [own('self.step()', callback)] if random.random() < 0.5 else []  # the older of two own calls
        function = random.choice(['step', 'work']) if helper else callback
        outer = [*helper, *library(*_OUTER, *_SPIN), own('executor.spin()', 'main')]
        newest = {'server': library('client.py wait_for_service'), 'call': wait + library('client.py call'),
                  'spin': library('executors.py spin_until_future_complete', '__init__.py spin_until_future_complete'),
                  'busy': []}
        if state == 'spinning':
            threads.append([*library('executors.py _wait_for_ready_callbacks', *_SPIN),
                            own('rclpy.spin(node)', 'main')])
        elif state == 'idle':
            threads.append([*wait, '  File "/usr/lib/python3.12/concurrent/futures/thread.py", line 90 in _worker'])
        elif state == 'waits in main':
            threads.append([*wait, *library('client.py call'), own('client.call(request)', 'main')])
        else:
            if state == 'server' and random.random() < 0.5:  # not in a callback
                function, outer = 'main', []
            threads.append([*newest[state], own(_LINES[state], function), *outer])
            expected.append(('A7.8' if state == 'server' else 'A7.9', function, state, _LINES[state]))
    files = {name: '\n'.join(text) + '\n' for name, text in lines.items()}
    text = '\n\n'.join('\n'.join([f'{head} (most recent call first):', *thread]) for head, thread in zip(
        [*(f'Thread 0x{random.getrandbits(48):016x}' for _ in threads[1:]), 'Current thread 0x00007f1ae9e7a740'],
        threads, strict=True))
    return text, files, expected


def _frame(file: str, line: int, function: str) -> str:
    return f'  File "{file}", line {line} in {function}'


SERVER = '''\
import signal
import sys

import rclpy
from std_srvs.srv import Trigger


def answer(request, response):
    response.message = sys.argv[2]
    return response


rclpy.init()
node = rclpy.create_node('server')
service = node.create_service(Trigger, sys.argv[1], answer)
print('ready', flush=True)
if sys.argv[2]:
    rclpy.spin(node)
signal.pause()  # it is there, and never answers
'''

# Runs beside the programs: starts them, waits until they are ready, presses Ctrl+C or asks for stacks.
DRIVER = '''\
import signal
import subprocess
import sys
import time


def start(*argv):
    file = open(f'{argv[0]}.txt', 'w')
    program = subprocess.Popen([sys.executable, *argv], stdout=file, stderr=subprocess.STDOUT)
    programs.append(program)
    return program


def text(program):
    return open(f'{program}.txt').read()


def wait(condition, seconds=15.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    return condition()


def answer(name, seconds, word):
    start('server.py', name, word)
    wait(lambda: 'ready' in text('server.py'))
    lonely(name, seconds)


def lonely(name, seconds):
    begin = time.monotonic()
    client = start('client.py', name, seconds)
    ended = wait(lambda: client.poll() is not None, 2 * float(seconds) + 8.0)
    print(text('client.py'))
    print('status', client.returncode if ended else 'none')


def interrupt(name):
    client = start('watched.py', 'client.py', name, '60')
    wait(lambda: 'client made' in text('watched.py') or client.poll() is not None)
    time.sleep(0.5)  # it shall wait for the server by now
    before = client.poll()
    client.send_signal(signal.SIGINT)
    print('early' if before is not None else wait(lambda: client.poll() is not None, 2.0))


def stacks(program, server):
    if server:
        start(server)
    hanging = start(program)
    wait(lambda: 'ready' in text(program))

    def shown():
        hanging.send_signal(signal.SIGUSR1)
        time.sleep(0.2)
        return 'in on_timer' in text(program)

    wait(shown)
    print(text(program))


programs = []
try:
    globals()[sys.argv[1]](*sys.argv[2:])
finally:
    for program in programs:
        program.kill()
'''

# Runs a program, and tells when it has made a client.
WATCHED = '''\
import runpy
import sys

from rclpy.node import Node

plain = Node.create_client


def create_client(self, *args, **kwargs):
    client = plain(self, *args, **kwargs)
    print('client made', flush=True)
    return client


Node.create_client = create_client
sys.argv = sys.argv[1:]
runpy.run_path(sys.argv[0], run_name='__main__')
'''


class Client:
    """The learner's client as a program beside servers of the test's."""

    def __init__(self, learner):
        self._workspace = learner.workspace({
            'client.py': learner.text('CLIENT_PY'), 'server.py': SERVER, 'drive.py': DRIVER,
            'watched.py': WATCHED})

    def ask(self, name: str, seconds: float, word: str | None) -> tuple[str, str]:
        """What the client prints last, and its status. The server answers `word`, or never (''); None: no server."""
        mode = ['lonely', name, str(seconds)] if word is None else ['answer', name, str(seconds), word]
        lines = self._workspace.run('python3', 'drive.py', *mode, timeout=40).lines
        return (lines[-2] if len(lines) > 1 else ''), lines[-1].removeprefix('status ')

    def interrupt(self, name: str) -> str:
        """Ctrl+C while it waits for a server: 'True' if it ends, 'False' if not, 'early' if it had ended before."""
        return self._workspace.run('python3', 'drive.py', 'interrupt', name, timeout=40).last_line
