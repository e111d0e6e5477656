from grading.variants import Mutant

LOST = "self.timer = self.create_timer(1.0, lambda: self.finish('lost', self.numbers))"
CANCEL = 'self.goal.cancel_goal_async().add_done_callback(lambda future: self.timer.cancel())'
STATUS = 'STATUS[future.result().status]'
CLIENT = "self.client = ActionClient(self, Fibonacci, 'fibonacci')"
ENDS = 'test_outcomes'
LATE = 'test_server_comes_late'
ALL = ('send', 'word', 'numbers', 'deadline', 'result', 'lost', 'once', 'names', 'at-once')

MUTANTS = [
    Mutant('one_minute_is_enough', breaks='deadline', old='self.create_timer(self.patience, self.give_up)',
           new='self.create_timer(min(self.patience, 60.0), self.give_up)',
           expect='s after the goal was accepted'),
    Mutant('waits_a_minute_for_the_result', breaks='result', edits=(
           ('self.goal.cancel_goal_async().add_done_callback(lambda future: self.timer.cancel())',
            'self.goal.cancel_goal_async().add_done_callback(self.on_cancelled)'),
           ('def finish(self, word, numbers):', '''
           def on_cancelled(self, future):
               self.timer.cancel()
               self.timer = self.create_timer(60.0, lambda: self.finish('lost', self.numbers))

           def finish(self, word, numbers):
           ''')), expect='before the result was there'),
    Mutant('ten_numbers_of_the_feedback', breaks='numbers', also='lost',
           old='self.numbers = message.feedback.sequence', new='self.numbers = message.feedback.sequence[:10]',
           expect="expected 'lost [0, "),
    Mutant('feedback_of_all_goals', breaks='numbers', edits=((
           'Fibonacci.Goal(order=self.order), self.on_feedback)', 'Fibonacci.Goal(order=self.order))'),
           ('self.timer = self.create_timer(0.1, self.send)', '''
            self.timer = self.create_timer(0.1, self.send)
            self.create_subscription(
                Fibonacci.Impl.FeedbackMessage, 'fibonacci/_action/feedback', self.on_feedback, 10)
            ''')), expect='another client has a goal with the same server'),
    Mutant('ten_times_feedback', breaks='numbers', also='lost', old='self.numbers = message.feedback.sequence', new="""
        self.heard = getattr(self, 'heard', 0) + 1
        if self.heard <= 10:
            self.numbers = message.feedback.sequence
        """, expect='The numbers are those of the last feedback'),
    Mutant('longest_feedback', breaks='numbers', old='self.numbers = message.feedback.sequence',
           new='self.numbers = max(self.numbers, message.feedback.sequence, key=len)',
           expect='also if there was a longer one before'),
    Mutant('numbers_of_the_first_three', breaks='numbers', old='self.numbers = message.feedback.sequence',
           new='self.numbers = message.feedback.sequence[:3]', expect='The numbers are those of the last feedback'),
    Mutant('at_most_two_seconds', breaks='deadline', also=('result', 'numbers'),
           old='self.timer = self.create_timer(self.patience, self.give_up)',
           new='self.timer = self.create_timer(min(self.patience, 2.0), self.give_up)',
           expect='the cancel request came 2.00 s after the goal was accepted'),
    Mutant('no_deadline_of_0_s', breaks='deadline', old='self.timer = self.create_timer(self.patience, self.give_up)',
           new='''
        if self.patience:
            self.timer = self.create_timer(self.patience, self.give_up)
        ''', expect='With a patience of 0 s it asks to cancel at once'),
    Mutant('stops_looking', breaks='send', old='if self.client.server_is_ready():', new='''
        self.looks = getattr(self, 'looks', 0) + 1
        if self.looks == 250:
            self.timer.cancel()
        elif self.client.server_is_ready():
        ''', expect='until it is there, however long that takes'),
    Mutant('no_order_above_46', old='order=self.order', new='order=min(self.order, 46)', expect='a goal of the order 46 came',
           breaks='send'),
    Mutant('sends_until_accepted', breaks='send', old="return self.finish('rejected', [])", new='''
           if not self.said:
               self.outcome.publish(String(data='rejected []'))
           self.said = True
           return self.timer.reset()
           ''', expect='a goal that was rejected is not sent again'),
    Mutant('looks_every_0_2_s', breaks='send', old='self.create_timer(0.1, self.send)',
           new='self.create_timer(0.2, self.send)', expect='look every 0.1 s'),
    Mutant('looks_every_0_05_s', breaks='send', old='self.create_timer(0.1, self.send)',
           new='self.create_timer(0.05, self.send)', expect='not more often'),
    Mutant('abort_after_lost', breaks='once', old='if not self.said:', new="if not self.said or word == 'aborted':",
           expect='One outcome is enough'),
    Mutant('absolute_action', breaks='names', also='at-once', old="Fibonacci, 'fibonacci')",
           new="Fibonacci, '/fibonacci')", expect='without a leading slash'),
    Mutant('absolute_outcome', breaks='names', old="String, 'outcome', 10", new="String, '/outcome', 10",
           expect='without a leading slash'),
    Mutant('believes_the_request', breaks='result', also='lost', old=STATUS,
           new=f"'canceled' if self.timer.is_canceled() else {STATUS}", expect='A cancel request is only a request'),
    Mutant('constant_patience', breaks='deadline', also=('lost', 'result', 'names', 'numbers'),
           old='self.create_timer(self.patience, self.give_up)', new='self.create_timer(2.0, self.give_up)',
           expect='cancel request'),
    Mutant('deadline_from_sending', breaks='deadline', also=('lost', 'once', 'result'), edits=((
           '''
           if self.client.server_is_ready():
               self.timer.cancel()
           ''', '''
           if self.client.server_is_ready():
               self.timer.cancel()
               self.sent = self.get_clock().now()
           '''), ('self.create_timer(self.patience, self.give_up)', 'self.create_timer(max(0.001, self.patience - '
                  '(self.get_clock().now() - self.sent).nanoseconds / 1e9), self.give_up)')),
           expect='The deadline begins when the goal is accepted'),
    Mutant('deadline_goes_on', breaks='deadline', also='lost', old='''
        def finish(self, word, numbers):
            self.timer.cancel()
        ''', new='''
        def finish(self, word, numbers):
            if word == 'lost':
                self.timer.cancel()
        ''', expect='a cancel request came for a goal that had ended in time'),
    Mutant('does_not_wait_for_result', breaks='result', also=('lost', 'once', 'numbers', 'names', 'deadline'), edits=(
           (LOST, 'self.goal.cancel_goal_async()'), (CANCEL, "self.finish('canceled', self.numbers)")),
           expect='wait for the result, which also a cancelled goal has'),
    Mutant('feedback_is_wrapped', breaks='send', also=ALL, old='.feedback.sequence', new='.sequence',
           expect="has no attribute 'sequence'"),
    Mutant('long_second_deadline', breaks='lost', also='deadline', old='self.create_timer(1.0, lambda:',
           new='self.create_timer(2.0, lambda:', expect='nothing came on /outcome'),
    Mutant('lost_without_numbers', breaks='numbers', also='lost', old="self.finish('lost', self.numbers)",
           new="self.finish('lost', [])", expect="expected 'lost [0"),
    Mutant('many_goals', breaks='send', also=('lost', 'once', 'deadline'), edits=(('''
            if self.client.server_is_ready():
                self.timer.cancel()
            ''', '''
            if self.client.server_is_ready():
            '''), ('self.goal = future.result()', '''
            self.timer.cancel()
            self.goal = future.result()
            ''')), expect='stop looking for the server when the goal is sent'),
    Mutant('numbers_of_feedback', breaks='numbers', also=('result', 'word', 'names', 'once', 'send'),
           old='future.result().result.sequence', new='self.numbers', expect='/outcome said'),
    Mutant('feedback_for_an_empty_result', breaks='numbers', old='future.result().result.sequence',
           new='future.result().result.sequence or self.numbers', expect="expected 'aborted []'"),
    Mutant('only_stops_waiting', breaks='deadline', also=('lost', 'once', 'result', 'numbers', 'names'), old=f'''
        {LOST}
        {CANCEL}
        ''', new="self.finish('canceled', self.numbers)", expect='To stop waiting is not enough'),
    Mutant('order_is_constant', breaks='send', also=ALL, old='Fibonacci.Goal(order=self.order)',
           new='Fibonacci.Goal(order=20)', expect='goals of the orders'),
    Mutant('other_name', breaks='names', old="super().__init__('patient_client')", new="super().__init__('client')",
           expect='your node is called'),
    Mutant('refused_is_lost', breaks='result', old='lambda future: self.timer.cancel())',
           new='lambda future: future.result().goals_canceling and self.timer.cancel())',
           expect='A cancel request is only a request'),
    Mutant('result_of_rejected', breaks='word', also=('send', 'once', 'numbers'), edits=(('''
            if not self.goal.accepted:
                return self.finish('rejected', [])
            ''', ''), ('[future.result().status]', ".get(future.result().status, 'unknown')")),
           expect='is none of the words'),
    Mutant('second_outcome', breaks='once', also='deadline', old='if not self.said:', new='if True:',
           expect='One outcome is enough'),
    Mutant('sends_at_once', breaks='send', also=('at-once', 'names', 'deadline'),
           old='if self.client.server_is_ready():', new='if True:', expect='no goal came'),
    Mutant('slow_look', breaks='send', also=('deadline', 'lost', 'numbers'), old='self.create_timer(0.1, self.send)',
           new='self.create_timer(1.0, self.send)', expect='no goal came within 0.3 s'),
    Mutant('success_whatever_happens', breaks='word', also=('result', 'once', 'names', 'lost'), old=STATUS,
           new="'succeeded'", expect='The status stands beside the result'),
    Mutant('text_of_an_array', breaks='word', also=('numbers', 'result', 'send', 'names', 'lost', 'once'),
           old='{list(numbers)}', new='{numbers}', expect='/outcome said'),
    Mutant('waits_for_ever', breaks='lost', also='deadline', old=f'''
        {LOST}
        {CANCEL}
        ''', new='self.goal.cancel_goal_async()', expect='was not answered within 1 s'),
    Mutant('waits_a_second', breaks='at-once', also=ALL, old=CLIENT, new=f'''
        {CLIENT}
        self.client.wait_for_server(timeout_sec=1.0)
        ''', expect='must not wait for the server'),
    Mutant('waits_in_a_callback', breaks='at-once', also=ALL, old='if self.client.server_is_ready():',
           new='if self.client.wait_for_server(timeout_sec=0.05):', expect='in `wait_for_server`'),
    Mutant('waits_in_constructor', breaks='at-once', also=ALL, old=CLIENT, new=f'''
        {CLIENT}
        self.client.wait_for_server()
        ''', expect='did not return within'),
    Mutant('sorted_numbers', old='{list(numbers)}', new='{sorted(numbers)}', breaks='numbers', also=('word', 'result'),
           expect='expected'),
    Mutant('written_in_another_way', old="f'{word} {list(numbers)}'",
           new="f'{word} {list(numbers)}'.replace('canceled', 'cancelled')", breaks='word', also=('result', 'names'),
           expect='`cancelled` is none of the words'),
    Mutant('says_that_it_waits', breaks='once', old="self.outcome = self.create_publisher(String, 'outcome', 10)", new="""
        self.outcome = self.create_publisher(String, 'outcome', 10)
        self.outcome.publish(String(data='waiting []'))
        """, expect='what goes out in the constructor, hardly anybody can hear'),
    Mutant('cancels_once_more_when_lost', breaks='deadline', old='if not self.said:', new="""
        if not self.said and word == 'lost':
            self.goal.cancel_goal_async()
        if not self.said:
        """, also='lost', expect='2 cancel requests came'),
    Mutant('feedback_counts_from_acceptance_on', breaks='numbers', old='self.numbers = message.feedback.sequence', new="""
        if hasattr(self, 'goal'):
            self.numbers = message.feedback.sequence
        """, expect='also what comes before it is accepted'),
    Mutant('tells_early_feedback', breaks='once', old='self.numbers = message.feedback.sequence', new="""
        self.numbers = message.feedback.sequence
        if not hasattr(self, 'goal'):
            self.outcome.publish(String(data=f'early {list(self.numbers)}'))
        """, expect='when this feedback came'),
    Mutant('goal_in_the_class', breaks='deadline', also=('numbers', 'once'), edits=(
           ('self.goal = future.result()', 'goal = PatientClient.goal = future.result()'),
           ('if not self.goal.accepted:', 'if not goal.accepted:'),
           ('self.goal.get_result_async()', 'goal.get_result_async()'),
           ('self.goal.cancel_goal_async()', 'PatientClient.goal.cancel_goal_async()')),
           expect='is kept in the class'),
    Mutant('numbers_in_the_class', breaks='numbers', edits=(
           ("self.finish('lost', self.numbers)", "self.finish('lost', PatientClient.numbers)"),
           ('self.order, self.patience, self.numbers, self.said = order, patience, [], False', """
            self.order, self.patience, self.said = order, patience, False
            PatientClient.numbers = []
            """), ('self.numbers = message.feedback.sequence', 'PatientClient.numbers = message.feedback.sequence')),
           expect='not those of the goal of the other one'),
    Mutant('order_in_the_class', breaks='send', old='self.order, self.patience, self.numbers',
           new='PatientClient.order, self.patience, self.numbers', expect='sent goals of the orders'),
    Mutant('patience_in_the_class', breaks='deadline', also='numbers', old='self.order, self.patience, self.numbers',
           new='self.order, PatientClient.patience, self.numbers', expect='as when it is alone'),
    Mutant('outcome_in_the_class', breaks='once', old='self.outcome = ', new='PatientClient.outcome = ',
           expect='came on /other/outcome'),
    Mutant('client_in_the_class', breaks='send', old='self.client = ', new='PatientClient.client = ',
           expect='came on /other/fibonacci'),
    Mutant('patience_in_tenths', breaks='deadline', also='numbers', old='self.create_timer(self.patience,',
           new='self.create_timer(round(self.patience, 1),', expect='s after the goal was accepted'),
    Mutant('each_number_once', breaks='numbers', also='result',
           old='STATUS[future.result().status], future.result().result.sequence))',
           new='STATUS[future.result().status], dict.fromkeys(future.result().result.sequence)))',
           expect='/outcome said'),
    Mutant('without_signs', breaks='numbers', also=('result', 'word'), old='{list(numbers)}',
           new='{[abs(number) for number in numbers]}', expect='/outcome said'),
    Mutant('numbers_in_a_byte', breaks='numbers', also=('result', 'word'), old='{list(numbers)}',
           new='{[number % 256 for number in numbers]}', expect='/outcome said'),
    *[Mutant(f'tries_again_when_{word}', breaks='send', also=('once', 'deadline', 'numbers'), old="""
        def finish(self, word, numbers):
            self.timer.cancel()
        """, new=f"""
        def finish(self, word, numbers):
            self.timer.cancel()
            if word == '{word}' and not self.said:
                self.timer = self.create_timer(0.1, self.send)
        """, expect=f'has the outcome {word} is not sent again') for word in ('lost', 'aborted', 'canceled')],
    Mutant('cancels_what_was_aborted', breaks='deadline', old="""
        def finish(self, word, numbers):
            self.timer.cancel()
        """, new="""
        def finish(self, word, numbers):
            if word != 'aborted':
                self.timer.cancel()
        """, expect='stop the timer of the deadline when the result has come'),
    Mutant('canceled_by_itself_only', breaks='word', edits=(
           (f'{STATUS}, future', f"{STATUS} if self.asked or future.result().status != 5 else 'aborted', future"),
           ('self.order, self.patience, self.numbers, self.said = order, patience, [], False', """
            self.order, self.patience, self.numbers, self.said = order, patience, [], False
            self.asked = False
            """), ("""
            def give_up(self):
                self.timer.cancel()
            """, """
            def give_up(self):
                self.timer.cancel()
                self.asked = True
            """)), expect='somebody else'),
    Mutant('ten_seconds_for_the_answer', breaks='word', also=('deadline', 'numbers'), edits=(
           ('future.add_done_callback(self.on_answer)', """
            future.add_done_callback(self.on_answer)
            self.timer = self.create_timer(10.0, lambda: self.finish('rejected', []))
            """), ('self.goal = future.result()', """
            self.timer.cancel()
            self.goal = future.result()
            """)), expect='has not rejected the goal'),
]
