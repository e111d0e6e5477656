"""Common mistakes in the use of rclpy: the learner reads what is wrong, with their own line."""

import re
import sys

import pytest

from helpers.exercises.notebooks import NotebookCell
from helpers.runner import session
from helpers.runner.mistakes import MistakeWatch
from helpers.tests import small

HEAD = """\
from rclpy.action import ActionServer, ActionClient, GoalResponse
from example_interfaces.action import Fibonacci
from std_srvs.srv import Trigger
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import SingleThreadedExecutor
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.client = self.create_client(Trigger, 'ask')
        self.timer = self.create_timer(0.5, self.tick)
"""
RUN = '''
def test_run(learner):
    """It runs."""
    from std_srvs.srv import Trigger
    learner.serve('/ask', Trigger, {'success': True})
    learner.start('Talker')
    learner.run(1.2)
    expect(False, 'It came to its end.')
'''


def judge(folder, source, test=RUN, **options):
    options = session.Options(visible=small.write_tests(folder, test), **options)
    report = session.run(small.cells(source), [small.exercise()], options)
    assert not report.log
    return report.exercises[0].tests[0]


@pytest.mark.one_of(5)
@pytest.mark.parametrize(
    'line',
    [
        'rclpy.spin_until_future_complete(self, self.client.call_async(Trigger.Request()), timeout_sec=1.0)',
        'rclpy.spin_until_future_complete(self, self.client.call_async(Trigger.Request()))',
        'rclpy.spin_once(self, timeout_sec=0.1)',
        'rclpy.spin(self)',
        'self.executor.spin_once(timeout_sec=0.1)',
        'SingleThreadedExecutor().spin_once(timeout_sec=0.1)',
        'self.client.call(Trigger.Request(), timeout_sec=1.0)',
        'self.client.call(Trigger.Request())',
        "ActionClient(self, Fibonacci, 'count').send_goal(Fibonacci.Goal())",
    ],
)
@pytest.mark.parametrize('kind', ['def', 'async def'])
def test_a_wait_in_a_callback_is_named(tmp_path, line, kind):
    """With a timeout and without, in a plain callback and in a coroutine, and not hidden by a broad except."""
    test = judge(
        tmp_path,
        f'{HEAD}\n    {kind} tick(self):\n        try:\n            {line}\n'
        '        except Exception:\n            pass\n',
    )
    assert test.verdict == 'timeout' and 'a deadlock, with or without a timeout' in test.message, test.message
    assert f'`{line}`' in test.message


def test_a_program_of_its_own_may_wait(tmp_path):
    """Outside of callbacks waiting is right: a function that makes its own node, or a callback's thread."""
    source = """\
def Talker():
    context = rclpy.Context()
    rclpy.init(context=context)
    node = Node('alone', context=context)
    executor = rclpy.executors.SingleThreadedExecutor(context=context)
    executor.add_node(node)
    executor.spin_once(timeout_sec=0)
    executor.shutdown()
    node.destroy_node()
    rclpy.shutdown(context=context)
    return 'done'
"""
    test = judge(
        tmp_path,
        source,
        '''
def test_call(learner):
    """It runs."""
    expect(learner.call('Talker') == 'done', 'It did not run.')
''',
    )
    assert test.verdict == 'passed', test.message


@pytest.mark.one_of(5)
@pytest.mark.parametrize(
    ('line', 'words'),
    [
        ('self.create_timer(0.25, self.tick())', 'the callback given to create_timer(…) is None, not a function'),
        (
            'from rclpy.task import Future; Future().add_done_callback(self.tick())',
            'the callback given to add_done_callback(…) is None, not a function: give the function itself',
        ),
        (
            "self.create_subscription(String, 'a', self.tick(), 10)",
            'the callback given to create_subscription(…) is None',
        ),
        (
            "self.create_service('reset', Trigger, self.tick)",
            'the type comes first, then the name: create_service(Trigger',
        ),
        (
            "self.create_publisher('chatter', String, 10)",
            'the type comes first, then the name: create_publisher(String',
        ),
        ("self.create_subscription('chatter', String, self.tick, 10)", 'the type comes first, then the name'),
        (
            "ActionServer(self, 'count', Fibonacci, self.tick)",
            "the type comes first, then the name: ActionServer(self, Fibonacci, 'count', …)",
        ),
        ("ActionClient(self, 'count', Fibonacci)", 'the type comes first, then the name: ActionClient(self, Fibonacci'),
        (
            "self.create_publisher(String, 'chatter')",
            'the queue depth or a QoS profile: create_publisher(String, …, 10)',
        ),
        (
            "self.create_publisher(String(), 'chatter', 10)",
            'the class itself, without parentheses: create_publisher(String',
        ),
        ("self.create_publisher(String, 'chatter', 10).publish(String)", 'A message is made: String().'),
        ('self.tick.missing; self.missing', "object has no attribute 'missing'"),
        ('timer.cancel()', 'Your class has `self.timer`: is `self.` missing before it?'),
        ('self.create_timer(0.5)', 'the period in seconds and the callback'),
        ('self.create_timer(0.5, self.on_goal())', 'without parentheses: self.on_goal, not self.on_goal()'),
        ('self.handle = 3', 'choose another one, such as `self.my_handle`'),
        ('Twist()', 'Write: from geometry_msgs.msg import Twist'),
        ('nobody_knows()', 'No cell that the check uses defines `nobody_knows`'),
        ('Bool(data=1)', 'Write bool(…) around the value; of a message take the field that holds it.'),
        ('self.timers = [self.timer]', 'choose another one, such as `self.my_timers`'),
        ('self.clients = {}', 'choose another one, such as `self.my_clients`'),
        ('Float64(data=2)', 'write 2.0 instead of 2'),
        ('Float64().data = 2', 'write 2.0 instead of 2'),
        ('self.client.call_async(Trigger.Request()).result().success', 'before the answer had come'),
        ('import asyncio; asyncio.get_running_loop()', "rclpy's `await` is not asyncio"),
    ],
)
def test_what_rclpy_says_obscurely_is_explained(tmp_path, line, words):
    """The message names the mistake, and the learner's line."""
    source = (
        f'{HEAD}        self.first()\n\n    def first(self):\n        {line}\n\n    def tick(self):\n        pass\n\n'
        '    def on_goal(self, goal):\n        pass\n'
    )
    test = judge(tmp_path, source)
    assert test.verdict == 'learner_crashed' and words in test.message, test.message
    assert 'Exercise 90.1, line 15' in test.message


def test_a_node_that_is_not_made_yet_is_named(tmp_path):
    """Without `super().__init__`, or before it, a node has nothing."""
    source = """\
class Talker(Node):
    def __init__(self):
        self.timer = self.create_timer(0.5, self.tick)
        super().__init__('talker')

    def tick(self):
        pass
"""
    test = judge(tmp_path, source)
    assert "`super().__init__('name')` must come before everything else" in test.message, test.message


@pytest.mark.parametrize('name', ['handle', 'services'])
def test_a_method_with_the_name_of_a_property_of_nodes_is_named(tmp_path, name):
    """rclpy would say that a 'method' object is no context manager, or that it cannot be iterated."""
    source = f"""\
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.{name})

    def {name}(self):
        pass
"""
    test = judge(tmp_path, source)
    assert test.verdict == 'learner_crashed' and f'such as `self.my_{name}`' in test.message, test.message


@pytest.mark.one_of(5)
@pytest.mark.parametrize(
    ('callback', 'words'),
    [
        ('lambda goal: True', 'Your goal_callback returned True. It must return GoalResponse.ACCEPT'),
        ('lambda goal: None', 'Your goal_callback returned None.'),
        ('lambda goal: GoalResponse.REJECT', ''),
    ],
)
def test_a_goal_callback_that_decides_nothing(tmp_path, callback, words):
    source = f"""\
{HEAD}
        self.server = ActionServer(self, Fibonacci, 'count', execute_callback=self.tick,
                                   goal_callback={callback})

    def tick(self, *_):
        pass
"""
    test = judge(
        tmp_path,
        source,
        '''
def test_goal(learner):
    """It takes a goal."""
    from example_interfaces.action import Fibonacci
    client = learner.action_client('/count', Fibonacci)
    learner.start('Talker')
    goal = client.send(Fibonacci.Goal())
    learner.run(0.2)
    expect(goal.accepted, 'It was rejected.')
''',
    )
    assert test.message.startswith(words or 'It was rejected.'), 'the cause comes first'
    assert 'It was rejected.' in test.message
    assert ('goal_callback' in test.message) is bool(words)


@pytest.mark.parametrize(
    ('callback', 'words'), [('', 'as every one without a cancel_callback does'), ('CancelResponse.REJECT', '')]
)
def test_a_server_without_a_cancel_callback(tmp_path, callback, words):
    """It rejects every cancel request, which is said where a test fails; who rejects on purpose is told nothing."""
    given = f', cancel_callback=lambda request: {callback}' if callback else ''
    source = f"""\
from rclpy.action import CancelResponse
{HEAD}
        self.server = ActionServer(self, Fibonacci, 'count', self.tick{given})

    def tick(self, *_):
        self.get_clock().sleep_for(rclpy.duration.Duration(seconds=1.0))
        return Fibonacci.Result()
"""
    test = judge(
        tmp_path,
        source.replace('self.timer = self.create_timer(0.5, self.tick)\n', ''),
        '''
def test_cancel(learner):
    """It can be cancelled."""
    from example_interfaces.action import Fibonacci
    client = learner.action_client('/count', Fibonacci)
    learner.start('Talker', threads=True)
    goal = client.send(Fibonacci.Goal())
    learner.run(0.2)
    cancel = goal.cancel()
    learner.run(0.2)
    expect(cancel.answer == 'accepted', 'It was rejected.')
''',
    )
    assert test.message.splitlines()[-1] == 'It was rejected.', test.message
    assert ('cancel_callback' in test.message) is bool(words) and words in test.message.splitlines()[0]


@pytest.mark.one_of(5)
@pytest.mark.parametrize('end', ['self.timer.destroy()', 'self.destroy_timer(self.timer)', 'self.timer.cancel()'])
def test_a_timer_may_be_destroyed_in_its_own_callback(tmp_path, end):
    """That is right in ROS, also by a coroutine that awaited it."""
    source = (
        HEAD
        + f"""\
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.1, self.go, callback_group=ReentrantCallbackGroup())
        self.waiting = rclpy.Future()

    def tick(self):
        {end}
        if not self.waiting.done():
            self.waiting.set_result(None)

    async def go(self):
        await self.waiting
        once = self.create_timer(0.1, lambda: None)
        once.destroy()
        self.publisher.publish(String(data='on'))
"""
    )
    test = judge(
        tmp_path,
        source,
        '''
def test_run(learner):
    """It goes on."""
    heard = learner.listen('/chatter', String)
    learner.start('Talker')
    learner.run(2.0)
    expect(heard.data, 'Nothing came.')
''',
    )
    assert test.verdict == 'passed', test.message


def test_a_cell_that_was_not_run_is_named(tmp_path):
    """The name that is missing stands in a cell of the notebook."""
    given = NotebookCell('def steer(x):\n    return x\n', 7, 'given')
    test = judge(tmp_path, HEAD + '        self.x = steer(3)\n\n    def tick(self):\n        pass\n', notebook=[given])
    assert 'is defined in cell 7: run that cell first' in test.message


def test_a_name_that_a_demonstration_has_made_is_named(tmp_path):
    """The learner's own cell has run, but is no definition."""
    cells = small.cells(HEAD + '        self.x = SPEED\n\n    def tick(self):\n        pass\n')
    cells[1:1] = [NotebookCell('def measure(): return 3\nSPEED = measure()\n', 9)]
    report = session.run(cells, [small.exercise()], session.Options(visible=small.write_tests(tmp_path, RUN)))
    message = report.exercises[0].tests[0].message
    assert '`SPEED` is made in cell 9, by a statement that does not run here' in message


def test_only_cells_with_the_missing_name_are_told(tmp_path):
    """A cell that could not be run explains an undefined name only if it holds that name."""
    cells = small.cells(HEAD + '        self.x = steer(3)\n\n    def tick(self):\n        pass\n')
    cells[1:1] = [NotebookCell('import nowhere', 2), NotebookCell('from nowhere import steer', 3)]
    options = session.Options(visible=small.write_tests(tmp_path, RUN))
    test = session.run(cells, [small.exercise()], options).exercises[0].tests[0]
    assert 'Not loaded: cell 3' in test.details and 'cell 2' not in test.details


SLEPT = '''
def test_run(learner):
    """It runs."""
    learner.start('Talker')
    learner.run(1.2)
    expect(not learner.slept, 'It waits.')
'''


@pytest.mark.parametrize(
    'line',
    [
        'end = time.monotonic() + 0.01\n        while time.monotonic() < end: pass',
        'end = time.time() + 0.01\n        while time.time() < end: pass',
        'threading.Event().wait(0.01)',
        'with contextlib.suppress(queue.Empty): queue.Queue().get(timeout=0.01)',
    ],
)
def test_a_wait_on_the_wall_clock_counts_as_sleep(tmp_path, line):
    """In a callback, where a loop asks the time again and again, or an event is waited for, as in time.sleep."""
    source = f'import contextlib\nimport queue\nimport threading\n{HEAD}    def tick(self):\n        {line}\n'
    test = judge(tmp_path, source, SLEPT)
    assert (test.verdict, test.message.splitlines()[-1]) == ('failed', 'It waits.')


@pytest.mark.parametrize('line', ['time.sleep(0.4)', 'threading.Event().wait(0.4)'])
def test_a_callback_that_sleeps_is_named_first(tmp_path, line):
    """Also where another rule is broken by it, or none that a test of this exercise looks at."""
    source = f'import threading\n{HEAD}    def tick(self):\n        {line}\n'
    test = judge(tmp_path, source, SLEPT.replace("not learner.slept, 'It waits.'", "False, 'Too late.'"))
    first, last = test.message.splitlines()
    assert re.match(rf'A callback sleeps at .*, line \d+: `{re.escape(line)}`\.', first), test.message
    assert last == 'Too late.'


def test_whoever_is_known_to_sleep_sleeps_shortly():
    """So that a check does not take minutes; what counts is how long it wanted to sleep."""
    callback = True
    seen = MistakeWatch(lambda: callback, lambda: False, lambda frame: True)
    frame, slept = sys._getframe(), []
    for _ in range(3):
        seen.sleeps(frame, 5.0)
        slept.append(seen.shortened(frame, 5.0))
    assert (slept[0], seen.slept) == (5.0, 15.0) and max(slept[1:]) < 0.1
    callback = False
    seen.sleeps(frame, 5.0)
    assert seen.shortened(frame, 5.0) == 5.0, 'a constructor, whose own sleep is another matter'


@pytest.mark.one_of(3)
def test_who_looks_at_the_clock_does_not_wait(tmp_path):
    """A measurement in each callback, or a loop over few things, is no wait."""
    source = (
        HEAD
        + '    def tick(self):\n        begin = time.monotonic()\n        print([time.time() for _ in range(20)])\n'
    )
    test = judge(tmp_path, source.replace('0.5, self.tick', '0.001, self.tick'), SLEPT)
    assert test.verdict == 'passed', test.message


@pytest.mark.parametrize('namespace', ["'robot'", "'/robot'", "''", "'/'", 'None'])
def test_a_namespace_that_a_node_gives_itself(tmp_path, namespace):
    """A card with relative names leaves the namespace to whoever starts the node, also where a remapping hides it."""
    source = HEAD.replace("'talker')", f"'talker', namespace={namespace})") + '    def tick(self):\n        pass\n'
    test = judge(
        tmp_path,
        source,
        """
@pytest.mark.wiring(namespace='names')
def test_run(learner):
    \\"\\"\\"It runs.\\"\\"\\"
    learner.start('Talker', remap={'__ns': '/here'})
""".replace('\\', ''),
    )
    if 'robot' in namespace:
        assert test.rule == 'names' and f'gives itself the namespace {namespace}' in test.message, test.message
    else:
        assert test.verdict == 'passed', test.message


def test_a_callback_that_always_keeps_the_processor_waits():
    """Its first run may have imported modules; and who is quick once does not wait."""
    seen = MistakeWatch(lambda: True, lambda: False, lambda frame: True)
    seen.worked('tick', 0.5, 0.02)
    for seconds in (0.5, 0.001, 0.5):
        seen.worked('tock', seconds, 0.02)
    counted = seen.slept
    seen.worked('tick', 0.25, 0.02)
    assert (counted, seen.slept) == (0.0, 0.25)


def test_log_lines_are_no_wait(tmp_path):
    """For each line that a cell logs rclpy looks through all modules: 40 lines keep the processor for 20 ms and more.

    rclpy still knows which line of the cell logs: for one line with two severities it would raise ValueError.
    """
    source = """\
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.1, self.tick)

    def tick(self):
        for _ in range(40):
            self.get_logger().info('here')
        self.get_logger().warning('once', once=True)
"""
    test = judge(
        tmp_path,
        source,
        '''
def test_run(learner):
    """It runs."""
    learner.start('Talker')
    learner.run(1.25)
    expect(not learner.slept, f'{learner.slept} s')
''',
    )
    assert test.verdict == 'passed', test.message


def test_after_many_runs_the_limit_is_lower():
    """Of many runs the shortest tells how long the callback needs; who was quick once does not wait."""
    seen = MistakeWatch(lambda: True, lambda: False, lambda frame: True)
    for run in range(30):
        seen.worked('tick', 0.001 if run == 3 else 0.01, 0.02, 0.002)
    assert seen.slept == 0.0
    for _ in range(30):
        seen.worked('tock', 0.01, 0.02, 0.002)
    assert seen.slept > 0.1


def test_who_spins_in_the_constructor_waits(tmp_path):
    """A spin that only looks what there is is none."""
    for timeout, verdict in ((0.1, 'failed'), (0.0, 'passed')):
        source = f'{HEAD}        rclpy.spin_once(self, timeout_sec={timeout})\n\n    def tick(self):\n        pass\n'
        test = judge(tmp_path, source, SLEPT)
        assert test.verdict == verdict, test.message


@pytest.mark.parametrize(
    'clock, said', [('Clock(clock_type=ClockType.STEADY_TIME)', True), ('self.get_clock()', False)]
)
def test_a_timer_with_a_clock_of_its_own_is_named(tmp_path, clock, said):
    source = HEAD.replace('self.tick)', f'self.tick, clock={clock})') + '\n    def tick(self):\n        pass\n'
    found = judge(tmp_path, f'from rclpy.clock import Clock, ClockType\n{source}')
    assert ('leave out `clock`' in found.message) is said, found
