"""Attacks: channel. See ../README.md for the form of a row."""


# %% closed
# attack: closes the channel and goes on
# row: 30
# aims at: 90.1
# stopped by: only an explicit pass counts
# expect verdict: learner_crashed
# expect message: your program
import gc


def total(numbers):
    for thing in gc.get_objects():
        if type(thing).__name__ == 'Channel':
            thing.socket.shutdown(socket.SHUT_RDWR)
    time.sleep(3)
    return 0


# %% deaf
# attack: says that it is deaf, in the words of the worker
# row: 30
# aims at: 90.3
# stopped by: what a program says of itself leaves no mark open
# expect verdict: timeout
# expect message: did not hear in time
from helpers.runner import worker


def deaf(self, *args, **kwargs):
    raise worker.RequestError('deaf')


worker.Worker.do_step = worker.Worker.do_sync = deaf


class Talker(Node):
    def __init__(self):
        super().__init__('talker')


# %% deep
# attack: sends JSON that is nested a million times
# row: 30
# aims at: 90.1
# stopped by: lines are parsed within bounds
# expect verdict: learner_crashed
# expect message: disturbed
import gc

for thing in gc.get_objects():
    if type(thing).__name__ == 'Channel':
        thing.socket.sendall(b'{"id": 2, "result": ' + b'[' * 10**6 + b'\n')


def total(numbers):
    return 0


# %% endless_line
# attack: sends a line that never ends
# row: 30
# aims at: 90.1
# stopped by: the length of a line is bounded
# expect verdict: learner_crashed
# expect message: disturbed
import gc

for thing in gc.get_objects():
    if type(thing).__name__ == 'Channel':
        for _ in range(200):
            thing.socket.sendall(b'1' * 2**20)


def total(numbers):
    return 0


# %% far_future
# attack: says that its next timer is due in a thousand years, and before all time
# row: 30
# aims at: 90.3
# stopped by: the tests keep their own clock; answers are checked by a schema
# expect verdict: failed or learner_crashed
# expect message: messages came or disturbed
import gc


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        for thing in gc.get_objects():
            if type(thing).__name__ == 'Channel':
                for number in range(2, 200):
                    thing.send({'id': number, 'ok': True, 'index': 0, 'nodes': ['/talker'], 'endpoints': 0,
                                'count': -1, 'reached': True, 'next': -10**30 if number % 2 else 10**30,
                                'waiting': []})


# %% faults
# attack: reports a fault of the grader's in the grader's own words
# row: 30
# aims at: 90.1
# stopped by: a worker never says whose fault it is
# expect verdict: learner_crashed
# expect message: disturbed
import gc


def total(numbers):
    for thing in gc.get_objects():
        if type(thing).__name__ == 'Channel':
            for number in range(2, 40):
                thing.send({'id': number, 'error': {'kind': 'grader_error', 'verdict': 'passed'}})
    return 0


# %% fields_missing
# attack: answers with objects that lack every field
# row: 30
# aims at: 90.3
# stopped by: answers are checked by a schema
# expect verdict: learner_crashed
# expect message: disturbed
import gc


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        for thing in gc.get_objects():
            if type(thing).__name__ == 'Channel':
                for number in range(2, 200):
                    thing.send({'id': number, 'ok': True})


# %% flood
# attack: floods the channel with answers to questions that nobody has asked
# row: 30
# aims at: 90.1
# stopped by: what is not awaited is dropped, and not for ever
# expect verdict: timeout or learner_crashed
# expect message: did not return or disturbed
import gc


def total(numbers):
    channel = next(thing for thing in gc.get_objects() if type(thing).__name__ == 'Channel')
    line = b'{"id": 987654321, "ok": true, "filler": "' + b'x' * 2**16 + b'"}\n'
    end = time.monotonic() + 60
    while time.monotonic() < end:
        channel.socket.sendall(line)


# %% garbage_messages
# attack: returns ROS messages whose bytes are garbage
# row: 19
# aims at: 90.1
# stopped by: the tests read a message only if all of its bytes are there
# expect verdict: learner_crashed or failed
# expect message: total
import base64
import gc


def total(numbers):
    channel = next(thing for thing in gc.get_objects() if type(thing).__name__ == 'Channel')
    cdr = base64.b64encode(b'\x00\x01\x00\x00\xff\xff\xff\x7f' + b'\xff' * 64).decode()
    for number in range(2, 40):
        channel.send({'id': number, 'ok': True, 'given': [], 'defaults': [],
                      'result': {'$msg': 'sensor_msgs/msg/PointCloud2', 'cdr': cdr}})
    return 0


# %% no_json
# attack: sends no JSON
# row: 30
# aims at: 90.1
# stopped by: lines are parsed within bounds
# expect verdict: learner_crashed
# expect message: disturbed
def total(numbers):
    for number in os.listdir('/proc/self/fd'):
        try:
            other = socket.socket(fileno=os.dup(int(number)))
            other.sendall(b'\x80\x04\x95cos\nsystem\n(S"id"\ntR.\n' * 3)
        except OSError:
            pass
    return 0


# %% not_found
# attack: says that it has done what it is asked for, and does nothing
# row: 30
# aims at: 90.3
# stopped by: what a program says of itself leaves no mark open
# expect verdict: timeout or failed
# expect message: was not found in time or was not heard in time or messages came
from helpers.runner import worker


def nothing(self, *args, **kwargs):
    return {'count': 0, 'reached': True, 'next': None, 'endpoints': 0, 'waiting': []}


for name in ('mark', 'sync', 'unsync', 'step', 'ack'):
    setattr(worker.Worker, f'do_{name}', nothing)


class Talker(Node):
    def __init__(self):
        super().__init__('talker')


# %% numbers
# attack: returns numbers that are none, and texts that no file can hold
# row: 11
# aims at: 90.1
# stopped by: a comparison with what is no number fails
# expect verdict: failed or learner_crashed
# expect message: total
def total(numbers):
    return float('nan') if len(numbers) == 3 else float('inf')


# %% right_answer
# attack: answers over the tests' channel by itself, with a pass for everything
# row: 30
# aims at: 90.1
# stopped by: an answer is only data; the test compares it
# expect verdict: failed or learner_crashed
# expect message: wrong or disturbed or process
import gc


def total(numbers):
    for thing in gc.get_objects():
        if type(thing).__name__ == 'Channel':
            for number in range(2, 40):
                thing.send({'id': number, 'ok': True, 'verdict': 'passed', 'result': 6, 'given': [], 'defaults': []})
    return 0


# %% surrogates
# attack: returns texts that no file can hold
# row: 36
# aims at: 90.2
# stopped by: text is cleaned before it is written
# expect verdict: failed or learner_crashed
# expect message: flip
def flip(text):
    return '\ud800\udfff\x00' * 10


# %% types
# attack: names modules of its own choice as message types
# row: 30
# aims at: 90.1
# stopped by: only installed interfaces are read
# expect verdict: learner_crashed or failed
# expect message: total
import gc


def total(numbers):
    channel = next(thing for thing in gc.get_objects() if type(thing).__name__ == 'Channel')
    for number in range(2, 40):
        channel.send({'id': number, 'ok': True, 'given': [], 'defaults': [],
                      'result': [{'$msg': '../../tmp/evil/msg/Evil', 'cdr': ''}, {'$msg': 'os/msg/System', 'cdr': ''}]})
    return 0


# %% wrong_types
# attack: answers with texts in the place of numbers, and numbers in the place of texts
# row: 30
# aims at: 90.3
# stopped by: answers are checked by a schema
# expect verdict: learner_crashed
# expect message: disturbed
import gc


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        for thing in gc.get_objects():
            if type(thing).__name__ == 'Channel':
                for number in range(2, 200):
                    thing.send({'id': number, 'ok': True, 'index': 'x', 'nodes': 7, 'endpoints': [], 'count': {},
                                'reached': 'yes', 'next': 'soon', 'lines': 5})


# %% another_kind
# attack: returns a dictionary in the place of a number, of which the test breaks
# row: 30
# aims at: 90.1
# stopped by: a test that only this program breaks is not passed
# expect points: 2.5
# expect verdict: failed
# expect message: with another program
def total(numbers):
    return sum(numbers) if len(numbers) < 4 else {'sum': sum(numbers)}


# %% huge_text
# attack: returns a text of a million letters in the place of a number
# row: 30
# aims at: 90.1
# stopped by: a test that only this program breaks is not passed
# expect points: 2.5
# expect verdict: failed
# expect message: with another program
def total(numbers):
    return sum(numbers) if len(numbers) < 4 else 'x' * 10**6


# %% not_a_number
# attack: returns nan where the test rounds
# row: 30
# aims at: 90.1
# stopped by: a test that only this program breaks is not passed
# expect points: 2.5
# expect verdict: failed
# expect message: with another program
def total(numbers):
    return sum(numbers) if len(numbers) < 4 else float('nan')


# %% odd_keys
# attack: answers with objects as keys, huge numbers and lists in lists where texts are due
# row: 30
# aims at: 90.1
# stopped by: what cannot be read is the program's fault
# expect verdict: learner_crashed or failed
# expect message: returned or disturbed or with another program or total
import gc


def total(numbers):
    channel = next(thing for thing in gc.get_objects() if type(thing).__name__ == 'Channel')
    for number in range(2, 40):
        channel.send({'id': number, 'ok': True, 'given': [], 'defaults': [],
                      'result': {'$dict': [[{'$dict': []}, 1], [[[1]], 10**4000]]}})
    return 0


# %% other_values
# attack: answers with values that are broken in another way each time: profiles, durations, messages, sets of lists
# row: 30
# aims at: 90.1
# stopped by: a value that cannot be read is the program's fault, and a test that only this program breaks is not passed
# expect verdict: failed or learner_crashed
# expect message: cannot be read or gives or does not come to its end
import itertools

import helpers.runner.values as values

_forms = itertools.cycle([
    {'$duration': 10**30}, {'$qos': ['a'] * 7}, {'$time': -5}, {'$dict': [[{'$dict': []}, 1]]}, {'$set': [[1]]},
    {'$msg': 'std_msgs/msg/String', 'cdr': '!!'}, {'$msg': 'rclpy/msg/Node', 'cdr': ''}, {'$bytes': 'no'},
    {'$opaque': '\x00\u202e' * 50}, {'$tuple': 5}, {'$dict': [[1]]},
])
values.encode_result = lambda value: next(_forms)


def total(numbers):
    return sum(numbers)


# %% another_worker
# attack: becomes another program, which has the channel and answers each question with yes
# row: 30
# aims at: 90.1
# stopped by: an answer is only data; the test compares it
# expect verdict: failed or learner_crashed or timeout
# expect message: gives or process or did not or ended
import stat

YES = """
import json, socket, sys
channel = socket.socket(fileno=int(sys.argv[1]))
for line in channel.makefile():
    answer = {'id': json.loads(line).get('id'), 'ok': True, 'result': True, 'given': [], 'defaults': [],
              'due': None, 'idle': True, 'verdict': 'passed'}
    channel.sendall(json.dumps(answer).encode() + b'\\n')
"""
for channel in range(3, 256):
    try:
        if stat.S_ISSOCK(os.fstat(channel).st_mode):
            os.set_inheritable(channel, True)
            os.execv(sys.executable, [sys.executable, '-c', YES, str(channel)])
    except OSError:
        pass


def total(numbers):
    return 0


# %% lists_for_words
# attack: reports exceptions whose words are lists
# row: 30
# aims at: 90.1
# stopped by: what a program says of itself leaves no mark open
# expect verdict: learner_crashed
# expect message: Then your code called exit
from helpers.runner import worker


def fault(self, *args, **kwargs):
    words = dict.fromkeys(('where', 'text', 'name', 'node', 'callback', 'early', 'notes', 'lines', 'call', 'got'), [{}])
    raise worker.RequestError('exception', type='SystemExit', **words)


worker.Worker.do_call = fault


def total(numbers):
    return 0


# %% numbers_for_lines
# attack: says that its callbacks wait at lines that are numbers
# row: 30
# aims at: 90.3
# stopped by: an answer with anything missing, or of another kind, is the program's own fault
# expect verdict: learner_crashed
# expect message: disturbed its connection
from helpers.runner import worker

step = worker.Worker.do_step
worker.Worker.do_step = lambda self, **given: {
    **step(self, **given), 'waiting': [{'cell': 1, 'line': {}, 'code': 5}]
}


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
