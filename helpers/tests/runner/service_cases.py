"""Programs with services for `test_runner`: the test's client and server in simulated time, right and wrong."""

from helpers.tests.small import Case

HEAD = """\
from example_interfaces.srv import AddTwoInts
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
"""
SERVER = (
    HEAD
    + """\
        self.create_service(AddTwoInts, 'add', self.add)

    def add(self, request, response):
        response.sum = request.a + request.b
        return response
"""
)
ASKS = (
    HEAD
    + """\
        self.client = self.create_client(AddTwoInts, 'add')
        self.p = self.create_publisher(Int64, 'sum', 10)
        self.create_timer(1.0, self.ask)

    def ask(self):
        future = self.client.call_async(AddTwoInts.Request(a=20, b=1))
        future.add_done_callback(lambda future: self.p.publish(Int64(data=future.result().sum)))
"""
)
RELAY = (
    HEAD
    + """\
        group = MutuallyExclusiveCallbackGroup()
        self.client = self.create_client(AddTwoInts, 'add', callback_group=group)
        self.create_service(AddTwoInts, 'twice', self.twice)

    async def twice(self, request, response):
        answer = await self.client.call_async(request)
        response.sum = 2 * answer.sum
        return response
"""
)
TYPE = 'from example_interfaces.srv import AddTwoInts\n'
ADD = TYPE + "add = learner.serve('/add', AddTwoInts, lambda request: {'sum': request.a + request.b}, delay=%s)\n"
CALL = TYPE + "learner.start('Talker')\nadd = learner.client('/add', AddTwoInts)\nassert add.call(a=2, b=3).sum == 5"

CASES = {
    'a service is called': Case(SERVER, CALL),
    'many requests, outstanding together': Case(
        SERVER,
        TYPE
        + """
add = learner.client('/add', AddTwoInts)
learner.start('Talker')
learner.run(1.5)
calls = [add.send(a=n, b=n) for n in range(10)]  # as many as a service keeps
assert not any(call.done for call in calls)
learner.settle()
assert [call.response.sum for call in calls] == [2 * n for n in range(10)]  # as many as a service keeps
assert {call.sent for call in calls} == {call.received for call in calls} == {1.5}
""",
    ),
    'a client is answered at once': Case(
        ASKS,
        ADD % 0
        + """
heard = learner.listen('/sum', Int64)
learner.start('Talker')
learner.run(2.5)
assert heard.data == [21, 21] and heard.stamps == add.stamps == [1.0, 2.0], (heard, add.stamps)
assert add.requests[0].a == 20
""",
    ),
    'a client is answered later, at the exact time': Case(
        ASKS,
        ADD % 0.123
        + """
heard = learner.listen('/sum', Int64)
learner.start('Talker')
learner.run(2.5)
assert [round(stamp, 6) for stamp in heard.stamps] == [1.123, 2.123], heard.stamps
""",
    ),
    'a script of answers': Case(
        ASKS,
        TYPE
        + """
heard = learner.listen('/sum', Int64)
server = learner.serve('/add', AddTwoInts, iter([{'sum': 1}, None, {'sum': 3}, lambda request: {'sum': request.a}]),
                       delay=lambda request: 0.25)
learner.start('Talker')
learner.run(5.5)
assert heard.data == [1, 3, 20] and heard.stamps == [1.25, 3.25, 4.25], heard
""",
    ),
    'a server that goes and comes again': Case(
        ASKS,
        ADD % 0.5
        + """
heard = learner.listen('/sum', Int64)
learner.start('Talker')
learner.run(1.2)
add.stop()
learner.run(1.0)
add.start()
learner.run(1.5)
assert heard.stamps == [3.5] and add.stamps == [1.0, 3.0], (heard.stamps, add.stamps)
""",
    ),
    'a service that asks another service': Case(
        RELAY,
        ADD % 0.5
        + """
twice = learner.client('/twice', AddTwoInts)
learner.start('Talker')
calls = [twice.send(a=n, b=1) for n in range(2)]
learner.run(3.0)
assert [call.response.sum for call in calls] == [2, 4]
assert [call.received for call in calls] == [0.5, 1.0]
""",
    ),
    "a service in the constructor's wait": Case(
        ASKS.replace('        self.p', '        assert self.client.wait_for_service(2.0)\n        self.p'),
        ADD % 0 + "learner.start('Talker')\nlearner.run(1.0)\nassert add.requests",
    ),
    'no service of this name': Case(
        SERVER.replace("'add'", "'/plus'"),
        CALL,
        'failed',
        ('no service on /add; it has one on /plus (example_interfaces/srv/AddTwoInts).',),
    ),
    'no service': Case(HEAD, CALL, 'failed', ('Your program has no service on /add.',)),
    'no client of this name': Case(
        ASKS.replace("'add'", "'/plus'"),
        ADD % 0
        + """
learner.start('Talker')
learner.run(1.5)
expect(add.requests, 'No request.')
""",
        'failed',
        ('no client for /add; it has one for /plus (example_interfaces/srv/AddTwoInts).',),
    ),
    'a service of another type': Case(
        SERVER.replace('AddTwoInts', 'SetBool').replace('example_interfaces', 'std_srvs'),
        CALL,
        'failed',
        (
            '/add must have the type example_interfaces/srv/AddTwoInts; your service there has the type '
            'std_srvs/srv/SetBool',
        ),
    ),
    'a client of another type': Case(
        ASKS.replace('AddTwoInts', 'SetBool').replace('example_interfaces', 'std_srvs'),
        ADD % 0 + "learner.start('Talker')\nlearner.run(0.5)",
        'failed',
        ('your client there has the type std_srvs/srv/SetBool',),
    ),
    'a service that never answers': Case(
        RELAY,
        TYPE
        + """
learner.serve('/add', AddTwoInts, None)
learner.start('Talker')
learner.client('/twice', AddTwoInts).call(a=1, timeout=2.0)
""",
        'failed',
        ('Your service /twice did not answer within 2 s.',),
    ),
    'a service that returns nothing': Case(
        SERVER.replace('return response', 'pass'),
        CALL,
        'learner_crashed',
        ('In a callback (service add of node `talker`)', 'returned nothing (None)', 'return response'),
    ),
    'a service behind a lambda that nobody awaits': Case(
        SERVER.replace('self.add)', 'lambda *both: self.add(*both))').replace('    def add(', '    async def add('),
        CALL,
        'learner_crashed',
        ('In a callback (service add of node `talker`)', 'returned a coroutine', 'such as a lambda'),
    ),
    'an exception in a service': Case(
        SERVER.replace('request.a +', '1 / 0 +'),
        CALL,
        'learner_crashed',
        ('service add of node `talker`', 'ZeroDivisionError'),
    ),
    'a call that waits in a callback': Case(
        ASKS.replace('call_async', 'call'),
        ADD % 0
        + """
learner.start('Talker')
learner.run(1.0)
""",
        'timeout',
        ('a deadlock, with or without a timeout', 'waits for an answer', 'self.client.call('),
    ),
    'a client that never comes to rest': Case(
        HEAD
        + """\
        self.client = self.create_client(AddTwoInts, 'add')
        self.create_timer(1.0, self.ask)

    def ask(self, future=None):
        self.client.call_async(AddTwoInts.Request()).add_done_callback(self.ask)
""",
        ADD % 0 + "learner.start('Talker')\nlearner.run(1.0)",
        'failed',
        ('never come to rest',),
    ),
}
