# expect: the third request has its second, too
# rejected by: test_timeout_and_tries
# told by: test_silent_server
# Exercise 4.1: a patient client
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool


class GripperClient(Node):
    def __init__(self, timeout=1.0, tries=3):
        super().__init__('gripper_client')
        self.tries, self.left, self.future = tries, 0, None
        self.client = self.create_client(SetBool, 'set_gripper')
        self.state = self.create_publisher(String, 'gripper_state', 10)
        self.create_subscription(Bool, 'close', self.on_close, 10)
        self.timer = self.create_timer(timeout, self.on_timeout, autostart=False)

    def on_close(self, msg):
        self.request, self.left = SetBool.Request(data=msg.data), self.tries
        self.on_timeout()

    def on_timeout(self):
        self.left -= 1
        self.timer.reset()
        self.future = self.client.call_async(self.request)
        self.future.add_done_callback(self.on_answer)
        if self.left == 0:
            self.report('failed')

    def on_answer(self, future):
        if future is self.future:
            self.report('ok' if future.result().success else 'refused')

    def report(self, text):
        self.timer.cancel()
        self.future = None
        self.state.publish(String(data=text))
