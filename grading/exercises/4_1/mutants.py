from grading.variants import Mutant

MUTANTS = [
    Mutant('timeout_of_two_seconds_by_default', breaks='timeout', also=('newest', 'late', 'no-server', 'once'), old='timeout=1.0, tries=3',
           new='timeout=2.0, tries=3', expect='without an argument `timeout` is 1.0'),
    Mutant('two_tries_by_default', breaks='tries', also=('newest', 'once'), old='timeout=1.0, tries=3',
           new='timeout=1.0, tries=2', expect='without an argument `tries` is 3'),
    Mutant('a_minute_at_most', breaks='timeout', old='self.create_timer(timeout, self.on_timeout',
           new='self.create_timer(min(timeout, 60.0), self.on_timeout', expect='failed came 60 s after the request'),
    Mutant('refused_later_asks_again', breaks='refusal', old="self.report('ok' if future.result().success else 'refused')",
           new='''
           if not future.result().success and 0 < self.left < self.tries - 1:
               return self.on_timeout()
           self.report('ok' if future.result().success else 'refused')
           ''', expect='also that of a second request'),
    Mutant('timer_runs_on_after_a_second_try', breaks='once', also=('no-server', 'late', 'timeout'), old='self.timer.cancel()',
           new='''
           if self.left == self.tries - 1 or text == 'failed':
               self.timer.cancel()
           ''', expect='after the report nothing more is sent'),
    Mutant('one_future_for_all_clients', breaks='answer', edits=(
           ('self.tries, self.left, self.future = tries, 0, None', '''
            self.tries, self.left = tries, 0
            GripperClient.future = None
            '''),
           ('self.future = self.client.call_async(self.request)', 'GripperClient.future = self.client.call_async(self.request)'),
           ('self.future = None', 'GripperClient.future = None')),
           expect='in no variable of the class'),
    Mutant('constructor_waits_a_moment', breaks='no-server', old="self.client = self.create_client(SetBool, 'set_gripper')",
           new='''
           self.client = self.create_client(SetBool, 'set_gripper')
           self.client.wait_for_service(timeout_sec=0.2)
           ''', expect='your constructor waits'),
    Mutant('answer_to_the_same_try', breaks='newest', edits=(
        ('self.future.add_done_callback(self.on_answer)', '''
         key = (self.left, self.request.data)
         self.future.add_done_callback(lambda future: self.on_answer(future, key))
         '''),
        ('def on_answer(self, future):', 'def on_answer(self, future, key):'),
        ('if future is self.future:', 'if self.future is not None and key == (self.left, self.request.data):')),
        expect='also if both have the same data'),
    Mutant('waits_for_the_service', breaks='no-server', old='self.future = self.client.call_async(self.request)', new='''
        self.client.wait_for_service(timeout_sec=0.2)
        self.future = self.client.call_async(self.request)
        ''', expect='a callback waits for it'),
    Mutant('nobody_is_no_try', breaks='no-server', old='self.future = self.client.call_async(self.request)', new='''
        if not self.client.service_is_ready():
            self.left += 1
            return
        self.future = self.client.call_async(self.request)
        ''', expect='to nobody counts as one without an answer'),
    Mutant('absolute_close', breaks='names', old="self.create_subscription(Bool, 'close', self.on_close, 10)",
           new="self.create_subscription(Bool, '/close', self.on_close, 10)", expect='without a leading slash'),
    Mutant('absolute_service', breaks='names', old="'set_gripper')", new="'/set_gripper')",
           expect='without a leading slash'),
    Mutant('accepts_late_answers', breaks='late', also='newest', old='if future is self.future:', new='if True:',
           expect='what comes after its timeout is ignored'),
    Mutant('always_closes', breaks='request', also='newest', old='SetBool.Request(data=msg.data)',
           new='SetBool.Request(data=True)', expect='send the same data'),
    Mutant('always_three', breaks='tries', old='self.tries, self.left, self.future = tries, 0, None',
           new='self.tries, self.left, self.future = 3, 0, None', expect='is the number of all requests'),
    Mutant('call_in_callback', breaks='request', also=('answer', 'late', 'newest', 'no-server', 'queue', 'once',
                                                       'refusal', 'names'),
           edits=(('self.future = self.client.call_async(self.request)', 'answer = self.client.call(self.request)'),
            ('self.future.add_done_callback(self.on_answer)', "self.report('ok' if answer.success else 'refused')")),
           expect='A callback waits for an answer'),
    Mutant('counter_runs_on', breaks='newest', also=('tries', 'no-server'),
           old='self.request, self.left = SetBool.Request(data=msg.data), self.tries', new='''
           self.request = SetBool.Request(data=msg.data)
           self.left = self.left if self.left > 0 else self.tries
           ''', expect='A new command has all its tries'),
    Mutant('depth_1', breaks='queue', old="'close', self.on_close, 10)", new="'close', self.on_close, 1)",
           expect='1 of them became requests, expected 10'),
    Mutant('fails_at_last_request', breaks='tries', edits=(('''
            if self.left < 0:
                return self.report('failed')
            ''', ''),
            ('self.future.add_done_callback(self.on_answer)', '''
            self.future.add_done_callback(self.on_answer)
            if self.left == 0:
                self.report('failed')
            ''')), also=('late', 'newest', 'once', 'timeout', 'no-server'), expect='s, too'),
    Mutant('ignores_new_command', breaks='newest', also=('queue', 'request'), old='def on_close(self, msg):', new='''
        def on_close(self, msg):
            if self.future:
                return
        ''', expect='Send a new command at once, also if an old one is open'),
    Mutant('late_after_failed', breaks='late', edits=(('if future is self.future:',
                                                       'if self.future in (future, None) and not self.done:'),
           ('self.timer.cancel()', '''
            self.timer.cancel()
            self.done = text != 'failed'
            '''), ('self.on_timeout()', '''
            self.done = False
            self.on_timeout()
            ''')), expect='All answers came 3.4 s after'),
    Mutant('no_cancel', breaks='once', also=('late', 'refusal', 'newest', 'tries', 'answer', 'no-server'),
           old='self.timer.cancel()', new='', expect='stop the timer when the answer has come'),
    Mutant('one_more_try', breaks='tries', also=('late', 'newest', 'once', 'no-server'), old='if self.left < 0:',
           new='if self.left < -1:', expect='the first one included'),
    Mutant('other_name', breaks='names', old="super().__init__('gripper_client')", new="super().__init__('gripper')",
           expect='your node is called'),
    Mutant('one_try_is_two', breaks='tries', old='SetBool.Request(data=msg.data), self.tries',
           new='SetBool.Request(data=msg.data), max(self.tries, 2)', expect='2 requests came, expected one'),
    Mutant('pause_between_tries', breaks='timeout', also=('late', 'newest', 'no-server', 'tries', 'once'),
           old='self.on_timeout, autostart=False)', new='self.on_tick, autostart=False)',
           edits=(('def on_answer(self, future):', '''
        def on_tick(self):
            self.waited = not getattr(self, 'waited', False)
            if not self.waited:
                self.on_timeout()

        def on_answer(self, future):
            '''),), expect='expected at'),
    Mutant('queues_commands', breaks='newest', also=('queue', 'request'), old='def on_close(self, msg):', new='''
        def on_close(self, msg):
            if self.future:
                self.waiting = msg
                return
        ''', edits=(('self.state.publish(String(data=text))', '''
            self.state.publish(String(data=text))
            if getattr(self, 'waiting', None):
                msg, self.waiting = self.waiting, None
                self.on_close(msg)
            '''),), expect='Send a new command at once, also if an old one is open'),
    Mutant('refused_is_failed', breaks='answer', also=('late', 'newest', 'refusal'), old="else 'refused')", new="else 'failed')",
           expect="expected ['refused']"),
    Mutant('reports_dropped', breaks='newest', also=('queue', 'once'), old='def on_close(self, msg):', new='''
        def on_close(self, msg):
            if self.future:
                self.report('failed')
        ''', expect='nothing is reported for the old command'),
    Mutant('reports_old_command', breaks='newest', also='late', old='if future is self.future:', new='if self.future:',
           expect='nothing is reported for the old command'),
    Mutant('reports_twice', breaks='once', also=('late', 'newest', 'answer', 'names', 'no-server'),
           old="self.report('ok' if future.result().success else 'refused')", new='''
        self.report('ok' if future.result().success else 'refused')
        self.report('ok' if future.result().success else 'refused')
        ''', expect='expected one of each'),
    Mutant('retries_refusal', breaks='refusal', also=('answer', 'late', 'newest', 'once'),
           old="self.report('ok' if future.result().success else 'refused')", new='''
        if future.result().success:
            self.report('ok')
        elif self.left:
            self.on_timeout()
        else:
            self.report('refused')
        ''', expect='a refusal is an answer, do not try again'),
    Mutant('same_data_ignored', breaks='request', also=('answer', 'newest', 'queue', 'once'),
           old='def on_close(self, msg):', new='''
        def on_close(self, msg):
            if msg.data is getattr(self, 'last', None):
                return
            self.last = msg.data
        ''', expect='the next one made no request'),
    Mutant('second_is_constant', breaks='timeout', also=('tries', 'refusal'), old='self.create_timer(timeout, self.on_timeout,',
           new='self.create_timer(1.0, self.on_timeout,', expect='expected at'),
    Mutant('success_is_text', breaks='answer', also=('late', 'newest', 'refusal'), old="'ok' if future.result().success else",
           new="'ok' if future.result() else", expect="expected ['refused']"),
    Mutant('timer_runs_on', breaks='newest', also=('refusal', 'timeout', 'once', 'tries', 'late'), old='self.timer.reset()',
           new='''
        if self.timer.is_canceled():
            self.timer.reset()
        ''', expect='start the timer anew'),
    Mutant('waits_a_second', breaks='no-server', old="self.client = self.create_client(SetBool, 'set_gripper')",
           new='''
        self.client = self.create_client(SetBool, 'set_gripper')
        self.client.wait_for_service(timeout_sec=1.0)
        ''', expect='must not wait for the service'),
    Mutant('waits_for_service', breaks='no-server', also='names',
           old="self.client = self.create_client(SetBool, 'set_gripper')", new='''
        self.client = self.create_client(SetBool, 'set_gripper')
        self.client.wait_for_service()
        ''', expect='did not return within'),
    Mutant('spins_in_callback', breaks='request', also=('answer', 'late', 'newest', 'no-server', 'queue', 'once',
                                                        'refusal', 'names', 'timeout', 'tries'), source='''
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool


class GripperClient(Node):
    def __init__(self, timeout=1.0, tries=3):
        super().__init__('gripper_client')
        self.timeout, self.tries = timeout, tries
        self.client = self.create_client(SetBool, 'set_gripper')
        self.state = self.create_publisher(String, 'gripper_state', 10)
        self.create_subscription(Bool, 'close', self.on_close, 10)

    def on_close(self, msg):
        for _ in range(self.tries):
            future = self.client.call_async(SetBool.Request(data=msg.data))
            rclpy.spin_until_future_complete(self, future, timeout_sec=self.timeout)
            if future.done():
                self.state.publish(String(data='ok' if future.result().success else 'refused'))
                return
        self.state.publish(String(data='failed'))
''', expect='A callback spins'),
    Mutant('awaits_without_end', breaks='timeout', also=('answer', 'late', 'newest', 'no-server', 'queue', 'once',
                                                         'request', 'tries', 'names'), source='''
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool


class GripperClient(Node):
    def __init__(self, timeout=1.0, tries=3):
        super().__init__('gripper_client')
        self.tries = tries
        self.client = self.create_client(SetBool, 'set_gripper')
        self.state = self.create_publisher(String, 'gripper_state', 10)
        self.create_subscription(Bool, 'close', self.on_close, 10)

    async def on_close(self, msg):
        for _ in range(self.tries):
            answer = await self.client.call_async(SetBool.Request(data=msg.data))
            if answer is not None:
                self.state.publish(String(data='ok' if answer.success else 'refused'))
                return
        self.state.publish(String(data='failed'))
''', expect='no second request came'),
    Mutant('sleeps_in_callback', breaks='timeout', also=('answer', 'late', 'newest', 'no-server', 'queue', 'once',
                                                         'refusal', 'request', 'names', 'tries'), source='''
import time

from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool


class GripperClient(Node):
    def __init__(self, timeout=1.0, tries=3):
        super().__init__('gripper_client')
        self.timeout, self.tries = timeout, tries
        self.client = self.create_client(SetBool, 'set_gripper')
        self.state = self.create_publisher(String, 'gripper_state', 10)
        self.create_subscription(Bool, 'close', self.on_close, 10)

    def on_close(self, msg):
        for _ in range(self.tries):
            future = self.client.call_async(SetBool.Request(data=msg.data))
            time.sleep(0.2)
            if future.done():
                self.state.publish(String(data='ok' if future.result().success else 'refused'))
                return
        self.state.publish(String(data='failed'))
''', expect='A callback sleeps'),
    Mutant('late_refusals_count', breaks='late', old='if future is self.future:',
           new='if future is self.future or self.future and not future.result().success:', also='newest',
           expect='Until the next command gripper_state said'),
    Mutant('fails_once', breaks='tries', also=('late', 'newest'), old="return self.report('failed')", new="""
            self.failed, known = True, getattr(self, 'failed', False)
            return self.timer.cancel() if known else self.report('failed')
            """, expect='gripper_state said'),
    Mutant('half_a_second_at_least', breaks='timeout', old='self.create_timer(timeout, self', new='self.create_timer(max(timeout, 0.5), self',
           also='tries', expect='requests at'),
    Mutant('ten_tries_at_most', breaks='tries', also='no-server', old='self.tries, self.left, self.future = tries, 0, None',
           new='self.tries, self.left, self.future = min(tries, 10), 0, None', expect='`tries` may be any number'),
    Mutant('ten_seconds_at_most', breaks='timeout', also=('tries', 'request'), old='self.create_timer(timeout, self',
           new='self.create_timer(min(timeout, 10.0), self', expect='failed came 10 s after the request'),
    Mutant('forty_commands_at_most', breaks='request', old='    def on_close(self, msg):', new='''
    def on_close(self, msg):
        self.count = getattr(self, 'count', 0) + 1
        if self.count > 40:
            return
''', expect='however many there were before'),
    Mutant('twenty_five_reports_at_most', breaks='answer', old='self.state.publish(String(data=text))', new='''
        self.count = getattr(self, 'count', 0) + 1
        if self.count <= 25:
            self.state.publish(String(data=text))
''', expect='each command is reported'),
    Mutant('state_in_the_class', old='self.state = ', new='GripperClient.state = ', breaks='answer',
           expect='came on /other/gripper_state'),
    Mutant('client_in_the_class', old='self.client = ', new='GripperClient.client = ', breaks='request',
           expect='came on /other/set_gripper'),
    Mutant('tries_in_the_class', edits=(('self.tries, self.left, self.future = tries, 0, None',
                                         'GripperClient.tries, self.left, self.future = tries, 0, None'),),
           breaks='tries', expect='as many as the `tries` of the other one'),
    Mutant('timer_runs_from_the_start', old='self.on_timeout, autostart=False)', new='self.on_timeout)', breaks='once',
           expect='before any command'),
    Mutant('answer_is_not_looked_at', old='self.future.add_done_callback(self.on_answer)', new='', breaks='answer',
           also=('refusal', 'newest', 'no-server', 'late', 'names'), expect='has the future of each request a done-callback'),
    Mutant('left_in_the_class', breaks='tries', also=('timeout', 'answer'), edits=(
        ('self.tries, self.left, self.future = tries, 0, None', 'self.tries, self.future = tries, None'),
        ('self.request, self.left = SetBool.Request(data=msg.data), self.tries',
         'self.request, GripperClient.left = SetBool.Request(data=msg.data), self.tries'),
        ('self.left -= 1', 'GripperClient.left -= 1')), expect='is kept in the class'),
    Mutant('future_in_the_class', breaks='answer', edits=(
        ('self.tries, self.left, self.future = tries, 0, None', """
         self.tries, self.left = tries, 0
         GripperClient.future = None
         """),
        ('self.future = self.client.call_async(self.request)', 'future = GripperClient.future = self.client.call_async(self.request)'),
        ('self.future.add_done_callback(self.on_answer)', 'future.add_done_callback(self.on_answer)'),
        ('if future is self.future:', 'if future is GripperClient.future:'),
        ('self.future = None', 'GripperClient.future = None')), expect='in no variable of the class'),
    Mutant('request_in_the_class', breaks='request', old='self.request, self.left', new='GripperClient.request, self.left',
           expect='the other one had the command'),
    Mutant('timer_in_the_class', breaks='tries', also=('timeout', 'answer', 'once'), old='self.timer = self.create_timer',
           new='GripperClient.timer = self.create_timer', expect='is kept in the class'),
    Mutant('timeout_in_tenths', breaks='timeout', also=('tries', 'request'), old='self.create_timer(timeout,',
           new='self.create_timer(round(timeout, 1),', expect='expected at'),
    Mutant('believes_the_message', breaks='answer', also=('refusal', 'once'),
           old="'ok' if future.result().success else 'refused'", expect="and the message 'ok'",
           new="'ok' if future.result().success or future.result().message == 'ok' else 'refused'"),
    Mutant('believes_a_message_that_says_no', breaks='answer', also=('late', 'once'), old="'ok' if future.result().success else 'refused'",
           new="'ok' if future.result().success and future.result().message != 'refused' else 'refused'",
           expect="and the message 'refused'"),
    Mutant('twenty_tries_at_most', breaks='tries', also='no-server', old='self.tries, self.left, self.future = tries, 0, None',
           new='self.tries, self.left, self.future = min(tries, 20), 0, None', expect='`tries` may be any number'),
    Mutant('nobody_is_no_first_try', breaks='no-server', old='self.request, self.left = SetBool.Request(data=msg.data), self.tries', new="""
        self.request, self.left = SetBool.Request(data=msg.data), self.tries
        if not self.client.service_is_ready():
            return self.timer.reset()
        """, expect='the first one, too'),
    Mutant('keeps_the_last_try', breaks='newest', also=('request', 'tries'), old='self.request, self.left = SetBool.Request(data=msg.data), self.tries', new="""
        if self.future is not None and self.left == 0 and self.request.data is msg.data:
            return
        self.request, self.left = SetBool.Request(data=msg.data), self.tries
        """, expect='A new command has all its tries'),
]
