# Exercise 4.1: a patient client
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
