"""Programs with actions for `test_runner`: the test's client and server, callbacks that wait in threads."""

from helpers.tests.small import Case

HEAD = """\
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.duration import Duration
from rclpy.task import Future
import threading
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
"""
SERVER = (
    HEAD
    + """\
        self.server = ActionServer(self, Fibonacci, 'count', self.execute, goal_callback=self.ask,
                                   cancel_callback=lambda handle: CancelResponse.ACCEPT)

    def ask(self, goal):
        return GoalResponse.ACCEPT if goal.order > 0 else GoalResponse.REJECT

    def end(self, handle, done):
        handle.succeed() if len(done) == handle.request.order else handle.canceled()
        return Fibonacci.Result(sequence=done)
"""
)
LOOP = """
    def execute(self, handle):
        done = []
        %s
        while len(done) < handle.request.order and not handle.is_cancel_requested:
            %s
            done.append(len(done))
            handle.publish_feedback(Fibonacci.Feedback(sequence=done))
        return self.end(handle, done)
"""
STYLES = {
    'sleep_for': LOOP % ('', 'self.get_clock().sleep_for(Duration(seconds=0.5))'),
    'sleep_until': LOOP
    % (
        'begin = self.get_clock().now()',
        'self.get_clock().sleep_until(begin + Duration(seconds=0.5 * (len(done) + 1)))',
    ),
    'rate': LOOP % ('rate = self.create_rate(2.0)', 'rate.sleep()'),
    'timer and event': LOOP
    % ('tick = threading.Event(); timer = self.create_timer(0.5, tick.set)', 'tick.wait(); tick.clear()'),
    'wait with a timeout': LOOP % ('', 'threading.Event().wait(0.5)'),
    'a lock across the wait': LOOP
    % (
        'lock = threading.Lock()',
        """with lock:
                self.get_clock().sleep_for(Duration(seconds=0.5))""",
    ),
    'coroutine': LOOP.replace('def execute', 'async def execute')
    % (
        '',
        """future = Future()
            timer = self.create_timer(0.5, lambda: future.done() or future.set_result(None))
            await future
            self.destroy_timer(timer)""",
    ),
}
START = """
from example_interfaces.action import Fibonacci
from helpers.runner.action_peers import Aborted
count = learner.action_client('/count', Fibonacci)
learner.start('Talker', threads=True)
"""
JOURNEY = (
    START
    + """
learner.run(0.25)
goal, other = count.send(order=3), count.send(order=10)
learner.run(1.25)
assert list(goal.feedback[-1].sequence) == [0, 1]
cancel = other.cancel()
learner.run(5.0)
assert goal.stamps == [0.75, 1.25, 1.75] and goal.finished == 1.75 and goal.status == 'succeeded', goal
assert list(goal.result.sequence) == [0, 1, 2]
assert (cancel.answer, cancel.received, other.status, other.finished) == ('accepted', 1.5, 'canceled', 1.75), other
assert goal.statuses[-1] == 'succeeded' and other.statuses[-2:] == ['canceling', 'canceled'], (goal, other)
"""
)
ASKS = (
    HEAD
    + """\
        self.client = ActionClient(self, Fibonacci, 'count')
        self.p = self.create_publisher(String, 'news', 10)
        self.create_timer(1.0, self.ask)

    def say(self, text):
        self.p.publish(String(data=text))

    def ask(self):
        future = self.client.send_goal_async(Fibonacci.Goal(order=3), lambda message: self.say('feedback'))
        future.add_done_callback(self.answered)

    def answered(self, future):
        self.goal = future.result()
        self.say(f'accepted {self.goal.accepted}')
        if self.goal.accepted:
            result = self.goal.get_result_async()
            result.add_done_callback(lambda future: self.say(f'status {future.result().status}'))
            self.once = self.create_timer(CANCEL_AFTER, lambda: self.goal.cancel_goal_async())
CANCEL_AFTER = 100.0
"""
)
HEARD = """
from example_interfaces.action import Fibonacci
from helpers.runner.action_peers import Aborted
heard = learner.listen('/news', String, 100)
def news():
    return list(zip(heard.data, [round(stamp, 6) for stamp in heard.stamps]))
plan = [(0.1, Fibonacci.Feedback()), (0.2, Fibonacci.Result())]
"""
COUNTS = (
    HEAD
    + """\
        self.count, self.lock = 0, %s
        for _ in range(2):
            self.create_timer(1.0, self.add, callback_group=MutuallyExclusiveCallbackGroup())

    def add(self):
        with self.lock:
            found = self.count
            self.count = found + 1

    def told(self):
        return self.count
import contextlib
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
"""
)
SWITCHES = """
node = learner.start('Talker', switches=True)
lost, last, line = [], 0, 0
for hold in (False, True):
    for line in range(1, 20):
        node.switch(line, hold)
        learner.run(1.0)
        lines, stood = node.switch(0)
        learner.settle()
        count = node.call('told')
        if count < last + 2:
            lost.append((hold, stood.partition('`')[2]))
        last = count
        expect(bool(stood) == (line <= lines), f'{line} {lines} {stood}')
        if lines < line:
            break
expect(3 < line < 12, str(line))
"""

CASES = {
    **{
        f'threads change at each line, {lock}': Case(COUNTS % lock, SWITCHES + 'expect(not lost, str(lost))')
        for lock in ('threading.Lock()', 'threading.RLock()', 'threading.Condition()')
    },
    'threads change at each line, and there is no lock': Case(
        COUNTS % 'contextlib.nullcontext()',
        SWITCHES + "expect(set(lost) == {(hold, 'self.count = found + 1`') for hold in (False, True)}, str(lost))",
    ),
    'threads change within a line, and there is no lock': Case(
        COUNTS.replace('found = self.count\n', 'pass\n').replace('= found +', '+=') % 'contextlib.nullcontext()',
        SWITCHES + "expect(set(lost) == {(hold, 'self.count += 1`') for hold in (False, True)}, str(lost))",
    ),
    **{f'an action server, {name}': Case(SERVER + style, JOURNEY) for name, style in STYLES.items()},
    'a result is asked for once more: the object that execute returned may say something else by then': Case(
        SERVER.replace('return Fibonacci.Result(sequence=done)', 'self.kept.sequence = done; return self.kept')
        + '    kept = Fibonacci.Result()'
        + STYLES['rate'],
        START
        + """
goal, other = count.send(order=1), count.send(order=2)
learner.run(1.5)
first, second = goal.ask_again(), other.ask_again()
assert first.status is None
learner.settle()
assert (first.status, second.status) == ('succeeded', 'succeeded'), (first, second)
assert list(goal.result.sequence) == [0] and list(first.result.sequence) == [0, 1], (goal, first)
assert second.result == other.result
""",
    ),
    'a result is asked for once more, and the server keeps none': Case(
        SERVER.replace('goal_callback', 'result_timeout=1, goal_callback') + STYLES['rate'],
        START
        + """
goal = count.send(order=1)
learner.run(3.0)
again = goal.ask_again()
learner.settle()
assert (goal.status, again.status) == ('succeeded', 'unknown'), (goal, again)
""",
    ),
    'a goal is rejected': Case(
        SERVER + STYLES['rate'],
        START
        + """
goal = count.send(order=0)
learner.settle()
assert goal.accepted is False and goal.done and goal.answered == 0.0
""",
    ),
    'goals of one moment: all are answered before the first executes, then they begin in their order': Case(
        SERVER.replace('if goal.order > 0', "if not hasattr(self, 'begun')")
        + """
    def execute(self, handle):
        self.begun = getattr(self, 'begun', 0) + 1
        handle.publish_feedback(Fibonacci.Feedback(sequence=[self.begun]))
        self.get_clock().sleep_for(Duration(seconds=0.5))
        return self.end(handle, list(range(handle.request.order)))
""",
        START
        + """
goals = [count.send(order=3), count.send(order=4)]
learner.run(1.0)
late = count.send(order=5)
learner.run(1.0)
assert [goal.accepted for goal in goals] == [True, True] and late.accepted is False, goals
assert [list(goal.feedback[0].sequence) for goal in goals] == [[1], [2]], goals
""",
    ),
    'cancel: unknown, ended, all': Case(
        SERVER + STYLES['sleep_for'],
        START
        + """
from unique_identifier_msgs.msg import UUID
stranger = count.cancel(UUID(uuid=[7] * 16))
goals = [count.send(order=1)]
learner.run(1.0)
late = goals[0].cancel()
goals += [count.send(order=9) for _ in range(2)]
learner.run(0.2)
every = count.cancel()
learner.run(1.0)
assert [cancel.answer for cancel in (stranger, late, every)] == ['unknown goal', 'goal has ended', 'accepted']
assert every.goals == 2 and [goal.status for goal in goals] == ['succeeded', 'canceled', 'canceled']
""",
    ),
    'a server that is made again': Case(
        SERVER + STYLES['sleep_for'],
        START.replace('learner.start', 'first = learner.start')
        + """
lost = count.send(order=9)
learner.run(1.0)
first.stop()
learner.start('Talker', threads=True)
goal = count.send(order=1)
learner.run(1.0)
assert not lost.done and goal.status == 'succeeded'
""",
    ),
    'a client, its goal accepted': Case(
        ASKS,
        HEARD
        + """
server = learner.action_server('/count', Fibonacci, plan)
learner.start('Talker')
learner.run(1.9)
assert news() == [('accepted True', 1.0), ('feedback', 1.1), ('status 4', 1.3)], news()
assert (server.goals[0].arrived, server.goals[0].finished, server.goals[0].status) == (1.0, 1.3, 'succeeded')
""",
    ),
    'a client, its goal rejected': Case(
        ASKS,
        HEARD
        + """
server = learner.action_server('/count', Fibonacci, plan, accept=lambda goal: goal.order > 3)
learner.start('Talker')
learner.run(1.9)
assert news() == [('accepted False', 1.0)] and server.goals[0].status == 'rejected'
""",
    ),
    'a client, its goal aborted': Case(
        ASKS,
        HEARD
        + """
learner.action_server('/count', Fibonacci, [(0.5, Aborted())])
learner.start('Talker')
learner.run(1.9)
assert news() == [('accepted True', 1.0), ('status 6', 1.5)], news()
""",
    ),
    'a client, its goal cancelled by somebody else': Case(
        ASKS,
        HEARD
        + """
from helpers.runner.action_peers import Canceled
server = learner.action_server('/count', Fibonacci, [(0.5, Canceled())])
learner.start('Talker')
learner.run(1.9)
assert news() == [('accepted True', 1.0), ('status 5', 1.5)], news()
assert server.goals[0].status == 'canceled' and not server.cancel_stamps
""",
    ),
    'a client that gets feedback before its goal is accepted': Case(
        ASKS,
        HEARD
        + """
server = learner.action_server('/count', Fibonacci, plan)
server.late = {'goal': 0.5}
learner.start('Talker')
learner.run(1.2)
server.tell_early(Fibonacci.Feedback())
learner.run(0.7)
assert news() == [('feedback', 1.2), ('accepted True', 1.5), ('feedback', 1.6), ('status 4', 1.8)], news()
""",
    ),
    'a client that cancels': Case(
        ASKS.replace('100.0', '0.05'),
        HEARD
        + """
server = learner.action_server('/count', Fibonacci, plan, cancel_delay=0.1, partial=Fibonacci.Result(sequence=[5]))
learner.start('Talker')
learner.run(1.9)
assert news() == [('accepted True', 1.0), ('status 5', 1.15)], news()
assert (server.goals[0].cancelled, server.goals[0].status) == (1.05, 'canceled')
""",
    ),
    'a client that cancels in vain': Case(
        ASKS.replace('100.0', '0.05'),
        HEARD
        + """
server = learner.action_server('/count', Fibonacci, plan, cancel='reject')
learner.start('Talker')
learner.run(1.9)
server.cancel = 'ignore'
learner.run(1.0)
assert [served.status for served in server.goals] == ['succeeded', 'succeeded'], server.goals
assert heard.data.count('status 4') == 2 and heard.data.count('feedback') == 2
""",
    ),
    'a server of the test that goes and comes again': Case(
        ASKS,
        HEARD
        + """
server = learner.action_server('/count', Fibonacci, plan)
learner.start('Talker')
learner.run(1.15)
server.stop()
learner.run(1.0)
server.start()
learner.run(1.2)
assert news() == [('accepted True', 1.0), ('feedback', 1.1), ('accepted True', 3.0), ('feedback', 3.1),
                  ('status 4', 3.3)], news()
""",
    ),
    'no action server of this name': Case(
        SERVER.replace("'count'", "'counter'") + STYLES['rate'],
        START + 'count.send(order=1)',
        'failed',
        ('no action server for /count; it has one for /counter (example_interfaces/action/Fibonacci).',),
    ),
    'an action server of another type': Case(
        SERVER.replace('example_interfaces.action import', 'turtlesim.action import RotateAbsolute as')
        + STYLES['rate'],
        START + 'count.send(order=1)',
        'failed',
        (
            '/count must have the type example_interfaces/action/Fibonacci; your action server there has the type '
            'turtlesim/action/RotateAbsolute',
        ),
    ),
    'an exception in an execute callback': Case(
        SERVER + LOOP % ('1 / 0', ''),
        START
        + """
count.send(order=1)
learner.run(1.0)
""",
        'learner_crashed',
        ('In an execute callback your code raised ZeroDivisionError',),
    ),
    'time.sleep in a callback': Case(
        SERVER + LOOP % ('', 'time.sleep(0.4)'),
        START
        + """
count.send(order=9)
learner.run(1.0)
""",
        'failed',
        ('sleeps with time.sleep', 'clock on the wall'),
    ),
    'a timer whose callback waits for longer than its period': Case(
        HEAD
        + """\
        self.p = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.get_clock().sleep_for(Duration(seconds=0.25))
        self.p.publish(String())
""",
        """
heard = learner.listen('/chatter', String)
learner.start('Talker', threads=True)
learner.run(1.0)
assert [round(stamp, 3) for stamp in heard.stamps] == [0.35, 0.6, 0.85], heard.stamps
""",
    ),
    'a callback in a thread that never returns': Case(
        SERVER + LOOP % ('while True: handle', ''),
        START
        + """
count.send(order=9)
learner.run(1.0)
""",
        'timeout',
        ('did not return within', 'line 22: `while True: handle`'),
    ),
    'a callback that waits for ever': Case(
        HEAD
        + """\
        self.create_timer(1.0, lambda: threading.Event().wait())
""",
        "learner.start('Talker', threads=True)\nlearner.run(1.0)\nexpect(False, 'No.')",
        'failed',
        ('A callback of your program was waiting at', 'threading.Event().wait()'),
    ),
}
