from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('forgets_requests', source='''
from rclpy.callback_groups import ReentrantCallbackGroup
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool


class GripperClient(Node):
    """Gives up a request with remove_pending_request."""

    def __init__(self, timeout=1.0, tries=3):
        super().__init__('gripper_client')
        group = ReentrantCallbackGroup()
        self.tries, self.futures = tries, []
        self.gripper = self.create_client(SetBool, 'set_gripper', callback_group=group)
        self.publisher = self.create_publisher(String, 'gripper_state', 10)
        self.create_subscription(Bool, 'close', self.on_close, 10, callback_group=group)
        self.timer = self.create_timer(timeout, self.on_timer, callback_group=group)
        self.timer.cancel()

    def on_close(self, msg):
        self.forget()
        self.futures = []
        self.data = msg.data
        self.ask()

    def forget(self):
        self.timer.cancel()
        for future in self.futures:
            self.gripper.remove_pending_request(future)

    def ask(self):
        self.forget()
        self.futures.append(self.gripper.call_async(SetBool.Request(data=self.data)))
        self.futures[-1].add_done_callback(self.on_done)
        self.timer.reset()

    def on_timer(self):
        if len(self.futures) == self.tries:
            self.forget()
            self.publisher.publish(String(data='failed'))
        else:
            self.ask()

    def on_done(self, future):
        if not self.timer.is_canceled() and future is self.futures[-1]:
            self.forget()
            self.publisher.publish(String(data=['refused', 'ok'][future.result().success]))
'''),
    Alternative('tickets', source='''
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool


class GripperClient(Node):
    """Each request has a number; timers are made for one use."""

    def __init__(self, timeout=1.0, tries=3):
        super().__init__('gripper_client')
        self.timeout, self.tries, self.ticket, self.clock_ = timeout, tries, 0, None
        self.client = self.create_client(SetBool, 'set_gripper')
        self.state = self.create_publisher(String, 'gripper_state', 10)
        self.create_subscription(Bool, 'close', lambda msg: self.ask(msg.data, self.tries), 10)

    def ask(self, data, tries):
        self.end()
        ticket = self.ticket
        future = self.client.call_async(SetBool.Request(data=data))
        future.add_done_callback(lambda future: self.answered(ticket, future.result().success))
        self.clock_ = self.create_timer(self.timeout, lambda: self.overdue(data, tries - 1))

    def end(self):
        self.ticket += 1
        if self.clock_ is not None:
            self.destroy_timer(self.clock_)
            self.clock_ = None

    def overdue(self, data, tries):
        if tries:
            self.ask(data, tries)
        else:
            self.end()
            self.state.publish(String(data='failed'))

    def answered(self, ticket, success):
        if ticket == self.ticket:
            self.end()
            self.state.publish(String(data='ok' if success else 'refused'))
'''),
    Alternative('await_with_a_timer', source='''
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.task import Future
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool


class GripperClient(Node):
    """Awaits what comes first, the answer or a timer of one shot; needs a reentrant group, as the next command comes."""

    def __init__(self, timeout=1.0, tries=3):
        super().__init__('gripper_client')
        self.timeout, self.tries, self.newest = timeout, tries, 0
        self.group = ReentrantCallbackGroup()
        self.client = self.create_client(SetBool, 'set_gripper', callback_group=self.group)
        self.state = self.create_publisher(String, 'gripper_state', 10)
        self.create_subscription(Bool, 'close', self.on_close, 10, callback_group=self.group)

    async def on_close(self, msg):
        self.newest += 1
        mine = self.newest
        for _ in range(self.tries):
            answer = await self.ask(msg.data)
            if mine != self.newest:
                return
            if answer is not None:
                self.state.publish(String(data='ok' if answer.success else 'refused'))
                return
        self.state.publish(String(data='failed'))

    async def ask(self, data):
        first = Future()

        def done(result):
            if not first.done():
                first.set_result(result)

        timer = self.create_timer(self.timeout, lambda: done(None), callback_group=self.group)
        self.client.call_async(SetBool.Request(data=data)).add_done_callback(lambda future: done(future.result()))
        answer = await first
        self.destroy_timer(timer)
        return answer
'''),
]
