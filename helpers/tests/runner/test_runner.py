"""The `learner` fixture with programs that are right, wrong, stuck, dying or loud: one session, an exercise each."""

import pytest

from helpers.exercises.notebooks import NotebookCell
from helpers.runner import session, start_processes
from helpers.tests import small
from helpers.tests.runner import action_cases, command_cases, frame_cases, robot_cases, service_cases
from helpers.tests.small import Case

NODE = 'class Talker(Node):\n    def __init__(self):\n        super().__init__("talker")\n'


START = "learner.start('Talker')\nlearner.run(1.0)"
EXACT = """
heard = learner.listen('/chatter', String)
learner.start('Talker')
learner.run(5.0)
assert heard.data == [str(number) for number in range(10)]
assert heard.stamps == [0.5 * number for number in range(1, 11)]
"""

CASES = {
    # Time
    'timers fire at their exact times': Case(small.TALKER, EXACT),
    'small steps change nothing': Case(small.TALKER, EXACT.replace('5.0', '5.0, step=0.01')),
    'after a jump of the clock a timer is called once, late': Case(
        small.TALKER,
        """
heard = learner.listen('/chatter', String)
learner.start('Talker')
learner.run(0.6)
learner.jump(2.0)
expect(heard.stamps == [0.5, 2.6], f'{heard.stamps}')
learner.run(1.0)
expect(heard.data == ['0', '1', '2', '3'] and heard.stamps[2:] == [3.0, 3.5], f'{heard.data} {heard.stamps}')
""",
    ),
    'a period that no step divides': Case(
        small.TALKER.replace('0.5', '1 / 3'),
        """
heard = learner.listen('/chatter', String)
learner.start('Talker')
learner.run(1.1)
expect([round(stamp, 6) for stamp in heard.stamps] == [0.333333, 0.666667, 1.0], f'{heard.stamps}')
""",
    ),
    'a node that starts later has the right time': Case(
        NODE
        + """\
        self.p = self.create_publisher(Float64, 'now', 10)
        self.born = self.get_clock().now().nanoseconds / 1e9
        self.create_timer(0.5, lambda: self.p.publish(Float64(data=self.born)))
""",
        """
learner.run(2.0)
heard = learner.listen('/now', Float64)
learner.start('Talker')
learner.run(1.1)
expect(heard.data == [2.0, 2.0] and heard.stamps == [2.5, 3.0], f'{heard.data} {heard.stamps}')
""",
    ),
    'a subscription sees the time of the sending': Case(
        NODE
        + """\
        self.p = self.create_publisher(Float64, 'now', 10)
        self.create_subscription(Empty, 'ask', self.answer, 10)

    def answer(self, message):
        self.p.publish(Float64(data=self.get_clock().now().nanoseconds / 1e9))
""",
        """
heard, asked = learner.listen('/now', Float64), learner.talk('/ask', Empty)
learner.start('Talker')
learner.run(1.5)
asked.send(Empty())
learner.run(1.0)
expect(heard.data == [1.5] and heard.stamps == [1.5], f'{heard.data} {heard.stamps}')
""",
    ),
    'a node beside another one, in a namespace of its own and with its own parameter': Case(
        NODE
        + """\
        self.p = self.create_publisher(Float64, 'now', 10)
        self.create_subscription(Empty, 'ask', self.answer, 10)
        self.declare_parameter('factor', 1.0)

    def answer(self, message):
        self.p.publish(Float64(data=self.get_parameter('factor').value))
""",
        """
first, second = learner.listen('/left/now', Float64), learner.listen('/right/now', Float64)
asked = [learner.talk(f'/{space}/ask', Empty) for space in ('left', 'right')]
node = learner.start('Talker', parameters={'factor': 2.0}, remap={'__ns': '/left'})
other = learner.start('Talker', beside=node, parameters={'factor': 3.0}, remap={'__ns': '/right'})
expect(other.name.startswith('/right/'), other.name)
for topic in asked:
    topic.send(Empty())
    learner.run(0.5)
expect((first.data, first.stamps) == ([2.0], [0.0]), f'{first.data} {first.stamps}')
expect((second.data, second.stamps) == ([3.0], [0.5]), f'{second.data} {second.stamps}')
third = learner.start('Talker', beside=node)
expect(third.name == node.name, third.name)
""",
    ),
    'the depth of a queue': Case(
        NODE
        + """\
        self.p = self.create_publisher(String, 'said', 7)
        self.create_subscription(String, 'heard', lambda message: None, QoSProfile(depth=3))
""",
        """
learner.start('Talker')
expect(learner.depths('publisher', '/said') == [7], f'{learner.depths("publisher", "/said")}')
expect(learner.depths('subscription', '/heard') == [3], f'{learner.depths("subscription", "/heard")}')
expect(learner.depths('publisher', '/heard') == [], 'there is none')
""",
    ),
    'what sleeps is counted': Case(
        'import time\nfrom time import sleep\n'
        + NODE
        + """\
        time.sleep(0.02)
        self.create_timer(1.0, lambda: sleep(0.01))
""",
        """
learner.start('Talker')
expect(learner.slept == 0.02, f'{learner.slept}')
learner.run(2.5)
expect(round(learner.slept, 6) == 0.04, f'{learner.slept}')
""",
    ),
    'threads that the cell starts beside the answer may sleep': Case(
        """\
import threading
import time

def tick():
    while True:
        time.sleep(0.01)

threading.Thread(target=tick, daemon=True).start()
time.sleep(0.02)
"""
        + small.TALKER,
        EXACT + "expect(not learner.slept, f'{learner.slept}')\n",
    ),
    'a thread of the answer that sleeps on a rate': Case(
        'import threading\n'
        + NODE
        + """\
        self.publisher, self.rate = self.create_publisher(String, 'chatter', 10), self.create_rate(2.0)
        threading.Thread(target=self.work, daemon=True).start()

    def work(self):
        while rclpy.ok():
            self.rate.sleep()
            time.sleep(0.02)  # the step waits for it
            self.publisher.publish(String(data='here'))
""",
        """
heard = learner.listen('/chatter', String)
learner.start('Talker')
learner.run(6.1)
expect(heard.stamps == [number / 2 for number in range(1, 13)], f'{heard.stamps}')
""",
    ),
    'a node that its cell tries out and destroys': Case(
        small.TALKER
        + """
rclpy.ok() or rclpy.init()
tried = [Talker(), Talker()]
print(tried[0].get_name())
for node in tried:
    node.destroy_node()
left = Talker()
""",
        EXACT,
    ),
    'what notebooks have without an import': Case(
        """\
import asyncio
display('shown', raw=True)

async def slowly():
    await asyncio.sleep(0)
    return 1

one = await slowly()
display(one)
get_ipython().run_line_magic('matplotlib', 'inline')
in_colab = 'google.colab' in str(get_ipython()) or 'Colab' in get_ipython().config
for line in get_ipython().getoutput('ls'):
    print(line)
"""
        + small.TALKER,
        EXACT,
    ),
    'an exception while a cell awaits': Case(
        """\
async def slowly():
    raise ValueError('too slow')

await slowly()
"""
        + small.TALKER,
        EXACT,
        'learner_crashed',
        ('too slow',),
    ),
    'a long sum of texts': Case('TEXT = ' + ' + '.join(["'a'"] * 250) + '\n' + small.TALKER, EXACT),
    'who waits for a server sleeps': Case(
        'from std_srvs.srv import Trigger\n'
        + NODE
        + """\
        client = self.create_client(Trigger, 'nobody')
        self.create_timer(1.0, lambda: client.wait_for_service(timeout_sec=0.1))
""",
        """
learner.start('Talker')
expect(learner.slept == 0.0, f'{learner.slept}')
learner.run(1.5)
expect(learner.slept == 0.25, f'{learner.slept}')
""",
    ),
    'contexts that a function leaves are counted': Case(
        """\
def Talker(ends):
    context = rclpy.Context()
    rclpy.init(context=context)
    rclpy.create_node('short', context=context).destroy_node()
    if ends:
        rclpy.shutdown(context=context)
""",
        """
before = learner.contexts
learner.call('Talker', True)
expect(learner.contexts == before, 'it was shut down')
learner.call('Talker', False)
expect(learner.contexts == before + 1, 'it was not, though nobody refers to it')
""",
    ),
    'the order of what was published at one moment': Case(
        NODE
        + """\
        self.a, self.b = (self.create_publisher(String, name, 10) for name in ('a', 'b'))
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.b.publish(String(data='first'))
        self.a.publish(String(data='second'))
""",
        """
a, b = learner.listen('/a', String), learner.listen('/b', String)
learner.start('Talker')
learner.run(1.5)
expect(a.stamps == b.stamps and b.published[0] < a.published[0], f'{a.published} {b.published}')
""",
    ),
    'settle does not let time pass': Case(
        small.TALKER,
        """
heard = learner.listen('/chatter', String)
learner.start('Talker')
learner.settle()
learner.settle()
assert not heard.messages and learner.now == 0
""",
    ),
    'a coroutine callback': Case(
        NODE
        + """\
        self.p = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, self.tick)

    async def tick(self):
        self.p.publish(String(data='x'))
""",
        "heard = learner.listen('/chatter', String)\n" + START + '\nassert len(heard) == 2',
    ),
    # Order and arrival
    'messages from one node to another in the same process': Case(
        """\
class Relay(Node):
    def __init__(self, number):
        super().__init__(f'relay{number}')
        self.p = self.create_publisher(Int32, f'step{number + 1}', 10)
        self.create_subscription(Int32, f'step{number}', self.p.publish, 10)

def Talker():
    return [Relay(number) for number in range(4)]
""",
        """
heard, sender = learner.listen('/step4', Int32), learner.talk('/step0', Int32)
learner.start('Talker')
for number in range(20):
    sender.send(Int32(data=number))
    learner.settle()
    assert heard.data == list(range(number + 1)), heard.data
""",
    ),
    'messages from one process to another': Case(
        """\
class Talker(Node):
    def __init__(self, number):
        super().__init__(f'relay{number}')
        self.p = self.create_publisher(Int32, f'step{number + 1}', 10)
        self.create_subscription(Int32, f'step{number}', self.p.publish, 10)
""",
        """
heard, sender = learner.listen('/step3', Int32), learner.talk('/step0', Int32)
for number in range(3):
    learner.start('Talker', number)
for number in range(10):
    sender.send(Int32(data=number))
    learner.settle()
    assert heard.data == list(range(number + 1)), heard.data
""",
    ),
    'large and best-effort messages': Case(
        NODE
        + """\
        self.p = self.create_publisher(ByteMultiArray, 'big', qos_profile_sensor_data)
        self.q = self.create_publisher(ByteMultiArray, 'big_reliable', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.p.publish(ByteMultiArray(data=[b'x'] * 150_000))
        self.q.publish(ByteMultiArray(data=[b'x'] * 150_000))
""",
        """
heard = learner.listen('/big', ByteMultiArray, qos_profile_sensor_data)
reliable = learner.listen('/big_reliable', ByteMultiArray)
learner.start('Talker')
for number in range(1, 6):
    learner.run(0.1)
    assert len(heard) == number and len(reliable) == number, (len(heard), len(reliable), number)
""",
    ),
    'a burst keeps what the depth keeps': Case(
        NODE
        + """\
        self.p = self.create_publisher(Int32, 'out', 100)
        self.create_subscription(Int32, 'in', self.p.publish, 3)
""",
        """
heard, sender = learner.listen('/out', Int32, 100), learner.talk('/in', Int32, 100)
learner.start('Talker')
sender.send(*(Int32(data=number) for number in range(10)))
learner.settle()
expect(heard.data == [7, 8, 9], f'{heard.data}')
""",
    ),
    'endpoints that a callback makes': Case(
        NODE
        + """\
        self.create_timer(1.0, self.tick)
        self.p = None

    def tick(self):
        if self.p:
            self.p.publish(String(data='tick'))
        else:
            self.p = self.create_publisher(String, 'late', 10)
            self.create_subscription(String, 'ask', self.p.publish, 10)
""",
        """
heard, asked = learner.listen('/late', String), learner.talk('/ask', String)
learner.start('Talker')
learner.run(1.0)
asked.send(String(data='hi'))
learner.run(1.0)
assert heard.data == ['hi', 'tick'], heard.data
""",
    ),
    'latched, in both directions': Case(
        NODE
        + """\
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.p = self.create_publisher(String, 'map', latched)
        self.p.publish(String(data='old'))
        self.p.publish(String(data='new'))
        self.q = self.create_publisher(String, 'echo', 10)
        self.create_subscription(String, 'order', self.q.publish, latched)
""",
        """
latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
orders, echo = learner.talk('/order', String, latched), learner.listen('/echo', String)
orders.send(String(data='go'))
learner.start('Talker')
learner.run(3.0)
late = learner.late_listener('/map', String, latched)
assert late.data == ['new'] and late.stamps == [3.0] and echo.data == ['go'], (late, echo)
""",
    ),
    # What a test can ask
    'parameters, remapping, namespace and names': Case(
        NODE
        + """\
        self.declare_parameter('word', 'none')
        self.declare_parameter('sizes', [0])
        self.p = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, lambda: self.p.publish(String(data=self.get_parameter('word').value)))

    def sizes(self, factor):
        return [factor * size for size in self.get_parameter('sizes').value]
""",
        """
heard = learner.listen('/left/news', String)
node = learner.start('Talker', parameters={'word': "it's: so", 'sizes': [1, 2]},
                     remap={'chatter': 'news', '__ns': '/left'})
learner.run(0.5)
assert heard.data == ["it's: so"] and node.name == '/left/talker' and node.call('sizes', 3) == [3, 6]
""",
    ),
    'calls with values of many types': Case(
        """\
def Talker(*args, **kwargs):
    return [*args, kwargs]
""",
        """
from rclpy.duration import Duration
from geometry_msgs.msg import Point
qos = QoSProfile(depth=7, reliability=ReliabilityPolicy.BEST_EFFORT)
point, length = Point(x=1.0), Duration(seconds=2)
got = learner.call('Talker', 1, 2.5, 'x', None, True, [1, {'a': (2, 3)}], b'y', point, qos, length, key={1: 2})
assert got[:7] == [1, 2.5, 'x', None, True, [1, {'a': [2, 3]}], b'y'], got
assert got[7] == point and got[8].depth == 7 and got[8].reliability == qos.reliability and got[9] == length
assert got[10] == {'key': {1: 2}}
""",
    ),
    'calls that change their arguments': Case(
        """\
def Talker(names, table={}, *, deep=None, number=0):
    if names:
        names.sort()
        table['seen'] = 1
        deep[0].append(float('nan'))
def keeps(*values, **named):
    return sorted(values[0]), named
""",
        """
learner.call('Talker', ['b', 'a'], deep=[[]])
assert learner.changed('Talker') == ['names', 'deep'], learner.changed('Talker')
assert learner.changed('Talker', defaults=True) == ['names', 'deep', 'table']
learner.call('keeps', [3, 1], more={'x': float('nan')})
assert learner.changed('keeps') == []
assert '`Talker` changes its argument `deep`: work with a copy.' in learner.hints()
assert '`Talker` changes its default argument `table`, which is the same object in all calls.' in learner.hints()
learner.end_calls()
learner.call('Talker', [], {'x': float('nan')}, deep=[float('nan')])
assert learner.changed('Talker') == []
""",
    ),
    'calls that return what JSON does not know': Case(
        """\
import numpy, collections
def Talker(kind):
    return {'array': numpy.arange(3), 'number': numpy.float64(2), 'object': object(), 'nan': float('nan'),
            'set': {3, 1}, 'deque': collections.deque([1])}[kind]
""",
        """
assert learner.call('Talker', 'array') == [0, 1, 2] and learner.call('Talker', 'number') == 2
assert learner.call('Talker', 'object').type == 'object' and learner.call('Talker', 'nan') != 0
assert learner.call('Talker', 'set') == [1, 3] and learner.call('Talker', 'deque') == [1]
""",
    ),
    'endpoints': Case(
        NODE
        + """\
        self.p = self.create_publisher(String, 'a', qos_profile_sensor_data)
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(Int32, 'b', lambda message: None, latched)
""",
        """
learner.start('Talker')
publisher, = learner.endpoints('/a').publishers
subscription, = learner.endpoints('b').subscriptions
assert publisher.node == '/talker' and publisher.type == 'std_msgs/msg/String' and not publisher.reliable
assert subscription.latched and subscription.reliable and not learner.endpoints('/a').subscriptions
""",
    ),
    'output': Case(
        NODE + "        print('printed'); self.get_logger().warn('logged')\n",
        START + "\nassert '[WARN] [talker]: logged' in learner.output and 'printed' in learner.output",
        output='logged',
    ),
    'stopping a node takes it from the graph': Case(
        small.TALKER,
        """
node = learner.start('Talker')
learner.run(1.0)
node.stop()
assert learner.wait_until(lambda: not learner.endpoints('/chatter').publishers)
""",
    ),
    'ROS is started and spun by the notebook itself': Case(
        'rclpy.init()\n' + small.TALKER + "\nif __name__ == '__main__':\n    rclpy.spin(Talker())\nrclpy.shutdown()\n",
        EXACT,
    ),
    # Programs that are wrong
    'an expectation': Case(
        small.TALKER, START + "\nexpect(False, 'You spoke too much.')", 'failed', ('You spoke too much.',)
    ),
    'a bare assertion stays with the grader': Case(small.TALKER, 'secret = 42\nassert secret == 43', 'failed', ('',)),
    'wrong topic': Case(
        small.TALKER.replace("'chatter'", "'/chater'"),
        EXACT.replace('assert', 'expect(0, "x")#'),
        'failed',
        ('no publisher on /chatter; it has one on /chater (std_msgs/msg/String).',),
    ),
    'wrong type': Case(
        small.TALKER.replace('String', 'Int32').replace('str(self.count)', 'self.count'),
        EXACT,
        'failed',
        ('/chatter must carry std_msgs/msg/String; your publisher there has the type std_msgs/msg/Int32',),
    ),
    'weak offer': Case(
        small.TALKER.replace(', 10)', ', qos_profile_sensor_data)'),
        EXACT,
        'failed',
        ('publisher on /chatter offers reliability BEST_EFFORT, the subscription asks for RELIABLE',),
    ),
    'strong request': Case(
        NODE + "        self.create_subscription(String, 'x', lambda message: None, 10)\n",
        """
learner.talk('/x', String, qos_profile_sensor_data)
learner.start('Talker')
learner.run(1.0)
""",
        'failed',
        ('subscription on /x asks for reliability RELIABLE, the publisher offers BEST_EFFORT',),
    ),
    'not strict': Case(
        small.TALKER.replace(', 10)', ', qos_profile_sensor_data)'),
        """
heard = learner.listen('/chatter', String, strict=False)
learner.start('Talker')
learner.run(2.0)
assert not heard.messages
""",
    ),
    'exception in the constructor': Case(
        NODE + '        self.create_timer(0.5)\n',
        START,
        'learner_crashed',
        ('While `Talker(…)` was made your code raised TypeError', 'at Exercise 90.', 'line 5.'),
        'create_timer(0.5)',
    ),
    'exception in a callback': Case(
        NODE
        + """\
        self.create_timer(0.5, self.tick)

    def tick(self):
        self.helper()

    def helper(self):
        return 1 / 0
""",
        START,
        'learner_crashed',
        ('In a callback (timer of 0.5 s of node `talker`)', 'ZeroDivisionError', 'line 11'),
        'line 8, in tick\n    self.helper()',
    ),
    'exception in a subscription': Case(
        NODE + "        self.create_subscription(String, 'x', self.on, 10)\n"
        '    def on(self, message):\n        message.date\n',
        """
sender = learner.talk('/x', String)
learner.start('Talker')
sender.send(String())
learner.settle()
""",
        'learner_crashed',
        ('subscription of /x', 'AttributeError'),
    ),
    'exception in a call': Case(
        'def Talker():\n    return {}["key"]\n',
        "learner.call('Talker')",
        'learner_crashed',
        ("While `Talker(…)` ran your code raised KeyError: 'key'",),
    ),
    'exception in the cell': Case(
        'x = 1\nundefined\nTalker = 1\n',
        START,
        'learner_crashed',
        ('While the cell was run your code raised NameError', 'line 3'),
    ),
    'an exception that lies': Case(
        """\
class Lie(Exception):
    def __str__(self): raise ValueError
def Talker(): raise Lie
""",
        "learner.call('Talker')",
        'learner_crashed',
        ('raised Lie',),
    ),
    'no node': Case('def Talker(): pass\n', START, 'failed', ('gives nothing (None), not a node',)),
    'another object': Case('class Talker: pass\n', START, 'failed', ('gives an object of type `Talker`, not a node',)),
    'no super': Case(
        'class Talker(Node):\n    def __init__(self):\n        pass\n', START, 'failed', ('super().__init__',)
    ),
    'wrong number of arguments': Case(
        small.TALKER, "learner.start('Talker', 1, 2)", 'learner_crashed', ('TypeError', 'positional argument')
    ),
    'no such function': Case(small.TALKER, "learner.call('speak')", 'invalid_submission', ('does not define `speak`',)),
    'no such method': Case(
        small.TALKER, "learner.start('Talker').call('speak')", 'invalid_submission', ('Talker.speak',)
    ),
    'a timer of period 0': Case(
        NODE + '        self.create_timer(0.0, lambda: None)\n', START, 'failed', ('never comes to rest',)
    ),
    'a node that answers itself': Case(
        NODE
        + """\
        self.p = self.create_publisher(Int32, 'x', 10)
        self.create_subscription(Int32, 'x', self.p.publish, 10)
""",
        """
sender = learner.talk('/x', Int32)
learner.start('Talker')
sender.send(Int32())
learner.settle()
""",
        'failed',
        ('never comes to rest',),
    ),
    'two nodes that answer each other': Case(
        """\
class Talker(Node):
    def __init__(self, mine, other):
        super().__init__(mine)
        self.p = self.create_publisher(Int32, other, 10)
        self.create_subscription(Int32, mine, self.p.publish, 10)
""",
        """
sender = learner.talk('/a', Int32)
learner.start('Talker', 'a', 'b')
learner.start('Talker', 'b', 'a')
sender.send(Int32())
learner.settle()
""",
        'failed',
        ('never come',),
    ),
    # Programs that do not come back
    'a constructor that sleeps': Case(
        NODE + '        time.sleep(1000)\n',
        START,
        'timeout',
        ('`Talker(…)` did not return within 2 s', 'line 5: `time.sleep(1000)`'),
    ),
    'a constructor that spins': Case(NODE + '        rclpy.spin(self)\n', START, 'timeout', ('`rclpy.spin(self)`',)),
    'a callback that loops': Case(
        NODE
        + """\
        self.create_timer(0.5, self.tick)

    def tick(self):
        while True:
            pass
""",
        START,
        'timeout',
        ('A callback did not return within', 'line 8'),
    ),
    'a cell that waits': Case(
        'class Talker: pass\nimport threading\nthreading.Event().wait()\n',
        START,
        'timeout',
        ('The cell did not return', 'line 4'),
    ),
    'an import that takes longer than a cell may: that is up to the machine': Case(
        'import pathlib, sys, tempfile\n'
        "module = pathlib.Path(tempfile.mkdtemp(), 'slow_to_load.py')\n"
        "module.write_text('import time; time.sleep(3)')\n"
        'sys.path.insert(0, str(module.parent))\n'
        'import slow_to_load\n' + small.TALKER,
        START,
    ),
    'a call that ignores signals': Case(
        """\
import signal
for number in (signal.SIGTERM, signal.SIGINT, signal.SIGALRM, signal.SIGHUP):
    signal.signal(number, signal.SIG_IGN)
def Talker():
    while True:
        time.sleep(1)
""",
        "learner.call('Talker')",
        'timeout',
        ('`Talker(…)` did not return',),
    ),
    # Programs that end themselves
    'exit in the cell': Case('Talker = 1\nraise SystemExit(0)\n', START, 'learner_crashed', ('called exit()',)),
    'exit in a callback': Case(
        NODE + '        self.create_timer(0.5, exit)\n', START, 'learner_crashed', ('called exit()',)
    ),
    'os._exit in the constructor': Case(
        NODE + '        import os; os._exit(0)\n', START, 'learner_crashed', ('ended by itself (exit status 0)',)
    ),
    'a signal to itself': Case(
        NODE + '        import os, signal; os.kill(0, signal.SIGKILL)\n',
        START,
        'learner_crashed',
        ('was ended by SIGKILL',),
    ),
    'a segmentation fault': Case(
        'import ctypes\ndef Talker(): ctypes.string_at(0)\n',
        "learner.call('Talker')",
        'learner_crashed',
        ('crashed (SIGSEGV)',),
    ),
    'KeyboardInterrupt': Case(
        'def Talker(): raise KeyboardInterrupt\n', "learner.call('Talker')", 'learner_crashed', ('KeyboardInterrupt',)
    ),
    # Programs that are loud or greedy
    'a flood of text': Case(NODE + "        for _ in range(20): print('x' * 100_000)\n", START, 'passed'),
    'a result that is too long': Case(
        'def Talker(): return "x" * 10_000_000\n', "learner.call('Talker')", 'failed', ('too long',)
    ),
    'a result without end': Case(
        'def Talker():\n    x = []; x.append(x)\n    return x\n',
        "learner.call('Talker')",
        'learner_crashed',
        ('nested too deeply',),
    ),
    'more memory than there may be': Case(
        'def Talker(): return len(bytearray(10**11))\n', "learner.call('Talker')", 'learner_crashed', ('MemoryError',)
    ),
    'escapes and addresses in an error': Case(
        "def Talker(): raise ValueError('\\x1b[31m' + repr(object()))\n",
        "learner.call('Talker')",
        'learner_crashed',
        ('<object object at 0x…>',),
    ),
    'standard output is not the channel': Case(
        """\
import os, sys
print('{"id": 1, "ok": true}', flush=True)
os.close(0)
sys.stdout.close()
"""
        + small.TALKER,
        EXACT,
    ),
    **service_cases.CASES,
    **action_cases.CASES,
    **command_cases.CASES,
    **frame_cases.CASES,
    **robot_cases.CASES,
}


@pytest.fixture(scope='module')
def judged(request, tmp_path_factory):
    """The result of each case that is asked for, from one session."""
    folder = tmp_path_factory.mktemp('course')
    exercises, cells = [], [NotebookCell(small.IMPORTS, 1)]
    mine = [item for item in request.session.items if item.path == request.path]
    names = [item.callspec.params['name'] for item in mine if item.originalname == 'test_case']
    for number, name in enumerate(names, 1):
        case = CASES[name]
        body = ''.join(f'    {line}\n' for line in case.test.strip().splitlines())
        text = f'\ndef test_it(learner):\n    """{name}.\n\n    Look there.\n    """\n{QUICK}{body}'
        small.write_tests(folder, text, number)
        exercises.append(small.exercise(number))
        cells.append(small.cell(case.program, number))
    report = session.run(
        cells, exercises, session.Options(visible=folder / 'checks', processes=2, limits=start_processes.Limits(cpu=20))
    )
    return dict(zip(names, report.exercises, strict=True)) | {'log': report.log}


# What does not come back is given up sooner than in a course.
QUICK = '    from helpers.runner.timeouts import Timeouts\n    learner.timeouts = Timeouts(2, 2, 2, 2, stuck=3)\n'


@pytest.mark.timeout(600)
@pytest.mark.one_of(3)
@pytest.mark.parametrize('name', CASES)
def test_case(judged, name):
    case, result = CASES[name], judged[name]
    assert not result.message, result.message
    (test,) = result.tests
    assert test.verdict == case.verdict, (test.message, test.details, test.fault, test.output)
    for fragment in case.messages:
        assert fragment in test.message, test.message
    assert case.details in test.details
    assert case.output in test.output
    assert test.expected == f'{name}.\n\nLook there.'
    shown = test.message + test.details + test.output
    assert 'secret' not in shown and '/helpers/' not in shown and 'test_it' not in shown
    assert '\x1b' not in shown and len(test.output) < 25_000


@pytest.mark.timeout(600)
def test_the_runner_met_no_fault_of_its_own(judged):
    assert judged['log'] == []
