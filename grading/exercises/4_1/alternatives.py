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
]
